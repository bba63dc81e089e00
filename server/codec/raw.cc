#include "server/codec/raw.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "server/codec/size_limits.h"

namespace fovea::server {
namespace {

static_assert(std::endian::native == std::endian::little, "the wire is little-endian");
constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

}  // namespace

cv::Mat ImageFromRows(std::string_view bytes, int width, int height, int type, const char* kind) {
  const auto columns = static_cast<std::uint64_t>(width);
  const auto rows = static_cast<std::uint64_t>(height);
  const std::uint64_t needed = columns * rows * CV_ELEM_SIZE(type);
  if (bytes.size() != needed) {
    throw std::invalid_argument("has " + std::to_string(bytes.size()) + " bytes, " +
                                SizeText(columns, rows) + " " + kind + " needs " +
                                std::to_string(needed));
  }
  cv::Mat image(height, width, type);
  std::memcpy(image.data, bytes.data(), needed);
  return image;
}

cv::Mat MetersFrom16U(const cv::Mat& depth, double unit_m) {
  cv::Mat meters(depth.size(), CV_32FC1);
  std::transform(depth.begin<std::uint16_t>(), depth.end<std::uint16_t>(), meters.begin<float>(),
                 [unit_m](std::uint16_t units) {
                   return units == 0 ? kNotMeasured : static_cast<float>(units * unit_m);
                 });
  return meters;
}

cv::Mat MetersFrom32F(const cv::Mat& depth) {
  cv::Mat meters(depth.size(), CV_32FC1);
  std::transform(depth.begin<float>(), depth.end<float>(), meters.begin<float>(), [](float value) {
    return std::isfinite(value) && value > 0 ? value : kNotMeasured;
  });
  return meters;
}

}  // namespace fovea::server
