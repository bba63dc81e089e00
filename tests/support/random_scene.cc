#include "tests/support/random_scene.h"

#include <algorithm>
#include <numbers>
#include <opencv2/core.hpp>

#include "tests/support/containers.h"
#include "tests/support/environment.h"
#include "tests/support/household_objects.h"
#include "tests/support/placement.h"
#include "tests/support/random.h"
#include "tests/support/random_objects.h"
#include "tests/support/render.h"
#include "tests/support/scene_recipes.h"

namespace fovea::scenes {
namespace {

using enum Surfaces;
using enum Objects;

double Radians(double degrees) { return degrees * std::numbers::pi / 180; }

// Adds room, tables and furniture.
void Furnish(Scene& scene, const Recipe& recipe, Random& random) {
  const double wall_m = random.Uniform(1.6, 2.3);
  AddRoom(scene, wall_m, random);
  const double height_m = random.Uniform(0.68, 0.8);
  switch (recipe.surfaces) {
    case kTable:
      AddTable(scene, {0, 0}, {random.Uniform(0.9, 1.5), random.Uniform(0.65, 0.85)}, height_m,
               random);
      break;
    case kTwoTables:
      AddTable(scene, {-0.42, 0}, {0.8, 0.7}, height_m, random);
      AddTable(scene, {0.4, 0.1}, {0.7, 0.6}, height_m - random.Uniform(0.12, 0.3), random);
      break;
    case kFloor:
      scene.supports.push_back({0, {0, 0}, {1.2, 1.2}});
      break;
    case kTote:
      AddTable(scene, {0, 0}, {1.3, 0.85}, height_m, random);
      scene.supports.clear();
      AddTote(scene, height_m, random);
      break;
    case kShelfBin:
      AddShelfBin(scene, height_m, random);
      break;
    case kTablet:
      AddTablet(scene, height_m, random);
      break;
  }
  if (!recipe.furnished) return;
  const bool on_floor = recipe.surfaces == kFloor;
  AddChair(scene, {random.Uniform(-0.6, 0.6), on_floor ? 0.95 : 0.75}, random);
  AddCabinet(scene, {random.Uniform(-1.0, 1.0), wall_m - 0.2}, random);
}

Body DrawObject(const Recipe& recipe, Random& random) {
  switch (recipe.objects) {
    case kHousehold:
      return RandomHouseholdObject(random);
    case kSupplies:
      return RandomSupply(random);
    case kTools:
      return RandomTool(random);
    case kLuggage:
      return RandomLuggage(random);
    case kMixed:
      return random.Chance(0.5) ? RandomHouseholdObject(random) : RandomSupply(random);
    case kSimple:
      break;
  }
  return RandomObject(random, recipe.surfaces == kFloor ? 1.4 : 1.0);
}

void AddObjects(Scene& scene, const Recipe& recipe, int count, Random& random) {
  for (int i = 0; i < count; ++i) {
    const Area area = {random.Pick(scene.supports), recipe.radius_m};
    const Body object = DrawObject(recipe, random);
    const double choice = random.Unit();
    if (choice < recipe.beside && PlaceBeside(scene, object, area, random)) continue;
    if (choice > 1 - recipe.on_top && PlaceOnTop(scene, object, random)) continue;
    PlaceFreely(scene, object, area, 0.012, random);
  }
}

void PointCamera(Scene& scene, const Recipe& recipe, Random& random) {
  Eigen::Vector3d target(0, 0, scene.supports.at(0).height_m + 0.05);
  target.head<2>() += Eigen::Vector2d(random.Uniform(-0.04, 0.04), random.Uniform(-0.04, 0.04));
  scene.camera.world_from_camera = LookAt(
      target, recipe.distance.Draw(random), Radians(recipe.pitch_deg.Draw(random)),
      Radians(random.Uniform(-25, 25)), Radians(random.Uniform(-recipe.roll_deg, recipe.roll_deg)));
}

void Illuminate(Scene& scene, Random& random) {
  const double elevation = Radians(random.Uniform(55, 75)), azimuth = random.Uniform(0, 6.28);
  scene.light.towards = {std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
  scene.light.strength = random.Uniform(0.7, 0.95);
  scene.light.ambient = random.Uniform(0.4, 0.55);
}

// Whether every object can be seen, judged on a small picture.
bool AllVisible(const Scene& scene) {
  constexpr int kFewestPixels = 20;  // of 160×120
  Scene small = scene;
  small.camera = CameraOfSize({160, 120});
  small.camera.world_from_camera = scene.camera.world_from_camera;
  const cv::Mat labels = RenderLabels(small);
  const auto objects = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                     [](const Body& body) { return body.is_object; });
  for (int k = 1; k <= objects; ++k) {
    if (cv::countNonZero(labels == k) < kFewestPixels) return false;
  }
  return true;
}

Scene Generate(const Recipe& recipe, std::uint64_t seed, const cv::Size& size_px) {
  Random random(seed);
  Scene scene;
  scene.camera = CameraOfSize(size_px);
  Furnish(scene, recipe, random);
  Illuminate(scene, random);
  PointCamera(scene, recipe, random);

  const int count = random.Integer(recipe.fewest, recipe.most);
  for (int attempt = 0;; ++attempt) {
    constexpr int kAttemptsPerCount = 10;  // then one object less
    Scene filled = scene;
    AddObjects(filled, recipe, std::max(1, count - attempt / kAttemptsPerCount), random);
    if (count == 0) return scene;
    const bool any = filled.bodies.size() > scene.bodies.size();
    if (any && AllVisible(filled)) return filled;
  }
}

}  // namespace

const std::vector<std::string>& SceneKinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    names.reserve(Recipes().size());
    for (const Recipe& recipe : Recipes()) names.emplace_back(recipe.kind);
    return names;
  }();
  return kinds;
}

Scene RandomScene(std::string_view kind, std::uint64_t seed, const cv::Size& size_px) {
  const Recipe& recipe = RecipeOf(kind);
  const auto kind_number = static_cast<std::uint64_t>(&recipe - Recipes().data());
  return Generate(recipe, seed * 64 + kind_number, size_px);  // other objects in every kind
}

Scene RandomScene(const Recipe& recipe, std::uint64_t seed, const cv::Size& size_px) {
  return Generate(recipe, seed * 64 + 63, size_px);
}

}  // namespace fovea::scenes
