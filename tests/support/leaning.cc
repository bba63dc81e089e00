#include "tests/support/leaning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/random.h"
#include "tests/support/random_objects.h"

namespace fovea::scenes {
namespace {

constexpr double kRadian = std::numbers::pi / 180;

struct Board {
  double length_m, width_m, thickness_m;  // up the slope, along the wall, across
};

// With its lower back edge on the support at the height of the box's bottom, its back touching the
// box; `out` is the side of the box that it leans against, level.
Body Leaning(const Board& board, const Body& box, const Eigen::Vector3d& out, double half_depth_m,
             double tilt_rad) {
  const auto [bottom, top] = VerticalExtent(box);
  const double rise = board.length_m * std::cos(tilt_rad), height = top - bottom;
  // It touches the upper edge of the box, or ends against its side.
  const double foot_m = std::tan(tilt_rad) * std::min(height, rise);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d axes;  // across, along the wall, up the slope
  axes.col(0) = std::cos(tilt_rad) * out + std::sin(tilt_rad) * up;
  axes.col(2) = std::cos(tilt_rad) * up - std::sin(tilt_rad) * out;
  axes.col(1) = axes.col(2).cross(axes.col(0));
  Body body;
  body.name = "leaning";
  body.shape.size_m = {board.thickness_m, board.width_m, board.length_m};
  body.is_object = true;
  body.world_from_body.linear() = axes;
  Eigen::Vector3d foot = box.world_from_body.translation() + (half_depth_m + foot_m) * out;
  foot.z() = bottom;
  body.world_from_body.translation() =
      foot + axes.col(2) * board.length_m / 2 + axes.col(0) * board.thickness_m / 2;
  return body;
}

// An upright box around it, for what it must not touch.
Body AroundIt(const Body& leaning, const Eigen::Vector3d& out) {
  const Eigen::Vector3d half = leaning.shape.size_m / 2;
  const Eigen::Matrix3d spread = leaning.world_from_body.linear().cwiseAbs();
  Body around;
  const double deep = std::abs(leaning.world_from_body.linear().col(0).dot(out)) * half.x() +
                      std::abs(leaning.world_from_body.linear().col(2).dot(out)) * half.z();
  around.shape.size_m = {2 * deep, 2 * half.y(), 2 * spread.row(2).dot(half)};
  around.world_from_body = leaning.world_from_body;
  around.world_from_body.linear() << out, Eigen::Vector3d::UnitZ().cross(out),
      Eigen::Vector3d::UnitZ();
  return around;
}

bool HasRoom(const Scene& scene, const Body& around, const Body& box) {
  return std::none_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& other) {
    return &other != &box && Overlap(around, other, 0.005);
  });
}

int LabelOf(const Scene& scene, std::size_t body) {
  return static_cast<int>(std::count_if(scene.bodies.begin(),
                                        scene.bodies.begin() + static_cast<long>(body) + 1,
                                        [](const Body& b) { return b.is_object; }));
}

}  // namespace

std::optional<LeaningThing> AddLeaningThing(Scene& scene, std::uint64_t seed) {
  constexpr double kHighEnough_m = 0.06, kFacing = 0.35;
  Random random(seed);
  const Eigen::Vector3d camera = scene.camera.world_from_camera.translation();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& box = scene.bodies[i];
    const auto [bottom, top] = VerticalExtent(box);
    if (!box.is_object || box.shape.kind != ShapeKind::kBox) continue;
    if (top - bottom < kHighEnough_m) continue;
    for (int side = 0; side < 6; ++side) {
      const Eigen::Vector3d axis = box.world_from_body.linear().col(side / 2);
      const Eigen::Vector3d out = side % 2 == 0 ? axis : Eigen::Vector3d(-axis);
      Eigen::Vector3d to_camera = camera - box.world_from_body.translation();
      to_camera.z() = 0;
      if (std::abs(out.z()) > 0.01 || out.dot(to_camera.normalized()) < kFacing) continue;
      const Board board = {random.Uniform(0.11, 0.22), random.Uniform(0.08, 0.16),
                           random.Uniform(0.006, 0.025)};
      Body leaning = Leaning(board, box, out, box.shape.size_m[side / 2] / 2,
                             random.Uniform(12, 40) * kRadian);
      leaning.material = RandomMaterial(random);
      if (!HasRoom(scene, AroundIt(leaning, out), box)) continue;
      scene.bodies.push_back(leaning);
      return LeaningThing{LabelOf(scene, scene.bodies.size() - 1), LabelOf(scene, i)};
    }
  }
  return std::nullopt;
}

}  // namespace fovea::scenes
