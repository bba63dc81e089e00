// What is odd about a frame and may be right all the same: people are told, nothing is refused.
// What is odd about its depth: depth_notes.h.
#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <string>

#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// That hardly any camera has these intrinsics with images of this size: those of another size, in
// another order or unit. `path`: of the field, "frame.intrinsics".
std::optional<std::string> OddIntrinsics(const CameraIntrinsics& intrinsics, const cv::Size& size,
                                         const std::string& path);

// That the pose of the camera is in another convention: with it gravity is askew in the frame that
// it is given in, and is not if it is read another way.
std::optional<std::string> OddCameraPose(const v1::Frame& frame, const Detections& detections);

}  // namespace fovea::server
