#include "core/planning/grown_primitive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fovea {
namespace {

using Kind = CollisionPrimitive::Kind;

// At least `value`, and so much that few of them are more: a hundredth over all sides.
float MostOf(std::vector<float>& values, float value, std::size_t num_sides) {
  const std::size_t few = values.size() / (100 * num_sides);
  const auto last = values.end() - 1 - static_cast<std::ptrdiff_t>(few);
  std::nth_element(values.begin(), last, values.end());
  return std::max(*last, value);
}

template <typename Measure>
std::vector<float> Measured(const std::vector<Eigen::Vector3f>& points, const Measure& measure) {
  std::vector<float> values(points.size());
  std::transform(points.begin(), points.end(), values.begin(), measure);
  return values;
}

void GrowAlong(int axis, const std::vector<Eigen::Vector3f>& points,
               CollisionPrimitive& primitive) {
  const std::size_t num_sides = primitive.kind == Kind::kCylinder ? 3 : 6;
  std::vector<float> values = Measured(points, [&](const auto& p) { return p[axis]; });
  const float half = primitive.size_m[axis] / 2;
  const float high = MostOf(values, half, num_sides);
  for (float& value : values) value = -value;
  const float low = -MostOf(values, half, num_sides);
  primitive.size_m[axis] = high - low;
  primitive.pose.translation() += primitive.pose.linear().col(axis) * ((low + high) / 2);
}

}  // namespace

float OutsideBy_m(const CollisionPrimitive& primitive, const Eigen::Vector3f& point) {
  const Eigen::Vector3f p = primitive.pose.inverse(Eigen::Isometry) * point;
  const Eigen::Vector3f half = primitive.size_m / 2;
  switch (primitive.kind) {
    case Kind::kSphere:
      return std::max(0.0F, p.norm() - half.x());
    case Kind::kCylinder:
      return std::max({0.0F, p.head<2>().norm() - half.x(), std::abs(p.z()) - half.z()});
    case Kind::kBox:
      break;
  }
  return (p.cwiseAbs() - half).cwiseMax(0).maxCoeff();
}

float VolumeOf(const CollisionPrimitive& primitive) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float around = primitive.size_m.prod();
  if (primitive.kind == Kind::kSphere) return kPi / 6 * around;
  return primitive.kind == Kind::kCylinder ? kPi / 4 * around : around;
}

CollisionPrimitive GrownTo(const std::vector<ColoredPoint>& cloud, CollisionPrimitive primitive) {
  if (cloud.empty()) return primitive;
  const Eigen::Isometry3f from_camera = primitive.pose.inverse(Eigen::Isometry);
  std::vector<Eigen::Vector3f> points(cloud.size());
  std::transform(cloud.begin(), cloud.end(), points.begin(), [&](const ColoredPoint& p) {
    return from_camera * Eigen::Vector3f(p.x, p.y, p.z);
  });
  if (primitive.kind == Kind::kSphere) {
    std::vector<float> values = Measured(points, [](const auto& p) { return p.norm(); });
    primitive.size_m.setConstant(2 * MostOf(values, primitive.size_m.x() / 2, 1));
    return primitive;
  }
  GrowAlong(2, points, primitive);
  if (primitive.kind == Kind::kCylinder) {
    auto values = Measured(points, [](const auto& p) { return p.template head<2>().norm(); });
    primitive.size_m.head<2>().setConstant(2 * MostOf(values, primitive.size_m.x() / 2, 3));
  } else {
    GrowAlong(0, points, primitive);
    GrowAlong(1, points, primitive);
  }
  return primitive;
}

}  // namespace fovea
