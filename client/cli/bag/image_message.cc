#include "client/cli/bag/image_message.h"

#include <cstddef>
#include <cstring>
#include <opencv2/core.hpp>
#include <string>

#include "client/cli/bag/cdr_reader.h"
#include "client/cli/bag/message_header.h"

namespace fovea::cli {

ImageMessage ReadImage(std::string_view message) {
  CdrReader reader(message);
  ReadHeader(reader);
  ImageMessage image;
  image.height = reader.Number<std::uint32_t>();
  image.width = reader.Number<std::uint32_t>();
  image.encoding = reader.Text();
  image.big_endian = reader.Number<std::uint8_t>() != 0;
  image.step = reader.Number<std::uint32_t>();
  image.data = reader.Bytes();
  return image;
}

cv::Mat PixelsOf(const ImageMessage& image, int type) {
  constexpr std::uint32_t kLargest = 1 << 15;
  if (image.width == 0 || image.height == 0 || image.width > kLargest || image.height > kLargest) {
    throw std::invalid_argument("an image's width or height is not from 1 to 32768");
  }
  const std::uint64_t row = std::uint64_t{image.width} * CV_ELEM_SIZE(type);
  if (image.step < row || image.data.size() < std::uint64_t{image.step} * image.height) {
    throw std::invalid_argument("an image has fewer bytes than its size needs");
  }
  cv::Mat pixels(static_cast<int>(image.height), static_cast<int>(image.width), type);
  for (std::uint32_t y = 0; y < image.height; ++y) {  // which may lie at any byte
    std::memcpy(pixels.ptr(static_cast<int>(y)), image.data.data() + std::uint64_t{image.step} * y,
                static_cast<std::size_t>(row));
  }
  return pixels;
}

CompressedImageMessage ReadCompressedImage(std::string_view message) {
  CdrReader reader(message);
  ReadHeader(reader);
  const std::string_view format = reader.Text();
  return {format, reader.Bytes()};
}

std::invalid_argument NoUse(const char* what, std::string_view encoding) {
  constexpr std::size_t kMostLetters = 64;
  return std::invalid_argument(std::string("an image of encoding \"") +
                               std::string(encoding.substr(0, kMostLetters)) + "\" is no " + what);
}

}  // namespace fovea::cli
