#include "tests/support/shape.h"

#include <cmath>
#include <limits>
#include <utility>

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

Span Slab(const Ray& ray, int axis, double low, double high) {
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
  const Span height = Slab(ray, 2, -half.z(), half.z());
  const auto inside = [&] { return Slab(ray, 2, -half.z() + shape.wall_m, kInfinity); };
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  switch (shape.kind) {
    case ShapeKind::kBox:
      return {height & Slab(ray, 0, -half.x(), half.x()) & Slab(ray, 1, -half.y(), half.y()),
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
  }
  return {kNothing, kNothing};
}

// The test of the bounding box alone, which most rays fail.
bool MissesBounds(const Shape& shape, const Ray& ray, double max_t) {
  const Eigen::Array3d half = shape.size_m.array() / 2;
  const Eigen::Array3d inverse = ray.direction.array().inverse();
  const Eigen::Array3d low = (-half - ray.origin.array()) * inverse;
  const Eigen::Array3d high = (half - ray.origin.array()) * inverse;
  const double in = low.min(high).maxCoeff(), out = low.max(high).minCoeff();
  return in > out || out <= 0 || in >= max_t;
}

}  // namespace

std::optional<Hit> Intersect(const Shape& shape, const Ray& ray, double max_t) {
  if (MissesBounds(shape, ray, max_t)) return std::nullopt;
  const auto [body, cavity] = BodyAndCavity(shape, ray);
  if (body.Empty() || body.out <= 0) return std::nullopt;
  const double enter = std::max(body.in, 0.0);
  const bool in_cavity = !cavity.Empty() && cavity.in <= enter && enter < cavity.out;
  if (in_cavity && cavity.out >= body.out) return std::nullopt;  // out again by the open top
  const Hit hit = in_cavity ? Hit{cavity.out, -cavity.normal_out} : Hit{body.in, body.normal_in};
  return hit.t > 0 && hit.t < max_t ? std::optional(hit) : std::nullopt;
}

bool IsRound(ShapeKind kind) { return kind != ShapeKind::kBox; }

}  // namespace fovea::scenes
