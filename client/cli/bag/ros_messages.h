// Messages of ROS 2's sensor_msgs in CDR. All throw std::invalid_argument that says what is wrong.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/cli/calibration_file.h"

namespace fovea::cli {

// What images and camera_info begin with.
struct Header {
  std::int64_t stamp_ns = 0;  // 0 where none was set
  std::string frame;          // the coordinate frame that it is of
};
Header HeaderOf(std::string_view message);

// As the bytes of image files: PNG, or JPEG where the message holds such a file. `compressed`: it
// is a CompressedImage. Colour: rgb8, bgr8, 8UC3, rgba8, bgra8, mono8 and 8UC1.
std::string ColorFile(std::string_view message, bool compressed);
// 16-bit PNG in units of `unit_m` metres, 0 = none: 16UC1 and mono16 as they are, 32FC1 (metres)
// rounded; compressed PNG, and compressedDepth of both in PNG. Depth in metres of which none fits
// into 16 bits is refused.
std::string DepthFile(std::string_view message, bool compressed, double unit_m);

// Of the images as the camera takes them (K and D), or of `rectified` ones (P, without distortion),
// cut out and binned as the message says.
Calibration CameraInfo(std::string_view message, bool rectified);

}  // namespace fovea::cli
