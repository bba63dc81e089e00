#include "core/objects/seclusion.h"

#include <array>
#include <cmath>

#include "core/depth/depth_gap.h"
#include "core/segmentation/beyond_border.h"

namespace fovea {
Seclusion FindSeclusion(const cv::Mat& labels, const cv::Mat& depth_m,
                        const std::vector<cv::Point>& pixels) {
  const std::array<cv::Point2f, 4> sides = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  int hidden = 0, level = 0, total = 0;
  for (const cv::Point& pixel : pixels) {
    const float z = depth_m.at<float>(pixel);
    for (const cv::Point2f& side : sides) {
      const auto beyond = DepthBeyond(labels, depth_m, pixel, side, 0);
      if (!beyond) continue;
      ++total;
      hidden += *beyond < z - DepthGap_m(z);  // false for NaN
      level += std::abs(*beyond - z) <= DepthGap_m(z);
    }
  }
  if (total == 0) return {};
  return {static_cast<double>(hidden) / total, static_cast<double>(level) / total};
}

}  // namespace fovea
