// What grasps are planned in.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// Both images have the frame's size.
struct GraspScene {
  const cv::Mat& points;  // CV_32FC3, camera frame; NaN = none
  const cv::Mat& labels;  // CV_16UC1, 0 = background, k = the object with label k
  const CameraIntrinsics& intrinsics;
  const Eigen::Vector3f up;  // unit vector, against gravity
  // What was measured, also farther away than points are: CV_32FC1, metres, NaN = none. Empty: no
  // more than the points.
  const cv::Mat measured_m = {};
};

}  // namespace fovea
