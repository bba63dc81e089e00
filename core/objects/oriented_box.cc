#include "core/objects/oriented_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/types/level_axes.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// Twice the area between a side of the octagon and a point that is surely inside, for all that
// rounding can do within a metre; what rounding does grows with the square of the size.
constexpr float kInsideM2 = 1e-5F;

// Any frame with `up` as its third axis; columns are its axes.
Eigen::Matrix3f LevelFrame(const Eigen::Vector3f& up) {
  Eigen::Matrix3f frame;
  frame.leftCols<2>() = LevelAxesFor(up).transpose();
  frame.col(2) = up;
  return frame;
}

// The outermost points in eight directions, counterclockwise, each once.
std::vector<cv::Point2d> Octagon(const std::vector<cv::Point2f>& points) {
  struct Farthest {
    float reach = -std::numeric_limits<float>::infinity();
    cv::Point2f point;
    void Offer(float new_reach, const cv::Point2f& new_point) {
      if (new_reach > reach) *this = {new_reach, new_point};
    }
  };
  std::array<Farthest, 8> farthest;
  for (const cv::Point2f& point : points) {
    const std::array<float, 4> reaches = {point.x, point.x + point.y, point.y, point.y - point.x};
    for (std::size_t i = 0; i < reaches.size(); ++i) {
      farthest[i].Offer(reaches[i], point);
      farthest[i + 4].Offer(-reaches[i], point);
    }
  }
  std::vector<cv::Point2d> corners;
  corners.reserve(farthest.size());
  for (const Farthest& corner : farthest) corners.emplace_back(corner.point);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.front() == corners.back()) corners.pop_back();
  return corners;
}

// Without most of the points inside the convex hull, which takes long to find among many: those
// inside of the octagon.
std::vector<cv::Point2f> WithoutInnerPoints(const std::vector<cv::Point2f>& points) {
  const std::vector<cv::Point2d> corners = Octagon(points);
  if (corners.size() < 3) return points;
  double reach_m = 1;
  for (const cv::Point2d& corner : corners) {
    reach_m = std::max({reach_m, std::abs(corner.x), std::abs(corner.y)});
  }
  const float inside = kInsideM2 * static_cast<float>(reach_m * reach_m);
  // Of the side that it is nearest to.
  std::vector<float> areas(points.size(), std::numeric_limits<float>::infinity());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    // x · p.x + y · p.y + z is twice the area between side and p.
    const cv::Point2d along = corners[(k + 1) % corners.size()] - corners[k];
    const cv::Point3f side(cv::Point3d(-along.y, along.x, -along.cross(corners[k])));
    RunInWidestRegisters([&] {
      for (std::size_t i = 0; i < areas.size(); ++i) {
        const float area = side.x * points[i].x + side.y * points[i].y + side.z;
        areas[i] = std::min(areas[i], area);
      }
    });
  }
  std::vector<cv::Point2f> outer;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] < inside) outer.push_back(points[i]);
  }
  return outer;
}

// The smallest rectangle around the points; `longer` is the direction of its longer side.
struct BaseRectangle {
  Eigen::Vector2f center;
  Eigen::Vector2f longer;
  float length = 0;
  float width = 0;
};

BaseRectangle SmallestRectangle(const std::vector<cv::Point2f>& points) {
  std::vector<cv::Point2f> hull;
  cv::convexHull(WithoutInnerPoints(points), hull);
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
  ground.reserve(points.size());
  float bottom = 0;
  float top = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f p = level.transpose() * (point - origin);
    ground.emplace_back(p.x(), p.y());
    bottom = std::min(bottom, p.z());
    top = std::max(top, p.z());
  }
  const BaseRectangle base = SmallestRectangle(ground);
  if (support) {
    const Eigen::Vector3f lowest =
        origin + level * Eigen::Vector3f(base.center.x(), base.center.y(), bottom);
    const float gap = support->HeightOf(lowest);
    if (gap <= options.max_gap_m) bottom = std::min(bottom - gap, top);
  }

  OrientedBox box;
  box.center =
      origin + level * Eigen::Vector3f(base.center.x(), base.center.y(), (bottom + top) / 2);
  box.rotation.col(0) = level * Eigen::Vector3f(base.longer.x(), base.longer.y(), 0);
  box.rotation.col(2) = up;
  box.rotation.col(1) = box.rotation.col(2).cross(box.rotation.col(0));
  box.size_m = {base.length, base.width, top - bottom};
  return box;
}

}  // namespace fovea
