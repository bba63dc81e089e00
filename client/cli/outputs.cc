#include "client/cli/outputs.h"

#include <stdexcept>

#include "client/cli/cloud.h"
#include "client/cli/endings.h"
#include "client/cli/files.h"
#include "client/cli/height_picture.h"
#include "client/cli/json.h"
#include "client/cli/labels.h"
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

void WriteCloud(const std::string& path, const cv::Mat& color, const cv::Mat& depth,
                const FrameSettings& settings, const v1::Detections& detections) {
  std::vector<CloudPoint> cloud =
      TintedCloud(color, PointsInColor(depth, settings, color.size()), detections);
  const std::vector<CloudPoint> dots = DotsOf(detections);
  cloud.insert(cloud.end(), dots.begin(), dots.end());
  WriteFile(path, LowerEnding(path) == ".pcd" ? MakePcd(cloud) : MakePly(cloud));
}

void WritePictures(const Outputs& outputs, const FrameFiles& files, const FrameSettings& settings,
                   const v1::DetectRequest& request, const v1::Detections& detections) {
  if (outputs.overlay.empty() && outputs.cloud.empty() && outputs.steps.empty()) return;
  const bool was_sent = files.sent_before != nullptr;  // perhaps as bytes that are no file
  const cv::Mat color =
      DecodeColor(was_sent ? files.read_color() : request.frame().color().data(), files.color_path);
  if (!outputs.overlay.empty()) {
    WriteImage(outputs.overlay,
               DrawOverlay(color, settings.intrinsics, detections, outputs.extras));
  }
  if (outputs.cloud.empty() && outputs.steps.empty()) return;
  const cv::Mat depth =
      DecodeDepth(was_sent ? files.read_depth() : request.frame().depth().data(), files.depth_path);
  if (!outputs.steps.empty()) WriteSteps(outputs.steps, color, depth, settings, detections);
  if (!outputs.cloud.empty()) WriteCloud(outputs.cloud, color, depth, settings, detections);
}

// What has files of its own is left out.
v1::Detections ForJson(const Outputs& outputs, const v1::Detections& detections) {
  v1::Detections answer = detections;
  answer.clear_saliency_maps();
  answer.clear_trace();
  if (!outputs.json_masks) {
    for (v1::Object& object : *answer.mutable_objects()) object.clear_mask();
  }
  return answer;
}

}  // namespace

void RequestForPictures(const Outputs& outputs, v1::DetectOptions* options) {
  Outputs pictures = outputs;
  pictures.json.clear();
  RequestFor(pictures, options);
}

void RequestFor(const Outputs& outputs, v1::DetectOptions* options) {
  const bool draws = !outputs.overlay.empty(), explains = !outputs.steps.empty();
  const bool tells = !outputs.json.empty();
  options->set_return_masks(draws || explains || !outputs.labels.empty() ||
                            !outputs.cloud.empty() || (tells && outputs.json_masks));
  options->set_return_seeds(tells || (draws && outputs.extras.seeds));
  options->set_return_saliency_maps(explains || !outputs.saliency_prefix.empty() ||
                                    (draws && outputs.extras.saliency));
  options->set_return_trace(explains);
  if (!outputs.height_map.empty()) options->mutable_planning()->mutable_height_map();
  if (draws && outputs.extras.collisions) {
    options->mutable_planning()->set_collision_primitives(true);
  }
  options->set_return_rejected(explains || tells || (draws && outputs.extras.rejected));
}

void WriteOutputs(const Outputs& outputs, const FrameFiles& files, const FrameSettings& settings,
                  const v1::DetectRequest& request, const v1::Detections& detections) {
  if (!outputs.saliency_prefix.empty()) WriteSaliency(outputs.saliency_prefix, detections);
  if (!outputs.labels.empty()) WriteImage(outputs.labels, LabelImage(detections));
  if (!outputs.height_map.empty()) WriteImage(outputs.height_map, HeightPicture(detections));
  WritePictures(outputs, files, settings, request, detections);
  if (outputs.json.empty() || outputs.json == kStandardOutput) return;
  WriteFile(outputs.json, ToJson(ForJson(outputs, detections), request.frame()));
}

std::string JsonLine(const Outputs& outputs, const v1::DetectRequest& request,
                     const v1::Detections& detections) {
  return ToJson(ForJson(outputs, detections), request.frame(), JsonLayout::kOneLine) + "\n";
}

}  // namespace fovea::cli
