#include "tests/support/placement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/random_objects.h"

namespace fovea::scenes {
namespace {

constexpr int kTrials = 60;
constexpr double kFullTurn = 2 * std::numbers::pi;

bool IsClear(const Scene& scene, const Body& object, double gap_m) {
  return std::none_of(scene.bodies.begin(), scene.bodies.end(),
                      [&](const Body& other) { return Overlap(object, other, gap_m); });
}

bool IsInside(const Body& object, const Area& area) {
  constexpr double kMargin_m = 0.01;
  const Support& support = area.support;
  for (const Eigen::Vector2d& corner : Footprint(object)) {
    const Eigen::Vector2d offset = corner - support.center;
    const Eigen::Vector2d room =
        support.half_size_m - Eigen::Vector2d::Constant(kMargin_m) - offset.cwiseAbs();
    if (room.minCoeff() < 0 || offset.norm() > area.radius_m + 0.15) return false;
  }
  return true;
}

bool AddIf(bool fits, Scene& scene, const Body& object) {
  if (fits) scene.bodies.push_back(object);
  return fits;
}

Eigen::Vector2d Direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

double YawOf(const Body& body) {
  const auto axes = body.world_from_body.linear();
  return std::atan2(axes(1, 1), axes(0, 1)) - std::numbers::pi / 2;  // y is never vertical
}

// The indices of the objects for which `holds`.
template <typename Predicate>
std::vector<std::size_t> ObjectsWhere(const Scene& scene, const Predicate& holds) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].is_object && holds(scene.bodies[i])) found.push_back(i);
  }
  return found;
}

// The object moved along `direction` from the neighbour's centre until the two just touch.
Body SlidAgainst(const Body& neighbour, const Body& object, const Eigen::Vector2d& direction,
                 double height_m) {
  const Eigen::Vector2d center = neighbour.world_from_body.translation().head<2>();
  double inside_m = 0, outside_m = 1;
  Body moved = object;
  while (outside_m - inside_m > 5e-5) {
    const double middle_m = (inside_m + outside_m) / 2;
    Rest(moved, center + middle_m * direction, height_m, 0);
    (Overlap(moved, neighbour) ? inside_m : outside_m) = middle_m;
  }
  Rest(moved, center + outside_m * direction, height_m, 0);
  return moved;
}

}  // namespace

bool PlaceFreely(Scene& scene, Body object, const Area& area, double gap_m, Random& random) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const double radius_m = area.radius_m * std::sqrt(random.Unit());
    const Eigen::Vector2d at =
        area.support.center + radius_m * Direction(random.Uniform(0, kFullTurn));
    Rest(object, at, area.support.height_m, random.Uniform(0, kFullTurn));
    const bool fits = IsInside(object, area) && IsClear(scene, object, gap_m);
    if (AddIf(fits, scene, object)) return true;
  }
  return false;
}

bool PlaceBeside(Scene& scene, Body object, const Area& area, Random& random) {
  const double height_m = area.support.height_m;
  const auto neighbours = ObjectsWhere(scene, [&](const Body& body) {
    return std::abs(VerticalExtent(body).first - height_m) < 1e-9;
  });
  for (int trial = 0; trial < kTrials && !neighbours.empty(); ++trial) {
    const Body& neighbour = scene.bodies[random.Pick(neighbours)];
    const bool flush = random.Chance(0.6);
    const double yaw = flush ? YawOf(neighbour) - YawOf(object) : random.Uniform(0, kFullTurn);
    Rest(object, {0, 0}, height_m, yaw);
    const double side = flush ? YawOf(neighbour) + random.Integer(0, 3) * kFullTurn / 4
                              : random.Uniform(0, kFullTurn);
    const Body moved = SlidAgainst(neighbour, object, Direction(side), height_m);
    if (AddIf(IsInside(moved, area) && IsClear(scene, moved, 0), scene, moved)) return true;
  }
  return false;
}

bool PlaceOnTop(Scene& scene, Body object, Random& random) {
  constexpr double kHighest_m = 0.4;  // of a stack
  const auto carriers = ObjectsWhere(scene, HasFlatTop);
  for (int trial = 0; trial < kTrials && !carriers.empty(); ++trial) {
    const Body& carrier = scene.bodies[random.Pick(carriers)];
    const auto [low, top] = VerticalExtent(carrier);
    const double reach_m = 0.15 * carrier.shape.size_m.head<2>().minCoeff();
    const Eigen::Vector2d at = carrier.world_from_body.translation().head<2>() +
                               reach_m * Direction(random.Uniform(0, kFullTurn));
    Rest(object, at, top, random.Uniform(0, kFullTurn));
    const bool steady = object.shape.size_m.maxCoeff() < 1.3 * carrier.shape.size_m.maxCoeff();
    const bool low_enough =
        VerticalExtent(object).second - scene.supports.at(0).height_m < kHighest_m;
    if (AddIf(steady && low_enough && IsClear(scene, object, 0), scene, object)) return true;
  }
  return false;
}

}  // namespace fovea::scenes
