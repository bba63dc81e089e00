#include "core/planning/collision_primitives.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/planning/grown_primitive.h"
#include "core/types/interruption.h"
#include "core/types/level_axes.h"

namespace fovea {
namespace {

CollisionPrimitive BoxPrimitive(const OrientedBox& box) {
  CollisionPrimitive primitive;
  primitive.pose.linear() = box.rotation;
  primitive.pose.translation() = box.center;
  primitive.size_m = box.size_m;
  return primitive;
}

CollisionPrimitive CylinderPrimitive(const Shape& shape) {
  CollisionPrimitive primitive;
  primitive.kind = CollisionPrimitive::Kind::kCylinder;
  const Eigen::Vector3f x = shape.axis.unitOrthogonal();
  primitive.pose.linear() << x, shape.axis.cross(x), shape.axis;
  primitive.pose.translation() = shape.center;
  primitive.size_m = {2 * shape.radius_m, 2 * shape.radius_m, shape.length_m};
  return primitive;
}

CollisionPrimitive OfShape(const DetectedObject& object) {
  switch (object.shape.kind) {
    case Shape::Kind::kCylinder:
    case Shape::Kind::kRevolution:
      return CylinderPrimitive(object.shape);
    case Shape::Kind::kSphere: {
      CollisionPrimitive sphere;
      sphere.kind = CollisionPrimitive::Kind::kSphere;
      sphere.pose.translation() = object.shape.center;
      sphere.size_m.setConstant(2 * object.shape.radius_m);
      return sphere;
    }
    case Shape::Kind::kBox:
    case Shape::Kind::kFlat:
    case Shape::Kind::kOther:
      break;
  }
  return BoxPrimitive(object.box);
}

bool HoldsItsPoints(const CollisionPrimitive& primitive, const std::vector<ColoredPoint>& cloud) {
  constexpr float kOutside_m = 0.005F;
  constexpr std::size_t kOneIn = 100;
  const auto outside = std::count_if(cloud.begin(), cloud.end(), [&](const ColoredPoint& p) {
    return OutsideBy_m(primitive, {p.x, p.y, p.z}) >= kOutside_m;
  });
  return kOneIn * static_cast<std::size_t>(outside) <= cloud.size();
}

// Leaves the corners of the convex hull.
void KeepHull(std::vector<cv::Point2f>& points) {
  std::vector<cv::Point2f> hull;
  cv::convexHull(points, hull);
  points = std::move(hull);
}

}  // namespace

CollisionPrimitive PrimitiveOf(const DetectedObject& object) {
  CollisionPrimitive primitive = OfShape(object);
  if (HoldsItsPoints(primitive, object.cloud)) return primitive;
  const CollisionPrimitive box = GrownTo(object.cloud, BoxPrimitive(object.box));
  primitive = GrownTo(object.cloud, primitive);
  return VolumeOf(primitive) < VolumeOf(box) ? primitive : box;
}

std::optional<CollisionPrimitive> PrimitiveOf(const Support& support, const cv::Mat& points,
                                              float tolerance_m) {
  constexpr float kThickness_m = 0.02F;
  constexpr float kLeastSide_m = 0.01F;  // of a row of pixels; checkers refuse boxes without width
  constexpr std::size_t kMorePoints = 10'000;  // at once: bounds the time between interruptions
  const SupportSurface& surface = support.surface;
  const LevelAxes axes = LevelAxesAlongView(surface.normal);
  std::vector<cv::Point2f> on;
  std::size_t most = kMorePoints;
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    for (int column = 0; column < points.cols; ++column) {
      const auto& p = points.at<cv::Vec3f>(row, column);
      const Eigen::Vector3f point(p[0], p[1], p[2]);
      if (!(std::abs(surface.HeightOf(point)) <= tolerance_m)) continue;  // NaN is none
      if (!support.footprint.Covers(point)) continue;
      const Eigen::Vector2f place = axes * point;
      on.emplace_back(place.x(), place.y());
    }
    if (on.size() < most) continue;
    KeepHull(on);
    most = 2 * on.size() + kMorePoints;
  }
  if (on.empty()) return std::nullopt;
  CollisionPrimitive primitive;
  const cv::RotatedRect rectangle = cv::minAreaRect(on);
  cv::Point2f corners[4];
  rectangle.points(corners);
  const cv::Point2f side = corners[2] - corners[1];  // of the length size.width
  Eigen::Vector2f x(side.x, side.y);
  x = x.norm() > 0 ? x.normalized().eval() : Eigen::Vector2f::UnitX();
  primitive.pose.linear().col(0) = axes.transpose() * x;
  primitive.pose.linear().col(2) = surface.normal;
  primitive.pose.linear().col(1) = surface.normal.cross(primitive.pose.linear().col(0));
  primitive.pose.translation() =
      axes.transpose() * Eigen::Vector2f(rectangle.center.x, rectangle.center.y) -
      (surface.offset_m + kThickness_m / 2) * surface.normal;
  primitive.size_m = {std::max(rectangle.size.width, kLeastSide_m),
                      std::max(rectangle.size.height, kLeastSide_m), kThickness_m};
  return primitive;
}

}  // namespace fovea
