// A frame on disk and what is asked about it → a request.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::cli {

// Of depth that is not registered to colour.
struct DepthCamera {
  v1::CameraIntrinsics intrinsics;
  v1::Pose color_from_depth;
};

// What all frames of a run have in common.
struct FrameSettings {
  v1::CameraIntrinsics intrinsics;
  std::optional<DepthCamera> depth_camera;
  double depth_unit_m = 0.001;
  std::optional<v1::Vector3> gravity;
  v1::DetectOptions options;
};

struct FrameFiles {
  std::string id;
  std::string color_path;
  std::string depth_path;
};

// The values of --intrinsics; --depth-intrinsics and --color-from-depth, which go together (both
// empty = none); --gravity; --profile and --set. Throw std::invalid_argument that names the flag.
v1::CameraIntrinsics ParseIntrinsics(const std::string& text, const std::string& flag);
std::optional<DepthCamera> ParseDepthCamera(const std::string& intrinsics, const std::string& pose);
std::optional<v1::Vector3> ParseGravity(const std::string& text);  // empty = none
v1::DetectOptions ParseOptions(const std::string& profile, const std::vector<std::string>& changes);

// The bytes of the files travel as they are. Throws std::exception with one line of text.
v1::DetectRequest MakeRequest(const FrameFiles& files, const FrameSettings& settings);

}  // namespace fovea::cli
