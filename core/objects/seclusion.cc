#include "core/objects/seclusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/depth/depth_gap.h"

namespace fovea {
namespace {

constexpr double kReachPx = 30;  // wider than the shadow of most things at a width of 640

enum class Facing { kHidden, kLevel, kOpen, kOwn };

// What lies beyond a side of a pixel: that of the first pixel with depth on the way.
class Search {
 public:
  Search(const cv::Mat& labels, const cv::Mat& depth_m)
      : labels_(labels),
        depth_m_(depth_m),
        reach_px_(std::max(2, cvRound(kReachPx * labels.cols / 640.0))) {}

  Facing Beyond(const cv::Point& pixel, const cv::Point& side) const {
    const cv::Rect image({}, labels_.size());
    const std::uint16_t label = labels_.at<std::uint16_t>(pixel);
    const float own_z = depth_m_.at<float>(pixel);
    cv::Point beyond = pixel;
    for (int step = 0; step < reach_px_; ++step) {
      beyond += side;
      if (!image.contains(beyond)) return Facing::kOpen;
      if (labels_.at<std::uint16_t>(beyond) == label) return Facing::kOwn;
      const float z = depth_m_.at<float>(beyond);
      if (!(z > 0)) continue;  // nothing measured
      if (std::abs(z - own_z) <= DepthGap_m(own_z)) return Facing::kLevel;
      return z < own_z ? Facing::kHidden : Facing::kOpen;
    }
    return Facing::kOpen;  // nothing measured
  }

 private:
  const cv::Mat& labels_;
  const cv::Mat& depth_m_;
  const int reach_px_;
};

}  // namespace

Seclusion FindSeclusion(const cv::Mat& labels, const cv::Mat& depth_m,
                        const std::vector<cv::Point>& pixels) {
  const std::array<cv::Point, 4> sides = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const Search search(labels, depth_m);
  int hidden = 0, level = 0, total = 0;
  for (const cv::Point& pixel : pixels) {
    for (const cv::Point& side : sides) {
      const Facing facing = search.Beyond(pixel, side);
      if (facing == Facing::kOwn) continue;
      ++total;
      hidden += facing == Facing::kHidden;
      level += facing == Facing::kLevel;
    }
  }
  if (total == 0) return {};
  return {static_cast<double>(hidden) / total, static_cast<double>(level) / total};
}

}  // namespace fovea
