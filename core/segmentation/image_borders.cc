#include "core/segmentation/image_borders.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr double kMaxShadowPx = 60;  // unmeasured beside something in front

}  // namespace

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
  const int max_shadow_px = ScaledPx(kMaxShadowPx, labels.cols, 8);
  const auto visit_next = [&](const cv::Point& p, const cv::Point& step_px) {
    const cv::Rect image({}, labels.size());
    cv::Point q = p + reach_px * step_px;
    for (int i = 0; i < max_shadow_px && image.contains(q); ++i, q += step_px) {
      const bool is_shadow =
          labels.at<std::uint16_t>(q) == 0 && std::isnan(points.at<cv::Vec3f>(q)[2]);
      if (is_shadow) continue;
      visit(p, q);
      return;
    }
  };
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    for (int col = 0; col < labels.cols; ++col) {
      if (labels.at<std::uint16_t>(row, col) == 0) continue;
      visit_next({col, row}, {1, 0});
      visit_next({col, row}, {0, 1});
    }
  }
  return borders;
}

}  // namespace fovea
