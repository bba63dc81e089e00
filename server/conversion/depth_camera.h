// The depth camera of a frame whose depth is not registered to colour.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/types/rgbd_frame.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

struct DepthCamera {
  CameraIntrinsics intrinsics;
  v1::CameraIntrinsics proto;  // with its distortion, which the image's size is needed for
  Eigen::Isometry3d color_from_depth;
};

// None where depth is registered. Throws std::invalid_argument that starts with the field, also
// where only one of the two that belong together is given.
std::optional<DepthCamera> DepthCameraFromProto(const v1::Frame& frame);

// Depth in pixels of colour.
struct RegisteredDepth {
  cv::Mat depth_m;  // as of core/depth/registration.h
  cv::Mat unseen;   // as of core/depth/depth_view.h; empty where the depth camera sees all of it
};

// Appends to `messages` that nothing of what was measured lies in the colour image. Throws
// std::invalid_argument that starts with "frame.color_from_depth: " or "frame.depth_intrinsics…: ".
RegisteredDepth Register(const cv::Mat& depth_m, const DepthCamera& camera,
                         const CameraIntrinsics& color, const cv::Size& color_size,
                         std::vector<std::string>* messages);

}  // namespace fovea::server
