#include "client/cli/overlay/view.h"

#include <cmath>

#include "client/cli/lens.h"

namespace fovea::cli {
namespace {

constexpr double kNearest_m = 0.02;

}  // namespace

std::optional<cv::Point2d> View::Project(const cv::Vec3d& point) const {
  constexpr double kFarthest_px = 1e5;
  if (!(point[2] >= kNearest_m)) return std::nullopt;
  const cv::Point2d seen = PixelsOf({point}, intrinsics, frame).front();
  const cv::Point2d pixel = At(seen.x, seen.y);
  if (!(std::abs(pixel.x) + std::abs(pixel.y) < kFarthest_px)) return std::nullopt;
  return pixel;
}

std::optional<std::pair<cv::Point2d, cv::Point2d>> View::Project(const SpaceLine& line) const {
  cv::Vec3d from = line.from, to = line.to;
  if (from[2] < kNearest_m) std::swap(from, to);
  if (to[2] < kNearest_m && from[2] > kNearest_m) {
    const double share = (from[2] - kNearest_m) / (from[2] - to[2]);
    to = from + share * (to - from);
    to[2] = kNearest_m;
  }
  const auto start = Project(from), end = Project(to);
  if (!start || !end) return std::nullopt;
  return std::pair{*start, *end};
}

}  // namespace fovea::cli
