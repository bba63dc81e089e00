// The forms that are thin: what lies in drawers and on workbenches, 3 to 30 mm high.
#include <cmath>
#include <numbers>

#include "tests/support/compound_parts.h"
#include "tests/support/household_forms.h"

namespace fovea::scenes {
namespace {

// A ring that lies around `center`.
void AddRing(std::vector<Part>& parts, const Eigen::Vector3d& center, double diameter_m,
             double thickness_m, int material) {
  constexpr int kCorners = 8;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    points.emplace_back(center +
                        diameter_m / 2 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  AddBentRod(parts, points, thickness_m, material);
}

}  // namespace

Body Spoon(Random& random) {
  const double bowl_m = random.Uniform(0.03, 0.06), length_m = random.Uniform(0.12, 0.22);
  const double handle_m = random.Uniform(0.005, 0.012);
  const std::vector<Part> parts = {
      DiskPart(0, 0.008, bowl_m),
      RodPart({0.4 * bowl_m, 0, handle_m / 2}, {length_m, 0, handle_m / 2}, handle_m)};
  return Compound("spoon", parts);
}

Body Knife(Random& random) {
  const double blade_m = random.Uniform(0.1, 0.2), width_m = random.Uniform(0.018, 0.035);
  const double grip_m = random.Uniform(0.09, 0.12), height_m = random.Uniform(0.01, 0.018);
  const std::vector<Part> parts = {
      BlockPart({blade_m / 2, 0, height_m / 2}, {blade_m, width_m, 0.003}),
      BlockPart({-grip_m / 2, 0, height_m / 2}, {grip_m, 0.024, height_m}, 1)};
  return Compound("knife", parts);
}

Body Scissors(Random& random) {
  const double blade_m = random.Uniform(0.06, 0.11), ring_m = random.Uniform(0.028, 0.04);
  const double open = random.Uniform(0.1, 0.35), thickness_m = random.Uniform(0.007, 0.01);
  std::vector<Part> parts;
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d along(std::cos(open / 2), side * std::sin(open / 2), 0);
    const double z = thickness_m / 2;
    parts.push_back(Turned(BlockPart(Eigen::Vector3d(0, 0, z) + blade_m / 2 * along,
                                     {blade_m, 0.012, 0.6 * thickness_m}),
                           side * open / 2, Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d middle(-0.06, -side * (0.01 + ring_m / 2), z);
    parts.push_back(RodPart({0, 0, z}, {-0.045, -side * 0.012, z}, thickness_m, 1));
    AddRing(parts, middle, ring_m, thickness_m, 1);
  }
  return Compound("scissors", std::move(parts));
}

Body Screwdriver(Random& random) {
  const double grip_m = random.Uniform(0.02, 0.035), length_m = random.Uniform(0.08, 0.11);
  const double z = grip_m / 2;
  const std::vector<Part> parts = {
      RodPart({0, 0, z}, {length_m, 0, z}, grip_m, 1),
      RodPart({length_m, 0, z}, {length_m + random.Uniform(0.06, 0.14), 0, z}, 0.007)};
  return Compound("screwdriver", parts);
}

Body Brush(Random& random) {
  const double length_m = random.Uniform(0.14, 0.24), width_m = random.Uniform(0.02, 0.05);
  const double head_m = random.Uniform(0.3, 0.5) * length_m,
               bristles_m = random.Uniform(0.01, 0.03);
  const std::vector<Part> parts = {
      BlockPart({0, 0, bristles_m + 0.006}, {length_m, width_m, 0.012}),
      BlockPart({(length_m - head_m) / 2, 0, bristles_m / 2}, {head_m, 0.9 * width_m, bristles_m},
                1)};
  return Compound("brush", parts);
}

Body Whisk(Random& random) {
  const double handle_m = random.Uniform(0.1, 0.14), thickness_m = random.Uniform(0.014, 0.022);
  const double length_m = random.Uniform(0.1, 0.15), width_m = random.Uniform(0.05, 0.07);
  const double z = width_m / 2;
  std::vector<Part> parts = {RodPart({-handle_m, 0, z}, {0, 0, z}, thickness_m, 1)};
  constexpr int kLoops = 4;
  for (int i = 0; i < kLoops; ++i) {
    const double angle = std::numbers::pi * i / kLoops;
    const Eigen::Vector3d aside =
        width_m / 2 * Eigen::Vector3d(0, std::cos(angle), std::sin(angle));
    const Eigen::Vector3d start(0, 0, z), wide(0.65 * length_m, 0, z), end(length_m, 0, z);
    AddBentRod(parts, {start, wide + aside, end, wide - aside, start}, 0.003);
  }
  return Compound("whisk", std::move(parts));
}

}  // namespace fovea::scenes
