#include "client/cli/outputs.h"

#include <google/protobuf/util/json_util.h>

#include <stdexcept>

#include "client/cli/cloud.h"
#include "client/cli/files.h"
#include "client/cli/labels.h"
#include "client/cli/overlay.h"
#include "client/cli/steps.h"

namespace fovea::cli {
namespace {

void WriteSaliency(const std::string& prefix, const v1::Detections& detections) {
  for (const v1::SaliencyMap& map : detections.saliency_maps()) {
    if (map.data().size() != std::size_t{map.width()} * map.height()) {
      throw std::runtime_error("the server's answer has a broken saliency map");
    }
    const cv::Mat image(static_cast<int>(map.height()), static_cast<int>(map.width()), CV_8UC1,
                        const_cast<char*>(map.data().data()));
    WriteImage(prefix + "_" + map.name() + ".png", image);
  }
}

}  // namespace

std::string ToJson(const v1::Detections& detections) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(detections, &json, options);
  if (!status.ok()) throw std::runtime_error("the answer cannot be written as JSON");
  return json;
}

void RequestFor(const OutputPaths& paths, v1::DetectOptions* options) {
  const bool draws = !paths.overlay.empty(), explains = !paths.steps.empty();
  options->set_return_masks(draws || explains || !paths.labels.empty() || !paths.cloud.empty() ||
                            !paths.json.empty());
  options->set_return_seeds(draws || !paths.json.empty());
  options->set_return_saliency_maps(explains || !paths.saliency_prefix.empty());
  options->set_return_trace(explains);
  options->set_return_rejected(explains || !paths.json.empty());
}

void WriteOutputs(const OutputPaths& paths, const FrameFiles& files, const FrameSettings& settings,
                  const v1::DetectRequest& request, const v1::Detections& detections) {
  if (!paths.saliency_prefix.empty()) WriteSaliency(paths.saliency_prefix, detections);
  if (!paths.labels.empty()) WriteImage(paths.labels, LabelImage(detections));
  if (!paths.json.empty()) {
    v1::Detections answer = detections;
    answer.clear_saliency_maps();  // they have files of their own
    answer.clear_trace();
    WriteFile(paths.json, ToJson(answer));
  }
  if (paths.overlay.empty() && paths.cloud.empty() && paths.steps.empty()) return;

  const cv::Mat color = DecodeColor(request.frame().color().data(), files.color_path);
  if (!paths.overlay.empty()) {
    WriteImage(paths.overlay, DrawOverlay(color, settings.intrinsics, detections));
  }
  if (paths.cloud.empty() && paths.steps.empty()) return;
  const cv::Mat depth = DecodeDepth(request.frame().depth().data(), files.depth_path);
  if (!paths.steps.empty()) WriteSteps(paths.steps, color, depth, settings, detections);
  if (!paths.cloud.empty()) {
    WriteFile(paths.cloud,
              MakePly(color, PointsInColor(depth, settings, color.size()), LabelImage(detections)));
  }
}

}  // namespace fovea::cli
