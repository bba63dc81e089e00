#include "core/scene/missing_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/depth/seen_area.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

// Between a camera and the second one, or the projector, that it measures depth with.
constexpr double kLongestBaseline_m = 0.08;
constexpr double kUsualBaseline_m = 0.05;
// In an image 640 wide:
constexpr double kEdgePx = 4;    // what is lost at an edge whatever the distances
constexpr double kNarrowPx = 4;  // holes no wider than twice this are noise and seams
constexpr double kFewestPixels640 = 500;
constexpr float kSteep = 0.5F;     // cosine of the angle to the surface at which it is looked at
constexpr float kMostlyOn = 0.5F;  // share of a hole that lies before a support

bool IsMissing(const cv::Mat& depth_m, int row, int col) {
  return std::isnan(depth_m.at<float>(row, col));
}

// Runs of missing pixels along rows that are longer than the shadow between their ends.
cv::Mat UnexplainedHoles(const cv::Mat& depth_m, double fx_px, const cv::Rect& area) {
  cv::Mat holes = cv::Mat::zeros(depth_m.size(), CV_8UC1);
  const int edge_px = ScaledPx(kEdgePx, depth_m.cols, 1);
  for (int row = area.y; row < area.br().y; ++row) {
    InterruptionPoint();
    for (int first = area.x, end = first; first < area.br().x; first = end) {
      const bool missing = IsMissing(depth_m, row, first);
      while (end < area.br().x && IsMissing(depth_m, row, end) == missing) ++end;
      if (!missing || first == area.x || end == area.br().x) continue;
      const double step = 1 / depth_m.at<float>(row, first - 1) - 1 / depth_m.at<float>(row, end);
      if (end - first <= fx_px * kLongestBaseline_m * std::abs(step) + edge_px) continue;
      holes.row(row).colRange(first, end).setTo(255);
    }
  }
  return holes;
}

// Where a line of sight meets a support from above.
std::optional<Eigen::Vector3f> Meet(const Eigen::Vector3f& ray, const Support& support) {
  const float slope = support.surface.normal.dot(ray);
  if (slope >= 0) return std::nullopt;
  const Eigen::Vector3f point = ray * (-support.surface.offset_m / slope);
  if (!(point.z() > 0) || !support.footprint.Covers(point)) return std::nullopt;
  return point;
}

// The point of the support that is seen through a hole nearest to the camera; none unless most of
// the hole is before the support.
std::optional<Eigen::Vector3f> BaseOf(const std::vector<cv::Point>& hole, const Support& support,
                                      const CameraIntrinsics& intrinsics) {
  std::size_t count = 0;
  std::optional<Eigen::Vector3f> nearest;
  for (const cv::Point& pixel : hole) {
    const std::optional<Eigen::Vector3f> point = Meet(RayOf(pixel, intrinsics), support);
    if (!point) continue;
    ++count;
    if (!nearest || point->squaredNorm() < nearest->squaredNorm()) nearest = point;
  }
  if (static_cast<float>(count) < kMostlyOn * static_cast<float>(hole.size())) return std::nullopt;
  return nearest;
}

// The horizontal direction from a point to the camera; none where the camera is above it.
std::optional<Eigen::Vector3f> FacingCamera(const Eigen::Vector3f& point,
                                            const Eigen::Vector3f& up) {
  const Eigen::Vector3f to_camera = -point.normalized();
  const Eigen::Vector3f level = to_camera - to_camera.dot(up) * up;
  if (level.norm() < kSteep) return std::nullopt;
  return level.normalized();
}

// The pixels of each hole that is wide enough.
std::vector<std::vector<cv::Point>> FindHoles(const cv::Mat& depth_m, double fx_px,
                                              const cv::Rect& area) {
  cv::Mat holes = UnexplainedHoles(depth_m, fx_px, area);
  const int width_px = 2 * ScaledPx(kNarrowPx, depth_m.cols, 1) + 1;
  cv::morphologyEx(holes, holes, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {width_px, width_px}));
  if (cv::countNonZero(holes) == 0) return {};
  cv::Mat parts;
  const int count = cv::connectedComponents(holes, parts);
  std::vector<std::vector<cv::Point>> pixels(static_cast<std::size_t>(count));
  for (int row = 0; row < parts.rows; ++row) {
    InterruptionPoint();
    const int* part = parts.ptr<int>(row);
    for (int col = 0; col < parts.cols; ++col) {
      if (part[col] != 0) pixels[static_cast<std::size_t>(part[col])].emplace_back(col, row);
    }
  }
  const double fewest = kFewestPixels640 * AreaScale(depth_m.size());
  std::erase_if(pixels,
                [&](const auto& hole) { return static_cast<double>(hole.size()) < fewest; });
  return pixels;
}

