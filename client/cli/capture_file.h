// What fovea-capture --save keeps of the cameras beside the frames and intrinsics.json.
#pragma once

#include <optional>
#include <string>

#include "client/cli/request.h"

namespace fovea::cli {

struct CaptureFile {
  std::string path;
  double depth_unit_m = 0.001;
  std::optional<DepthCamera> depth_camera;  // none = depth is registered
};

// Its name in the folder.
inline constexpr const char* kCaptureFileName = "fovea_capture.json";

// Depth unit and depth camera of a frame, by the names of the contract. Throws std::runtime_error
// that names the file.
void WriteCaptureFile(const std::string& folder, const v1::Frame& frame);

// Nothing where there is none, as in folders that were not captured, or by an older version. Throws
// std::runtime_error that names the file and the field.
std::optional<CaptureFile> ReadCaptureFile(const std::string& folder);

}  // namespace fovea::cli
