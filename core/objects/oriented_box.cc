#include "core/objects/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace fovea {
namespace {

// Any frame with `up` as its third axis; columns are its axes.
Eigen::Matrix3f LevelFrame(const Eigen::Vector3f& up) {
  Eigen::Matrix3f frame;
  frame.col(2) = up;
  frame.col(0) = up.unitOrthogonal();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

// The smallest rectangle around the points; `longer` is the direction of its longer side.
struct Footprint {
  Eigen::Vector2f center;
  Eigen::Vector2f longer;
  float length = 0;
  float width = 0;
};

Footprint SmallestFootprint(const std::vector<cv::Point2f>& points) {
  std::vector<cv::Point2f> hull;
  cv::convexHull(points, hull);
  const cv::RotatedRect rectangle = cv::minAreaRect(hull);
  const float angle = rectangle.angle * static_cast<float>(CV_PI) / 180;
  const Eigen::Vector2f along_width(std::cos(angle), std::sin(angle));
  const bool width_is_longer = rectangle.size.width >= rectangle.size.height;
  return {{rectangle.center.x, rectangle.center.y},
          width_is_longer ? along_width : Eigen::Vector2f(-along_width.y(), along_width.x()),
          std::max(rectangle.size.width, rectangle.size.height),
          std::min(rectangle.size.width, rectangle.size.height)};
}

}  // namespace

OrientedBox FitOrientedBox(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up,
                           const std::optional<SupportSurface>& support,
                           const BoxOptions& options) {
  const Eigen::Matrix3f level = LevelFrame(up);
  const Eigen::Vector3f& origin = points.front();  // keeps the numbers small
  std::vector<cv::Point2f> ground;
  float bottom = 0;
  float top = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f p = level.transpose() * (point - origin);
    ground.emplace_back(p.x(), p.y());
    bottom = std::min(bottom, p.z());
    top = std::max(top, p.z());
  }
  const Footprint footprint = SmallestFootprint(ground);
  if (support) {
    const Eigen::Vector3f lowest =
        origin + level * Eigen::Vector3f(footprint.center.x(), footprint.center.y(), bottom);
    const float gap = support->HeightOf(lowest);
    if (gap <= options.max_gap_m) bottom = std::min(bottom - gap, top);
  }

  OrientedBox box;
  box.center = origin + level * Eigen::Vector3f(footprint.center.x(), footprint.center.y(),
                                                (bottom + top) / 2);
  box.rotation.col(0) = level * Eigen::Vector3f(footprint.longer.x(), footprint.longer.y(), 0);
  box.rotation.col(2) = up;
  box.rotation.col(1) = box.rotation.col(2).cross(box.rotation.col(0));
  box.size_m = {footprint.length, footprint.width, top - bottom};
  return box;
}

}  // namespace fovea
