#include "tests/support/environment.h"

#include "tests/support/random_objects.h"

namespace fovea::scenes {
namespace {

Material RandomWood(Random& random) {
  const Eigen::Vector3d color =
      ColorOf(random.Uniform(0.06, 0.1), random.Uniform(0.2, 0.6), random.Uniform(0.45, 0.85));
  return {Pattern::kWood, color, 0.6 * color, random.Uniform(0.015, 0.04),
          static_cast<std::uint32_t>(random.Bits())};
}

Material RandomTableTop(Random& random) {
  if (random.Chance(0.6)) return RandomWood(random);
  const double grey = random.Uniform(0.25, 0.7);
  return {Pattern::kNoise, Eigen::Vector3d::Constant(grey), Eigen::Vector3d::Constant(0.8 * grey),
          0.01, static_cast<std::uint32_t>(random.Bits())};
}

Material RandomFloor(Random& random) {
  if (random.Chance(0.4)) return RandomWood(random);
  const Eigen::Vector3d color =
      ColorOf(random.Unit(), random.Uniform(0, 0.3), random.Uniform(0.4, 0.75));
  const bool tiles = random.Chance(0.4);
  return {tiles ? Pattern::kChecker : Pattern::kNoise, color, (tiles ? 0.8 : 0.6) * color,
          tiles ? 0.3 : 0.008, static_cast<std::uint32_t>(random.Bits())};
}

// Four upright posts under the corners of a rectangle.
void AddLegs(Scene& scene, const std::string& name, const Eigen::Vector2d& center,
             const Eigen::Vector2d& half_m, double height_m, const Material& material) {
  constexpr double kWidth_m = 0.045;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const Eigen::Vector2d at = center + Eigen::Vector2d(x * half_m.x(), y * half_m.y());
      scene.bodies.push_back(
          Block(name, {at.x(), at.y(), height_m / 2}, {kWidth_m, kWidth_m, height_m}, material));
    }
  }
}

}  // namespace

Body Block(const std::string& name, const Eigen::Vector3d& center, const Eigen::Vector3d& size_m,
           const Material& material) {
  Body body;
  body.name = name;
  body.shape.size_m = size_m;
  body.world_from_body.translation() = center;
  body.material = material;
  return body;
}

void AddRoom(Scene& scene, double distance_m, Random& random) {
  constexpr double kExtent_m = 12, kHeight_m = 2.4, kThickness_m = 0.1;
  scene.bodies.push_back(Block("floor", {0, 0, -kThickness_m / 2},
                               {kExtent_m, kExtent_m, kThickness_m}, RandomFloor(random)));
  const Material paint =
      Plain(ColorOf(random.Unit(), random.Uniform(0, 0.2), random.Uniform(0.75, 0.95)));
  const double side = random.Chance(0.5) ? 1 : -1;
  const double beyond_m = distance_m + kThickness_m / 2;
  scene.bodies.push_back(
      Block("wall", {0, beyond_m, kHeight_m / 2}, {kExtent_m, kThickness_m, kHeight_m}, paint));
  scene.bodies.push_back(Block("wall", {side * (beyond_m + 0.3), 0, kHeight_m / 2},
                               {kThickness_m, kExtent_m, kHeight_m}, paint));
}

void AddTable(Scene& scene, const Eigen::Vector2d& center, const Eigen::Vector2d& size_m,
              double height_m, Random& random) {
  constexpr double kThickness_m = 0.03;
  scene.bodies.push_back(Block("table", {center.x(), center.y(), height_m - kThickness_m / 2},
                               {size_m.x(), size_m.y(), kThickness_m}, RandomTableTop(random)));
  AddLegs(scene, "table leg", center, size_m / 2 - Eigen::Vector2d::Constant(0.05),
          height_m - kThickness_m, RandomWood(random));
  scene.supports.push_back({height_m, center, size_m / 2});
}

void AddChair(Scene& scene, const Eigen::Vector2d& center, Random& random) {
  constexpr double kSeat_m = 0.44, kWidth_m = 0.42, kThickness_m = 0.04;
  const Material wood = RandomWood(random);
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(kWidth_m / 2 - 0.03);
  AddLegs(scene, "chair leg", center, half, kSeat_m, wood);
  scene.bodies.push_back(Block("chair seat", {center.x(), center.y(), kSeat_m + kThickness_m / 2},
                               {kWidth_m, kWidth_m, kThickness_m}, wood));
  scene.bodies.push_back(Block("chair back", {center.x(), center.y() + kWidth_m / 2, 0.7},
                               {kWidth_m, 0.03, 0.44}, wood));
}

void AddCabinet(Scene& scene, const Eigen::Vector2d& center, Random& random) {
  const Eigen::Vector3d size(random.Uniform(0.5, 0.9), 0.4, random.Uniform(0.7, 1.6));
  scene.bodies.push_back(
      Block("cabinet", {center.x(), center.y(), size.z() / 2}, size, RandomWood(random)));
}

}  // namespace fovea::scenes
