#include "tests/support/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tests/support/cushion.h"

namespace fovea::scenes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The part of a ray within a convex set, with the outward normals at its two ends.
struct Span {
  double in = -kInfinity;
  double out = kInfinity;
  Eigen::Vector3d normal_in = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_out = Eigen::Vector3d::Zero();

  bool Empty() const { return !(in < out); }
};

const Span kNothing = {kInfinity, -kInfinity, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

Span operator&(const Span& a, const Span& b) {
  Span both = a;
  if (b.in > a.in) std::tie(both.in, both.normal_in) = std::tie(b.in, b.normal_in);
  if (b.out < a.out) std::tie(both.out, both.normal_out) = std::tie(b.out, b.normal_out);
  return both;
}

Span Within(const Ray& ray, int axis, double low, double high) {
  const double o = ray.origin[axis], d = ray.direction[axis];
  if (d == 0) return low < o && o < high ? Span{} : kNothing;
  const Eigen::Vector3d up = Eigen::Vector3d::Unit(axis);
  const double to_low = (low - o) / d, to_high = (high - o) / d;
  return d > 0 ? Span{to_low, to_high, -up, up} : Span{to_high, to_low, up, -up};
}

// The points whose distance from `center`, after scaling by `axes`, is below the radius: a sphere
// for (1, 1, 1), an infinite cylinder along z for (1, 1, 0).
Span Round(const Ray& ray, const Eigen::Vector3d& axes, const Eigen::Vector3d& center,
           double radius) {
  const Eigen::Vector3d o = axes.cwiseProduct(ray.origin - center);
  const Eigen::Vector3d d = axes.cwiseProduct(ray.direction);
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - radius * radius;
  if (a == 0) return c < 0 ? Span{} : kNothing;
  const double discriminant = b * b - a * c;
  if (discriminant <= 0) return kNothing;
  const double root = std::sqrt(discriminant);
  const double in = (-b - root) / a, out = (-b + root) / a;
  return {in, out, (o + in * d) / radius, (o + out * d) / radius};
}

const Eigen::Vector3d kBall(1, 1, 1), kTube(1, 1, 0);

// A convex body and the convex cavity cut out of it.
std::pair<Span, Span> BodyAndCavity(const Shape& shape, const Ray& ray) {
  const Eigen::Vector3d half = shape.size_m / 2;
  const double radius = half.x();
  const Span height = Within(ray, 2, -half.z(), half.z());
  const auto inside = [&] { return Within(ray, 2, -half.z() + shape.wall_m, kInfinity); };
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  switch (shape.kind) {
    case ShapeKind::kBox:
      return {height & Within(ray, 0, -half.x(), half.x()) & Within(ray, 1, -half.y(), half.y()),
              kNothing};
    case ShapeKind::kCylinder:
      return {height & Round(ray, kTube, origin, radius), kNothing};
    case ShapeKind::kSphere:
      return {Round(ray, kBall, origin, radius), kNothing};
    case ShapeKind::kCup:
      return {height & Round(ray, kTube, origin, radius),
              inside() & Round(ray, kTube, origin, radius - shape.wall_m)};
    case ShapeKind::kBowl: {
      // The sphere through the rim (radius at the top) and the foot (radius / 2 at the bottom).
      const double z = 0.75 * radius * radius / (4 * half.z());
      const double sphere = std::hypot(radius, half.z() - z);
      const Eigen::Vector3d center(0, 0, z);
      return {height & Round(ray, kBall, center, sphere),
              inside() & Round(ray, kBall, center, sphere - shape.wall_m)};
    }
    case ShapeKind::kCushion:  // is not convex
    case ShapeKind::kCompound:
      break;
  }
  return {kNothing, kNothing};
}

// Where the ray's line is within the bounding box; the first is larger if it nowhere is.
std::pair<double, double> WithinBounds(const Shape& shape, const Ray& ray) {
  const Eigen::Array3d half = shape.size_m.array() / 2;
  const Eigen::Array3d inverse = ray.direction.array().inverse();
  const Eigen::Array3d low = (-half - ray.origin.array()) * inverse;
  const Eigen::Array3d high = (half - ray.origin.array()) * inverse;
  return {low.min(high).maxCoeff(), low.max(high).minCoeff()};
}

std::optional<Hit> IntersectParts(const Shape& compound, const Ray& ray, double max_t) {
  std::optional<Hit> nearest;
  for (const Part& part : compound.parts) {
    const Eigen::Isometry3d part_from_shape = part.shape_from_part.inverse();
    const Ray in_part = {part_from_shape * ray.origin, part_from_shape.linear() * ray.direction};
    const auto hit = Intersect(part.shape, in_part, nearest ? nearest->t : max_t);
    if (hit) nearest = {hit->t, part.shape_from_part.linear() * hit->normal, part.material};
  }
  return nearest;
}

// Half the extents of the box around a part, along the axes of its shape.
Eigen::Vector3d HalfExtents(const Part& part) {
  const Eigen::Matrix3d axes = part.shape_from_part.linear();
  Eigen::Vector3d half = part.shape.size_m / 2;
  if (part.shape.kind == ShapeKind::kSphere) return half;
  if (!IsRound(part.shape.kind)) return axes.cwiseAbs() * half;
  const Eigen::Array3d z = axes.col(2).array();
  return half.z() * z.abs() + half.x() * (1 - z.square()).max(0).sqrt();
}

}  // namespace

std::optional<Hit> Intersect(const Shape& shape, const Ray& ray, double max_t) {
  const auto [from, to] = WithinBounds(shape, ray);
  if (from > to || to <= 0 || from >= max_t) return std::nullopt;  // most rays
  if (shape.kind == ShapeKind::kCompound) return IntersectParts(shape, ray, max_t);
  if (shape.kind == ShapeKind::kCushion)
    return IntersectCushion(shape, ray, std::max(0.0, from), std::min(to, max_t));
  const auto [body, cavity] = BodyAndCavity(shape, ray);
  if (body.Empty() || body.out <= 0) return std::nullopt;
  const double enter = std::max(body.in, 0.0);
  const bool in_cavity = !cavity.Empty() && cavity.in <= enter && enter < cavity.out;
  if (in_cavity && cavity.out >= body.out) return std::nullopt;  // out again by the open top
  const Hit hit = in_cavity ? Hit{cavity.out, -cavity.normal_out} : Hit{body.in, body.normal_in};
  return hit.t > 0 && hit.t < max_t ? std::optional(hit) : std::nullopt;
}

Shape CompoundOf(std::vector<Part> parts) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(kInfinity), high = -low;
  for (const Part& part : parts) {
    const Eigen::Vector3d center = part.shape_from_part.translation(), half = HalfExtents(part);
    low = low.cwiseMin(center - half);
    high = high.cwiseMax(center + half);
  }
  for (Part& part : parts) part.shape_from_part.pretranslate(-(low + high) / 2);
  return {ShapeKind::kCompound, high - low, 0, std::move(parts)};
}

bool IsRound(ShapeKind kind) {
  return kind != ShapeKind::kBox && kind != ShapeKind::kCushion && kind != ShapeKind::kCompound;
}

}  // namespace fovea::scenes
