#include "tests/support/containers.h"

#include "tests/support/environment.h"
#include "tests/support/random_objects.h"

namespace fovea::scenes {
namespace {

Material OneColor(double hue, double saturation, double value) {
  return Plain(ColorOf(hue, saturation, value));
}

// Walls from `low_m` up around a rectangle, outside it.
struct Walls {
  Eigen::Vector2d half_m;
  double low_m, high_m, thickness_m;
};

void AddWall(Scene& scene, const Walls& walls, int axis, double side, const Material& material) {
  Eigen::Vector3d size_m, center;
  size_m[axis] = walls.thickness_m;
  size_m[1 - axis] = 2 * (walls.half_m[1 - axis] + walls.thickness_m);
  size_m.z() = walls.high_m - walls.low_m;
  center[axis] = side * (walls.half_m[axis] + walls.thickness_m / 2);
  center[1 - axis] = 0;
  center.z() = (walls.low_m + walls.high_m) / 2;
  scene.bodies.push_back(Block("container wall", center, size_m, material));
}

}  // namespace

void AddTote(Scene& scene, double height_m, Random& random) {
  constexpr double kThickness_m = 0.006, kRim_m = 0.02;
  const Eigen::Vector2d half_m(random.Uniform(0.2, 0.28), random.Uniform(0.14, 0.2));
  const double bottom_m = height_m + kThickness_m;
  const Walls walls = {half_m, height_m, bottom_m + random.Uniform(0.08, 0.18), kThickness_m};
  const Material plastic =
      OneColor(random.Unit(), random.Uniform(0, 0.9), random.Uniform(0.25, 0.8));
  scene.bodies.push_back(Block("container bottom", {0, 0, height_m + kThickness_m / 2},
                               {2 * half_m.x(), 2 * half_m.y(), kThickness_m}, plastic));
  const Walls rim = {half_m + Eigen::Vector2d::Constant(kThickness_m), walls.high_m - 0.008,
                     walls.high_m, kRim_m};
  for (const int axis : {0, 1}) {
    for (const double side : {-1.0, 1.0}) {
      AddWall(scene, walls, axis, side, plastic);
      AddWall(scene, rim, axis, side, plastic);
    }
  }
  scene.supports.push_back({bottom_m, {0, 0}, half_m});
}

void AddShelfBin(Scene& scene, double height_m, Random& random) {
  constexpr double kThickness_m = 0.02;
  const Eigen::Vector2d half_m(random.Uniform(0.15, 0.35), random.Uniform(0.15, 0.22));
  const Walls walls = {half_m, height_m, height_m + random.Uniform(0.22, 0.4), kThickness_m};
  const Material wood =
      OneColor(random.Uniform(0.06, 0.12), random.Uniform(0, 0.5), random.Uniform(0.35, 0.85));
  for (const double side : {-1.0, 1.0}) AddWall(scene, walls, 0, side, wood);
  AddWall(scene, walls, 1, 1, wood);
  const double width_m = 2 * (half_m.x() + kThickness_m), depth_m = 2 * half_m.y();
  for (const double z : {walls.low_m - kThickness_m / 2, walls.high_m + kThickness_m / 2}) {
    scene.bodies.push_back(Block("shelf board", {0, 0, z}, {width_m, depth_m, kThickness_m}, wood));
  }
  scene.supports.push_back({height_m, {0, 0}, half_m});
}

void AddTablet(Scene& scene, double height_m, Random& random) {
  constexpr double kThickness_m = 0.015;
  const Eigen::Vector2d half_m(random.Uniform(0.12, 0.16), random.Uniform(0.1, 0.14));
  const Material plastic =
      OneColor(random.Unit(), random.Uniform(0, 0.2), random.Uniform(0.2, 0.9));
  scene.bodies.push_back(Block("tablet", {0, 0, height_m - kThickness_m / 2},
                               {2 * half_m.x(), 2 * half_m.y(), kThickness_m}, plastic));
  const double post_m = height_m - kThickness_m;
  scene.bodies.push_back(Block("tablet post", {0.9 * half_m.x(), 0.8 * half_m.y(), post_m / 2},
                               {0.03, 0.03, post_m}, plastic));
  AddChair(scene, {-0.1, half_m.y() + 0.25}, random);
  scene.supports.push_back({height_m, {0, 0}, half_m});
}

}  // namespace fovea::scenes
