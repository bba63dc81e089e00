// sensor_msgs' Image and CompressedImage as they are, before anybody looks at what they show. All
// throw std::invalid_argument that says what is wrong.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <stdexcept>
#include <string_view>

namespace fovea::cli {

struct ImageMessage {
  std::string_view encoding, data;
  std::uint32_t width = 0, height = 0, step = 0;
  bool big_endian = false;
};
ImageMessage ReadImage(std::string_view message);

// A copy of its pixels, of OpenCV's `type`.
cv::Mat PixelsOf(const ImageMessage& image, int type);

struct CompressedImageMessage {
  std::string_view format, data;
};
CompressedImageMessage ReadCompressedImage(std::string_view message);

// `what` is read, and `encoding` is none of it.
std::invalid_argument NoUse(const char* what, std::string_view encoding);

}  // namespace fovea::cli
