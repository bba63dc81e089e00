#include "core/objects/oriented_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

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

// Points in a level frame.
struct LevelPlaces {
  Eigen::ArrayXf x, y, height;
};

LevelPlaces PlacesOf(const std::vector<Eigen::Vector3f>& points, const Eigen::Matrix3f& level) {
  const auto count = static_cast<Eigen::Index>(points.size());
  LevelPlaces places{Eigen::ArrayXf(count), Eigen::ArrayXf(count), Eigen::ArrayXf(count)};
  RunInWidestRegisters([&, origin = points.front(), points = points.data(), x = places.x.data(),
                        y = places.y.data(), height = places.height.data()] {
    const Eigen::Matrix3f from_camera = level.transpose();
    const auto along = [&from_camera](int axis, const Eigen::Vector3f& way) {
      return from_camera(axis, 0) * way.x() +
             (from_camera(axis, 1) * way.y() + from_camera(axis, 2) * way.z());
    };
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Vector3f way = points[i] - origin;  // keeps the numbers small
      x[i] = along(0, way);
      y[i] = along(1, way);
      height[i] = along(2, way);
    }
  });
  return places;
}

// The first of the farthest points either way.
template <typename Reaches>
std::pair<Eigen::Index, Eigen::Index> Farthest(const Reaches& reaches) {
  const auto first_at = [&](float reach) {
    Eigen::Index i = 0;
    while (i + 1 < reaches.size() && reaches.coeff(i) != reach) ++i;
    return i;
  };
  return {first_at(reaches.maxCoeff()), first_at(reaches.minCoeff())};
}

// The outermost points in eight directions, counterclockwise, each once.
std::vector<cv::Point2d> Octagon(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y) {
  const std::array<std::pair<Eigen::Index, Eigen::Index>, 4> farthest = {
      Farthest(x), Farthest(x + y), Farthest(y), Farthest(y - x)};
  std::vector<cv::Point2d> corners;
  corners.reserve(2 * farthest.size());
  for (const auto& [i, opposite] : farthest) corners.emplace_back(x[i], y[i]);
  for (const auto& [opposite, i] : farthest) corners.emplace_back(x[i], y[i]);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.front() == corners.back()) corners.pop_back();
  return corners;
}

// Twice the areas between the points and that side of a polygon which each is nearest to; negative
// outside.
std::vector<float> AreasWithin(const std::vector<cv::Point2d>& corners, const Eigen::ArrayXf& x,
                               const Eigen::ArrayXf& y) {
  std::vector<float> areas(x.size(), std::numeric_limits<float>::infinity());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const cv::Point2d along = corners[(k + 1) % corners.size()] - corners[k];
    const cv::Point3f side(cv::Point3d(-along.y, along.x, -along.cross(corners[k])));
    RunInWidestRegisters([&, x = x.data(), y = y.data()] {
      for (std::size_t i = 0; i < areas.size(); ++i) {
        const float area = side.x * x[i] + side.y * y[i] + side.z;
        areas[i] = std::min(areas[i], area);
      }
    });
  }
  return areas;
}

// Without most of the points inside the convex hull, which takes long to find among many: those
// inside of the octagon.
std::vector<cv::Point2f> OuterPoints(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y) {
  const std::vector<cv::Point2d> corners = Octagon(x, y);
  double reach_m = 1;
  for (const cv::Point2d& corner : corners) {
    reach_m = std::max({reach_m, std::abs(corner.x), std::abs(corner.y)});
  }
  const float inside = kInsideM2 * static_cast<float>(reach_m * reach_m);
  const bool has_inside = corners.size() >= 3;
  const std::vector<float> areas = AreasWithin(corners, x, y);
  std::vector<cv::Point2f> outer;
  outer.reserve(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (!has_inside || areas[i] < inside) outer.emplace_back(x[at], y[at]);
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

BaseRectangle SmallestRectangle(const Eigen::ArrayXf& x, const Eigen::ArrayXf& y) {
  std::vector<cv::Point2f> hull;
  cv::convexHull(OuterPoints(x, y), hull);
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
  const LevelPlaces places = PlacesOf(points, level);
  const BaseRectangle base = SmallestRectangle(places.x, places.y);
  const Eigen::Vector3f& origin = points.front();
  float bottom = std::min(0.0F, places.height.minCoeff());
  const float top = std::max(0.0F, places.height.maxCoeff());
  if (support) {
    const Eigen::Vector3f lowest =
        origin + level * Eigen::Vector3f(base.center.x(), base.center.y(), bottom);
    const float gap = support->HeightOf(lowest);
    if (std::abs(gap) <= options.max_gap_m) bottom = std::min(bottom - gap, top);
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
