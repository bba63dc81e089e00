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
  // CV_32FC1, same size, metres along z; NaN where nothing was measured, as is what is nearer than
  // 1 mm or farther than 10 km
  cv::Mat depth_m;
  CameraIntrinsics intrinsics;
  // Unit vector in the camera frame that points down, where the robot knows it (IMU).
  std::optional<Eigen::Vector3f> gravity;
  // CV_8UC1, same size: not 0 where the camera does not look, such as beyond the border of an image
  // that was undistorted. Empty: it sees all of the image.
  cv::Mat unseen = {};
};

// Throws std::invalid_argument unless a camera can have these intrinsics with an image of this
// size: focal lengths positive and at most a million pixels, the principal point finite, and no
// pixel seen more than 84° (a slope of 10) beside the optical axis, as it would be with normalised
// intrinsics or with those of another image size.
void RequirePlausible(const CameraIntrinsics& intrinsics, const cv::Size& size);

// Throws std::invalid_argument, which names the member and what it must be, unless: the images
// are non-empty (`unseen` may be), of the stated types and of one size; the intrinsics are
// plausible for it; gravity, if given, is finite with a length within 10 % of one.
void Validate(const RgbdFrame& frame);

}  // namespace fovea
