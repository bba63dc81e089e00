// The forms that hold something.
#include "tests/support/compound_parts.h"
#include "tests/support/household_forms.h"

namespace fovea::scenes {
namespace {

// A handle in the shape of a C whose ends are at distance `x` from the z axis.
void AddHandle(std::vector<Part>& parts, double x, double low_m, double high_m, double reach_m,
               double diameter_m) {
  const double corner_m = 0.22 * (high_m - low_m), near = x + 0.65 * reach_m, far = x + reach_m;
  AddBentRod(parts,
             {{x, 0, high_m},
              {near, 0, high_m},
              {far, 0, high_m - corner_m},
              {far, 0, low_m + corner_m},
              {near, 0, low_m},
              {x, 0, low_m}},
             diameter_m);
}

}  // namespace

// Handles and lips of hollow vessels begin in the middle of the wall, so as not to show inside.

Body Mug(Random& random) {
  constexpr double kWall_m = 0.004;
  const double diameter_m = random.Uniform(0.075, 0.095), height_m = random.Uniform(0.08, 0.11);
  std::vector<Part> parts = {VesselPart(diameter_m, height_m, kWall_m)};
  AddHandle(parts, diameter_m / 2 - kWall_m / 2, 0.2 * height_m, 0.8 * height_m,
            random.Uniform(0.027, 0.035), random.Uniform(0.009, 0.012));
  return Compound("mug", std::move(parts));
}

Body Pitcher(Random& random) {
  constexpr double kWall_m = 0.004;
  const double diameter_m = random.Uniform(0.11, 0.14), height_m = random.Uniform(0.18, 0.24);
  const double middle_m = diameter_m / 2 - kWall_m / 2;
  std::vector<Part> parts = {VesselPart(diameter_m, height_m, kWall_m)};
  AddHandle(parts, middle_m, 0.25 * height_m, 0.88 * height_m, random.Uniform(0.04, 0.055),
            random.Uniform(0.015, 0.02));
  parts.push_back(BlockPart({-middle_m - 0.01, 0, height_m - 0.009}, {0.02, 0.026, 0.018}));
  return Compound("pitcher", std::move(parts));
}

Body Pan(Random& random) {
  constexpr double kWall_m = 0.003;
  const double diameter_m = random.Uniform(0.16, 0.24), height_m = random.Uniform(0.04, 0.06);
  const double length_m = random.Uniform(0.14, 0.18);
  std::vector<Part> parts = {VesselPart(diameter_m, height_m, kWall_m)};
  const double x = diameter_m / 2 - kWall_m / 2 + length_m / 2;
  parts.push_back(BlockPart({x, 0, 0.8 * height_m}, {length_m, 0.024, 0.014}, 1));
  return Compound("pan", std::move(parts));
}

Body Bottle(Random& random) {
  const double diameter_m = random.Uniform(0.055, 0.085), neck_m = random.Uniform(0.025, 0.036);
  const double total_m = random.Uniform(0.18, 0.3), cap_m = random.Uniform(0.014, 0.025);
  const double straight_m = total_m - diameter_m / 2 - random.Uniform(0.03, 0.05);
  std::vector<Part> parts = {DiskPart(0, straight_m, diameter_m),
                             BallPart({0, 0, straight_m}, diameter_m),
                             DiskPart(straight_m, total_m - cap_m, neck_m),
                             DiskPart(total_m - cap_m, total_m, neck_m + 0.004, 1)};
  if (random.Chance(0.6)) {
    parts.push_back(DiskPart(0.2 * straight_m, 0.8 * straight_m, diameter_m + 6e-4, 2));
  }
  return SometimesLying(Compound("bottle", std::move(parts)), 0.3, random);
}

Body FlatBottle(Random& random) {
  const double depth_m = random.Uniform(0.04, 0.06), width_m = random.Uniform(0.08, 0.11);
  const double height_m = random.Uniform(0.1, 0.16), neck_m = random.Uniform(0.025, 0.033);
  const double side_m = (width_m - depth_m) / 2, top_m = height_m + depth_m / 2 + 0.012;
  std::vector<Part> parts = {
      BlockPart({0, 0, height_m / 2}, {depth_m, 2 * side_m, height_m}),
      RodPart({0, -side_m, height_m}, {0, side_m, height_m}, depth_m),
      DiskPart(height_m, top_m, neck_m),
      DiskPart(top_m, top_m + random.Uniform(0.02, 0.03), neck_m + 0.006, 1)};
  for (const double y : {-side_m, side_m}) {  // round sides and corners
    parts.push_back(RodPart({0, y, 0}, {0, y, height_m}, depth_m));
    parts.push_back(BallPart({0, y, height_m}, depth_m));
  }
  return SometimesLying(Compound("flat bottle", std::move(parts)), 0.25, random);
}

Body SprayBottle(Random& random) {
  const double diameter_m = random.Uniform(0.065, 0.085), height_m = random.Uniform(0.11, 0.15);
  const double head_m = height_m + diameter_m / 2 + 0.018;
  const std::vector<Part> parts = {
      DiskPart(0, height_m, diameter_m),
      BallPart({0, 0, height_m}, diameter_m),
      DiskPart(height_m, head_m, 0.026),
      DiskPart(head_m - 0.022, head_m - 0.004, 0.034, 1),
      BlockPart({0, 0.012, head_m + 0.016}, {0.028, 0.075, 0.032}, 1),
      RodPart({0, 0.045, head_m + 0.02}, {0, 0.062, head_m + 0.02}, 0.016, 2),
      Turned(BlockPart({0, 0.04, head_m - 0.014}, {0.013, 0.008, 0.05}, 2), 0.35,
             Eigen::Vector3d::UnitX())};
  return Compound("spray bottle", parts);
}

}  // namespace fovea::scenes
