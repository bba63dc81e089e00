#include "server/codec/raw.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "server/codec/size_limits.h"

namespace fovea::server {
namespace {

static_assert(std::endian::native == std::endian::little, "the wire is little-endian");
constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

// Row by row: OpenCV's iterators ask at each pixel whether the row has ended.
template <typename Unit, typename Convert>
cv::Mat MetersOf(const cv::Mat& depth, Convert convert) {
  cv::Mat meters(depth.size(), CV_32FC1);
  for (int row = 0; row < depth.rows; ++row) {
    const Unit* units = depth.ptr<Unit>(row);
    std::transform(units, units + depth.cols, meters.ptr<float>(row), convert);
  }
  return meters;
}

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
  return MetersOf<std::uint16_t>(depth, [unit_m](std::uint16_t units) {
    return units == 0 ? kNotMeasured : static_cast<float>(units * unit_m);
  });
}

cv::Mat MetersFrom32F(const cv::Mat& depth) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  return MetersOf<float>(
      depth, [](float value) { return value > 0 && value <= kLargest ? value : kNotMeasured; });
}

}  // namespace fovea::server
