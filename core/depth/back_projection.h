// From depth to points.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

// The point of every pixel in the camera frame (x right, y down, z forward; metres).
//
// `depth_m`: CV_32FC1, NaN = none; pixels farther than `max_depth_m` count as none. Returns
// CV_32FC3 of its size; all three coordinates are NaN where there is no depth.
cv::Mat BackProject(const cv::Mat& depth_m, const CameraIntrinsics& intrinsics, double max_depth_m);

}  // namespace fovea
