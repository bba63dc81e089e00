// Images of ROS 2's sensor_msgs as the bytes of image files. All throw std::invalid_argument that
// says what is wrong.
#pragma once

#include <string>
#include <string_view>

namespace fovea::cli {

// PNG, or JPEG where the message holds such a file. `compressed`: it is a CompressedImage. Colour:
// rgb8, bgr8, 8UC3, rgba8, bgra8, mono8, 8UC1, yuv422 (uyvy), yuv422_yuy2 (yuyv) and Bayer patterns
// of 8 bits.
std::string ColorFile(std::string_view message, bool compressed);

// 16-bit PNG in units of `unit_m` metres, 0 = none: 16UC1 and mono16 as they are, 32FC1 (metres)
// rounded; compressed PNG, and compressedDepth of all in PNG or RVL. Depth in metres of which none
// fits into 16 bits is refused.
std::string DepthFile(std::string_view message, bool compressed, double unit_m);

}  // namespace fovea::cli
