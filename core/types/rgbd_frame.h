// What the detector takes: one colour image with depth measured along the same rays.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>

namespace fovea {

// Pinhole model without distortion, in pixels. The centre of the top left pixel is (0, 0).
struct CameraIntrinsics {
  double fx_px = 0;
  double fy_px = 0;
  double cx_px = 0;
  double cy_px = 0;
};

// A registered RGB-D frame. The camera frame is optical: x right, y down, z forward.
struct RgbdFrame {
  cv::Mat color_rgb;  // CV_8UC3, R first
  cv::Mat depth_m;    // CV_32FC1, same size, metres along z; NaN where nothing was measured
  CameraIntrinsics intrinsics;
  // Unit vector in the camera frame that points down, where the robot knows it (IMU).
  std::optional<Eigen::Vector3f> gravity;
};

// Throws std::invalid_argument, which names the member and what it must be, unless: the images
// are non-empty, of the stated types and of one size; focal lengths are finite and positive, the
// principal point finite; gravity, if given, is finite with a length within 10 % of one.
void Validate(const RgbdFrame& frame);

}  // namespace fovea
