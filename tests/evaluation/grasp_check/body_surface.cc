#include "tests/evaluation/grasp_check/body_surface.h"

#include <cmath>
#include <numbers>

namespace fovea::evaluation {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using scenes::Shape;
using scenes::ShapeKind;

// Each side of a grid of rays keeps what faces it most, so that points are evenly dense.
const double kFacing = 1 / std::sqrt(3.0) - 1e-9;

// Where rays along `axis`, to its positive end or its negative one, first meet the shape. They
// start on the plane at `from` of that axis.
void AddHits(const Shape& shape, int axis, bool positive, double from, double spacing_m,
             Points& points) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Eigen::Vector3d direction = (positive ? 1 : -1) * Eigen::Vector3d::Unit(axis);
  const auto steps = [&](int i) { return std::max(1.0, std::ceil(shape.size_m[i] / spacing_m)); };
  const double num_u = steps(u), num_v = steps(v);
  Eigen::Vector3d origin;
  origin[axis] = from;
  for (double i = 0; i < num_u; ++i) {
    origin[u] = ((i + 0.5) / num_u - 0.5) * shape.size_m[u];
    for (double j = 0; j < num_v; ++j) {
      origin[v] = ((j + 0.5) / num_v - 0.5) * shape.size_m[v];
      const scenes::Ray ray = {origin, direction};
      const auto hit = Intersect(shape, ray);
      if (hit && -hit->normal.dot(direction) >= kFacing) points.push_back(ray.At(hit->t));
    }
  }
}

Points OfParts(const Shape& compound, const auto& of_part) {
  Points points;
  for (const scenes::Part& part : compound.parts) {
    for (const Eigen::Vector3d& p : of_part(part.shape)) points.push_back(part.shape_from_part * p);
  }
  return points;
}

void AddCircle(double radius, double z, Points& points) {
  constexpr int kCorners = 96;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

Points OfSphere(double radius) {
  constexpr int kRings = 48;
  Points points;
  for (int i = 0; i <= kRings; ++i) {
    const double angle = std::numbers::pi * i / kRings;
    AddCircle(radius * std::sin(angle), radius * std::cos(angle), points);
  }
  return points;
}

Points Corners(const Eigen::Vector3d& half) {
  Points points;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      for (const double z : {-1, 1}) points.push_back(half.cwiseProduct(Eigen::Vector3d(x, y, z)));
    }
  }
  return points;
}

double Volume(const Shape& part) {
  const double bounds = part.size_m.prod();
  switch (part.kind) {
    case ShapeKind::kCylinder:
      return bounds * std::numbers::pi / 4;
    case ShapeKind::kSphere:
      return bounds * std::numbers::pi / 6;
    case ShapeKind::kCup:
    case ShapeKind::kBowl: {  // a thin wall and its bottom
      const double d = part.size_m.x();
      return part.wall_m * std::numbers::pi * d * (part.size_m.z() + d / 4);
    }
    default:
      return bounds;
  }
}

}  // namespace

Points SampleSurface(const Shape& shape, double spacing_m) {
  if (shape.kind == ShapeKind::kCompound) {
    return OfParts(shape, [&](const Shape& part) { return SampleSurface(part, spacing_m); });
  }
  Points points;
  for (const int axis : {0, 1, 2}) {
    const double outside = shape.size_m[axis] / 2 + 0.01;
    AddHits(shape, axis, true, -outside, spacing_m, points);
    AddHits(shape, axis, false, outside, spacing_m, points);
  }
  if (shape.kind != ShapeKind::kCup && shape.kind != ShapeKind::kBowl) return points;
  for (const int axis : {0, 1}) {
    for (const bool positive : {false, true}) AddHits(shape, axis, positive, 0, spacing_m, points);
  }
  return points;
}

Points HullPoints(const Shape& shape) {
  const Eigen::Vector3d half = shape.size_m / 2;
  Points points;
  switch (shape.kind) {
    case ShapeKind::kCompound:
      return OfParts(shape, HullPoints);
    case ShapeKind::kBox:
      return Corners(half);
    case ShapeKind::kSphere:
      return OfSphere(half.x());
    case ShapeKind::kCushion:
      return SampleSurface(shape, 0.002);
    case ShapeKind::kCylinder:
    case ShapeKind::kCup:
    case ShapeKind::kBowl:
      AddCircle(half.x(), half.z(), points);
      AddCircle(shape.kind == ShapeKind::kBowl ? half.x() / 2 : half.x(), -half.z(), points);
      return points;
  }
  return points;
}

Eigen::Vector3d CenterOfMass(const Shape& shape) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double volume = 0;
  for (const scenes::Part& part : shape.parts) {
    sum += Volume(part.shape) * part.shape_from_part.translation();
    volume += Volume(part.shape);
  }
  return volume > 0 ? (sum / volume).eval() : sum;
}

}  // namespace fovea::evaluation
