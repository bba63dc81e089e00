#include "core/segmentation/image_borders.h"

#include <algorithm>
#include <cstdint>

namespace fovea {

ImageBorders FindImageBorders(const cv::Mat& labels, const cv::Mat& points, int reach_px,
                              float step) {
  ImageBorders borders;
  const auto visit = [&](const cv::Point& p, const cv::Point& q) {
    const int a = labels.at<std::uint16_t>(p);
    const int b = labels.at<std::uint16_t>(q);
    if (a == 0 || b == 0 || a == b) return;
    const float depth_a = points.at<cv::Vec3f>(p)[2];
    const float depth_b = points.at<cv::Vec3f>(q)[2];
    const float limit = step * std::min(depth_a, depth_b);
    ImageBorder& border = borders[std::minmax(a, b)];
    ++border.length_px;
    if (depth_a < depth_b - limit) ++(a < b ? border.first_in_front : border.second_in_front);
    if (depth_b < depth_a - limit) ++(b < a ? border.first_in_front : border.second_in_front);
  };
  for (int row = 0; row < labels.rows; ++row) {
    for (int col = 0; col < labels.cols; ++col) {
      const cv::Point p(col, row);
      if (col + reach_px < labels.cols) visit(p, {col + reach_px, row});
      if (row + reach_px < labels.rows) visit(p, {col, row + reach_px});
    }
  }
  return borders;
}

}  // namespace fovea
