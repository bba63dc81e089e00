#include "client/cli/capture_file.h"

#include <google/protobuf/util/json_util.h>

#include <filesystem>
#include <stdexcept>

#include "client/cli/files.h"
#include "client/cli/json.h"

namespace fovea::cli {
namespace {

v1::Frame ParseCaptureFile(const std::string& text) {
  google::protobuf::util::JsonParseOptions options;
  options.ignore_unknown_fields = true;  // of later versions
  v1::Frame frame;
  const auto status = google::protobuf::util::JsonStringToMessage(text, &frame, options);
  if (!status.ok()) throw std::runtime_error("it is not JSON as fovea-capture writes it");
  const double unit_m = frame.depth().unit_m();
  if (!(unit_m > 0 && unit_m <= 1)) {
    throw std::runtime_error("depth.unit_m must be above 0 and at most 1 metre");
  }
  if (frame.has_depth_intrinsics() != frame.has_color_from_depth()) {
    throw std::runtime_error("depth_intrinsics and color_from_depth go together");
  }
  return frame;
}

}  // namespace

void WriteCaptureFile(const std::string& folder, const v1::Frame& frame) {
  v1::Frame kept;
  kept.mutable_depth()->set_unit_m(frame.depth().unit_m());
  if (frame.has_depth_intrinsics()) {
    *kept.mutable_depth_intrinsics() = frame.depth_intrinsics();
    *kept.mutable_color_from_depth() = frame.color_from_depth();
  }
  WriteFile(folder + "/" + kCaptureFileName, ToJson(kept));
}

std::optional<CaptureFile> ReadCaptureFile(const std::string& folder) {
  CaptureFile file;
  file.path = (std::filesystem::path(folder) / kCaptureFileName).string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(file.path, error)) return std::nullopt;
  const std::string text = ReadFile(file.path, kLargestText);
  try {
    const v1::Frame frame = ParseCaptureFile(text);
    file.depth_unit_m = frame.depth().unit_m();
    if (frame.has_depth_intrinsics()) {
      file.depth_camera = DepthCamera{frame.depth_intrinsics(), frame.color_from_depth()};
    }
    return file;
  } catch (const std::runtime_error& problem) {
    throw std::runtime_error(file.path + ": " + problem.what());
  }
}

}  // namespace fovea::cli
