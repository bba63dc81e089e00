// A frame on disk and what is asked about it → a request.
#pragma once

#include <functional>
#include <memory>
#include <opencv2/core/types.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::cli {

// Of depth that is not registered to colour.
struct DepthCamera {
  v1::CameraIntrinsics intrinsics;
  v1::Pose color_from_depth;
  cv::Size size = {};                // of the images that they are for; empty = not said
  std::string intrinsics_path = {};  // of the file that said so
};

// What all frames of a run have in common.
struct FrameSettings {
  v1::CameraIntrinsics intrinsics;
  cv::Size size;                // of the images that they are for; empty = not said
  std::string intrinsics_path;  // of the file that said so; empty = none, or a bag
  std::string info_topic;       // of the bag that said so
  std::optional<DepthCamera> depth_camera;
  double depth_unit_m = 0.001;
  std::optional<v1::Vector3> gravity;
  std::optional<v1::Pose> camera_pose;
  v1::DetectOptions options;
};

// A frame that a robot sent once, and what it was answered.
struct SentBefore {
  v1::DetectRequest request;
  std::optional<v1::Detections> answer;  // none: it was refused
};

struct FrameFiles {
  std::string id = {};
  std::string color_path = {};
  std::string depth_path = {};
  std::optional<google::protobuf::Timestamp> captured_at = {};
  // The bytes of both files, where they are no files; the paths are names for people then.
  std::function<std::string()> read_color = {}, read_depth = {};
  // Of frames that were sent before, which are sent again as they were.
  std::shared_ptr<const SentBefore> sent_before = nullptr;
};

// The values of --depth-intrinsics and --color-from-depth, which go together, of --gravity, and of
// the pose that `flag` gives; empty = none. Throw std::exception that names the flag.
std::optional<DepthCamera> ParseDepthCamera(const std::string& intrinsics, const std::string& pose);
std::optional<v1::Vector3> ParseGravity(const std::string& text);
std::optional<v1::Pose> ParsePose(const std::string& text, const std::string& flag);

// Throws std::runtime_error where the depth camera is said to have images of another size.
void CheckDepthSize(const DepthCamera& camera, const cv::Size& size);

// What all requests have in common: everything but the images, their id and time.
v1::DetectRequest CommonRequest(const FrameSettings& settings);

// The settings of a frame that was sent before are its own, as far as pictures need them.
FrameSettings SettingsFor(const FrameFiles& files, const FrameSettings& settings);

// Of something that all frames of a run have in common.
struct ErrorOfAllFrames : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws std::runtime_error where the intrinsics are for images of another size than the one that
// was answered, ErrorOfAllFrames where they are a bag's.
void CheckSize(const FrameSettings& settings, const v1::Detections& detections);

// The bytes of the files travel as they are, and a frame that was sent before goes with its own
// options, which those of `settings` change. Throws std::exception with one line of text.
v1::DetectRequest MakeRequest(const FrameFiles& files, const FrameSettings& settings);

}  // namespace fovea::cli
