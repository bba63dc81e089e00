#include "core/shape/solid.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

constexpr float kMinSize_m = 0.002F;

// Of what is the product of two shapes, from the distances to both.
SeenArray DistanceOfProduct(const SeenArray& a, const SeenArray& b) {
  return (a.max(0.0F).square() + b.max(0.0F).square()).sqrt() + a.max(b).min(0.0F);
}

// To the layer between the plane and `height_m`.
SeenArray DistanceOfLayer(const SeenArray& h, float height_m) {
  return (h - height_m / 2).abs() - height_m / 2;
}

SeenArray AlongAxis(const Solid& solid, const LevelPoints& p) {
  return solid.along.x() * (p.x - solid.center.x()) + solid.along.y() * (p.y - solid.center.y());
}

SeenArray AcrossAxis(const Solid& solid, const LevelPoints& p) {
  return solid.along.x() * (p.y - solid.center.y()) - solid.along.y() * (p.x - solid.center.x());
}

SeenArray FromAxis(const Solid& solid, const LevelPoints& p) {
  return ((p.x - solid.center.x()).square() + (p.y - solid.center.y()).square()).sqrt();
}

// From the nearest of the faces at -half and half that the camera sees, negative before it; far
// inside where it sees none.
SeenArray BehindSeenFace(const SeenArray& place, float half, float camera) {
  if (std::abs(camera) <= half) return SeenArray::Constant(place.size(), -1);
  return (camera > 0 ? place : SeenArray(-place)) - half;
}

void DistancesOfBox(const Solid& solid, const LevelPoints& p, const Eigen::Vector3f* camera,
                    SeenArray& distances) {
  const SeenArray along = AlongAxis(solid, p), across = AcrossAxis(solid, p);
  const SeenArray u = along.abs() - solid.half_length_m;
  const SeenArray v = across.abs() - solid.half_width_m;
  const SeenArray w = DistanceOfLayer(p.h, solid.height_m);
  distances = (u.max(0.0F).square() + v.max(0.0F).square() + w.max(0.0F).square()).sqrt();
  if (camera == nullptr) {
    distances += u.max(v).max(w).min(0.0F);
    return;
  }
  const Eigen::Vector2f to = camera->head<2>() - solid.center;
  const float to_along = to.dot(solid.along);
  const float to_across = solid.along.x() * to.y() - solid.along.y() * to.x();
  distances += BehindSeenFace(along, solid.half_length_m, to_along)
                   .max(BehindSeenFace(across, solid.half_width_m, to_across))
                   .max(BehindSeenFace(p.h - solid.height_m / 2, solid.height_m / 2,
                                       camera->z() - solid.height_m / 2))
                   .min(0.0F);
}

// To first order.
SeenArray FromWallOfFrustum(const Solid& solid, const LevelPoints& p) {
  const float widens = solid.radius_m - solid.bottom_radius_m;
  const SeenArray share = p.h.max(0.0F).min(solid.height_m) / solid.height_m;
  const SeenArray radii =
      solid.bottom_radius_m + share * (widens + 4 * solid.bulge_m * (1 - share));
  const SeenArray slope = (widens + 4 * solid.bulge_m * (1 - 2 * share)) / solid.height_m;
  return (FromAxis(solid, p) - radii) / (1 + slope.square()).sqrt();
}

void DistancesOfLyingCylinder(const Solid& solid, const LevelPoints& p, SeenArray& distances) {
  const SeenArray wall =
      (AcrossAxis(solid, p).square() + (p.h - solid.radius_m).square()).sqrt() - solid.radius_m;
  distances = DistanceOfProduct(wall, AlongAxis(solid, p).abs() - solid.half_length_m);
}

void DistancesOfSphere(const Solid& solid, const LevelPoints& p, SeenArray& distances) {
  distances = ((p.x - solid.center.x()).square() + (p.y - solid.center.y()).square() +
               (p.h - solid.radius_m).square())
                  .sqrt() -
              solid.radius_m;
}

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
  return kind == Solid::Kind::kBox || kind == Solid::Kind::kLyingCylinder;
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
    case Solid::Kind::kFrustum:
      grow(moved.radius_m);
      grow(moved.bottom_radius_m);
      grow(moved.height_m);
      moved.bulge_m = std::max(0.0F, moved.bulge_m + step[next]);
      break;
  }
  return moved;
}

void SignedDistances(const Solid& solid, const LevelPoints& points, SeenArray& distances,
                     const Eigen::Vector3f* camera) {
  switch (solid.kind) {
    case Solid::Kind::kBox:
      return DistancesOfBox(solid, points, camera, distances);
    case Solid::Kind::kUprightCylinder:
      distances = DistanceOfProduct(FromAxis(solid, points) - solid.radius_m,
                                    DistanceOfLayer(points.h, solid.height_m));
      return;
    case Solid::Kind::kLyingCylinder:
      return DistancesOfLyingCylinder(solid, points, distances);
    case Solid::Kind::kSphere:
      return DistancesOfSphere(solid, points, distances);
    case Solid::Kind::kFrustum:
      distances = DistanceOfProduct(FromWallOfFrustum(solid, points),
                                    DistanceOfLayer(points.h, solid.height_m));
      return;
  }
}

SeenArray DistancesInside(const Solid& solid, const LevelPoints& points, float wall_m) {
  const SeenArray wall = solid.kind == Solid::Kind::kFrustum
                             ? FromWallOfFrustum(solid, points)
                             : SeenArray(FromAxis(solid, points) - solid.radius_m);
  return (wall + wall_m).abs().min((points.h - wall_m).abs());
}

}  // namespace fovea
