#include "core/shape/solid_distances.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

template <typename Distance>
void SetDistances(const Distance& distance, const LevelPoints& points, SeenArray& distances) {
  distances.resize(points.size());
  RunInWidestRegisters([&] {
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      distances[i] = distance(points.x[i], points.y[i], points.h[i]);
    }
  });
}

}  // namespace

void SignedDistances(const Solid& solid, const LevelPoints& points, SeenArray& distances,
                     const Eigen::Vector3f* camera) {
  if (solid.kind == Solid::Kind::kBox && camera != nullptr) {
    return SetDistances(DistanceOfSeenBox(solid, *camera), points, distances);
  }
  WithDistanceFrom(solid, [&](const auto& distance) { SetDistances(distance, points, distances); });
}

SeenArray DistancesInside(const Solid& solid, const LevelPoints& points, float wall_m) {
  SeenArray distances;
  const auto set_from_wall = [&](const auto& hollow) {
    const auto inside = [&](float x, float y, float h) {
      return std::min(std::abs(hollow.FromWall(x, y, h) + wall_m), std::abs(h - wall_m));
    };
    SetDistances(inside, points, distances);
  };
  if (solid.kind == Solid::Kind::kFrustum) {
    set_from_wall(DistanceOfFrustum(solid));
  } else {
    set_from_wall(DistanceOfUprightCylinder(solid));
  }
  return distances;
}

}  // namespace fovea
