#include "core/shape/solid.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

constexpr float kMinSize_m = 0.002F;

// By half of the tangent, which is exact on every machine.
Eigen::Vector2f Turned(const Eigen::Vector2f& along, float angle_rad) {
  const float t = angle_rad / 2, scale = 1 / (1 + t * t);
  const float c = (1 - t * t) * scale, s = 2 * t * scale;
  return Eigen::Vector2f(c * along.x() - s * along.y(), s * along.x() + c * along.y()).normalized();
}

}  // namespace

float Solid::RadiusAt(float share) const {
  if (kind != Kind::kFrustum) return radius_m;
  return bottom_radius_m + share * (radius_m - bottom_radius_m + 4 * bulge_m * (1 - share));
}

float Solid::WidestRadius() const {
  if (kind != Kind::kFrustum) return radius_m;
  const float ends = std::max(radius_m, bottom_radius_m), widens = radius_m - bottom_radius_m;
  if (4 * bulge_m <= std::abs(widens)) return ends;
  return RadiusAt(0.5F + widens / (8 * bulge_m));
}

Eigen::Vector3f Solid::Size() const {
  switch (kind) {
    case Kind::kBox:
      return {2 * half_length_m, 2 * half_width_m, height_m};
    case Kind::kUprightCylinder:
      return {2 * radius_m, 2 * radius_m, height_m};
    case Kind::kLyingCylinder:
      return {2 * half_length_m, 2 * radius_m, 2 * radius_m};
    case Kind::kSphere:
      return Eigen::Vector3f::Constant(2 * radius_m);
    case Kind::kOblong:
      return {2 * half_length_m, 2 * half_width_m, height_m};
    case Kind::kBent:
      return {2 * half_length_m, 2 * radius_m + std::abs(bend_m), 2 * radius_m};
    case Kind::kFrustum:
      const float widest = WidestRadius();
      return {2 * widest, 2 * widest, height_m};
  }
  return Eigen::Vector3f::Zero();
}

int NumParameters(Solid::Kind kind) {
  switch (kind) {
    case Solid::Kind::kBox:
    case Solid::Kind::kFrustum:
    case Solid::Kind::kOblong:
    case Solid::Kind::kBent:
      return 6;
    case Solid::Kind::kLyingCylinder:
      return 5;
    case Solid::Kind::kUprightCylinder:
      return 4;
    case Solid::Kind::kSphere:
      return 3;
  }
  return 0;
}

bool HasTurn(Solid::Kind kind) {
  return kind == Solid::Kind::kBox || kind == Solid::Kind::kLyingCylinder ||
         kind == Solid::Kind::kOblong || kind == Solid::Kind::kBent;
}

Solid Moved(const Solid& solid, const ParameterVector& step) {
  Solid moved = solid;
  moved.center += step.head<2>();
  Eigen::Index next = 2;
  if (HasTurn(solid.kind)) moved.along = Turned(solid.along, step[next++]);
  const auto grow = [&](float& size_m) { size_m = std::max(size_m + step[next++], kMinSize_m); };
  switch (solid.kind) {
    case Solid::Kind::kBox:
      grow(moved.half_length_m);
      grow(moved.half_width_m);
      grow(moved.height_m);
      break;
    case Solid::Kind::kUprightCylinder:
      grow(moved.radius_m);
      grow(moved.height_m);
      break;
    case Solid::Kind::kLyingCylinder:
      grow(moved.half_length_m);
      grow(moved.radius_m);
      break;
    case Solid::Kind::kSphere:
      grow(moved.radius_m);
      break;
    case Solid::Kind::kOblong:
      grow(moved.half_length_m);
      grow(moved.half_width_m);
      grow(moved.height_m);
      moved.half_width_m = std::min(moved.half_width_m, moved.half_length_m);
      break;
    case Solid::Kind::kBent:
      grow(moved.half_length_m);
      grow(moved.radius_m);
      moved.half_length_m = std::max(moved.half_length_m, moved.radius_m + kMinSize_m);
      // No wider than it is long.
      moved.bend_m =
          std::clamp(moved.bend_m + step[next], -2 * (moved.half_length_m - moved.radius_m),
                     2 * (moved.half_length_m - moved.radius_m));
      break;
    case Solid::Kind::kFrustum:
      grow(moved.radius_m);
      grow(moved.bottom_radius_m);
      grow(moved.height_m);
      moved.bulge_m = std::max(0.0F, moved.bulge_m + step[next]);
      break;
  }
  return moved;
}

}  // namespace fovea