// What stands in a hole.
struct StandIn {
  const Support* support = nullptr;
  Eigen::Vector3f base;    // on the support
  Eigen::Vector3f facing;  // its normal
};

std::optional<StandIn> FindStandIn(const std::vector<cv::Point>& hole,
                                   const std::vector<Support>& supports,
                                   const CameraIntrinsics& intrinsics) {
  std::optional<StandIn> nearest;
  for (const Support& support : supports) {
    const auto base = BaseOf(hole, support, intrinsics);
    if (!base || (nearest && base->squaredNorm() >= nearest->base.squaredNorm())) continue;
    const auto facing = FacingCamera(*base, support.surface.normal);
    if (facing) nearest = {&support, *base, *facing};
  }
  return nearest;
}

// Where a line of sight meets it within the limits.
std::optional<Eigen::Vector3f> Meet(const Eigen::Vector3f& ray, const StandIn& stand_in,
                                    const StandInLimits& limits) {
  const float slope = stand_in.facing.dot(ray);
  if (slope >= 0) return std::nullopt;
  const Eigen::Vector3f point = ray * (stand_in.facing.dot(stand_in.base) / slope);
  if (!(point.z() <= static_cast<float>(limits.max_depth_m))) return std::nullopt;
  const float height_m = stand_in.support->surface.HeightOf(point);
  if (height_m > static_cast<float>(limits.max_height_m)) return std::nullopt;
  return point;
}

// Where, on a row, the shadow ends of what stands in a hole that begins at `first`: cameras are
// built so that it falls to the left.
int EndOfShadow(const cv::Mat& depth_m, const cv::Point& first, const StandIn& stand_in,
                double fx_px) {
  int measured = first.x - 1;
  while (measured > 0 && IsMissing(depth_m, first.y, measured)) --measured;
  const double step = 1 / stand_in.base.z() - 1 / depth_m.at<float>(first.y, measured);
  return step > 0 ? measured + 1 + cvRound(fx_px * kUsualBaseline_m * step) : first.x;
}

cv::Vec3f ToCv(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

cv::Mat StandInForMissing(const cv::Mat& depth_m, const std::vector<Support>& supports,
                          const CameraIntrinsics& intrinsics, const StandInLimits& limits,
                          cv::Mat& points, NormalMap& normals) {
  cv::Mat standing = cv::Mat::zeros(depth_m.size(), CV_8UC1);
  if (supports.empty()) return standing;
  const int step = normals.step_px;
  bool any = false;
  for (const auto& hole : FindHoles(depth_m, intrinsics.fx_px, SeenArea(points, {}).bounds())) {
    InterruptionPoint();
    const std::optional<StandIn> stand_in = FindStandIn(hole, supports, intrinsics);
    if (!stand_in) continue;
    if (!any) points = points.clone();  // others may look at them
    any = true;
    cv::Point last(-1, -1);
    int shadow_end = 0;
    for (const cv::Point& pixel : hole) {
      if (pixel != last + cv::Point(1, 0)) {
        shadow_end = EndOfShadow(depth_m, pixel, *stand_in, intrinsics.fx_px);
      }
      last = pixel;
      const auto point = Meet(RayOf(pixel, intrinsics), *stand_in, limits);
      if (!point || pixel.x < shadow_end) continue;
      standing.at<std::uint8_t>(pixel) = 255;
      points.at<cv::Vec3f>(pixel) = ToCv(*point);
      if (pixel.x % step != 0 || pixel.y % step != 0) continue;
      normals.vectors.at<cv::Vec3f>(pixel / step) = ToCv(stand_in->facing);
    }
  }
  return standing;
}

}  // namespace fovea
