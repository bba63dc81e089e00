#include <algorithm>
#include <cmath>

#include "core/shape/solid.h"

namespace fovea {
namespace {

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

void DistancesOfOblong(const Solid& solid, const LevelPoints& p, SeenArray& distances) {
  const float straight = solid.half_length_m - solid.half_width_m;
  const SeenArray beyond = (AlongAxis(solid, p).abs() - straight).max(0.0F);
  const SeenArray wall =
      (beyond.square() + AcrossAxis(solid, p).square()).sqrt() - solid.half_width_m;
  distances = DistanceOfProduct(wall, DistanceOfLayer(p.h, solid.height_m));
}

// To first order in the bend.
void DistancesOfBent(const Solid& solid, const LevelPoints& p, SeenArray& distances) {
  const float reach = solid.half_length_m - solid.radius_m;
  const SeenArray along = AlongAxis(solid, p);
  const SeenArray share = (along / reach).max(-1.0F).min(1.0F);
  const SeenArray slope = 2 * solid.bend_m / reach * share;
  const SeenArray across = AcrossAxis(solid, p) - solid.bend_m * (share.square() - 0.5F);
  const SeenArray beyond = along - share * reach;
  distances =
      (beyond.square() + across.square() / (1 + slope.square()) + (p.h - solid.radius_m).square())
          .sqrt() -
      solid.radius_m;
}

void DistancesOfSphere(const Solid& solid, const LevelPoints& p, SeenArray& distances) {
  distances = ((p.x - solid.center.x()).square() + (p.y - solid.center.y()).square() +
               (p.h - solid.radius_m).square())
                  .sqrt() -
              solid.radius_m;
}

}  // namespace

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
    case Solid::Kind::kOblong:
      return DistancesOfOblong(solid, points, distances);
    case Solid::Kind::kBent:
      return DistancesOfBent(solid, points, distances);
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
