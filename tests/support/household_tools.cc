// The forms that are all solid.
#include <algorithm>
#include <cmath>

#include "tests/support/compound_parts.h"
#include "tests/support/household_forms.h"
#include "tests/support/random_objects.h"

namespace fovea::scenes {

Body Drill(Random& random) {
  using Eigen::Vector3d;
  const double diameter_m = random.Uniform(0.055, 0.07), motor_m = random.Uniform(0.12, 0.15);
  const double front_m = motor_m / 2, rear_m = -motor_m / 4, radius_m = diameter_m / 2;
  const double grip_m = random.Uniform(0.1, 0.12), foot_m = random.Uniform(0.035, 0.045);
  const double foot_z = -radius_m - grip_m;  // of its top; z = 0 is the motor's axis
  const std::vector<Part> parts = {
      RodPart({0, -front_m, 0}, {0, front_m, 0}, diameter_m),
      RodPart({0, -front_m - 0.006, 0}, {0, -front_m, 0}, 0.8 * diameter_m, 1),
      RodPart({0, front_m, 0}, {0, front_m + 0.015, 0}, 0.75 * diameter_m, 1),
      RodPart({0, front_m + 0.015, 0}, {0, front_m + 0.05, 0}, random.Uniform(0.032, 0.038), 1),
      Turned(BlockPart({0, rear_m, foot_z + grip_m / 2 + 0.005}, {0.034, 0.042, grip_m + 0.04}),
             -0.12, Vector3d::UnitX()),
      BlockPart({0, rear_m + 0.028, -radius_m - 0.02}, {0.014, 0.022, 0.028}, 1),
      BlockPart({0, rear_m + 0.005, foot_z - foot_m / 2},
                {diameter_m * random.Uniform(0.9, 1), random.Uniform(0.08, 0.1), foot_m}, 1)};
  return SometimesLying(Compound("drill", parts), 0.4, random);
}

// Handles touch what they lie on along their whole length.

Body Hammer(Random& random) {
  const double handle_m = random.Uniform(0.025, 0.032), length_m = random.Uniform(0.24, 0.29);
  const double grip_m = 0.45 * length_m, shaft_m = 0.85 * handle_m, head_m = handle_m + 0.003;
  const double middle = head_m / 2;
  const std::vector<Part> parts = {
      RodPart({0, 0, handle_m / 2}, {grip_m, 0, handle_m / 2}, handle_m),
      RodPart({grip_m, 0, shaft_m / 2}, {length_m, 0, shaft_m / 2}, shaft_m, 1),
      BlockPart({length_m, -0.01, middle}, {head_m, 0.07, head_m}, 2),
      RodPart({length_m, 0.025, middle}, {length_m, 0.055, middle}, head_m, 2),
      BlockPart({length_m - 0.004, -0.055, middle}, {0.4 * head_m, 0.05, 0.8 * head_m}, 2)};
  return Compound("hammer", parts);
}

Body Wrench(Random& random) {
  const double handle_m = random.Uniform(0.025, 0.03), length_m = random.Uniform(0.19, 0.23);
  const double z = handle_m / 2, gap_m = random.Uniform(0.016, 0.028);
  const double jaw_m = gap_m / 2 + 0.009;  // from the axis to the middle of a jaw
  const std::vector<Part> parts = {
      RodPart({0, 0, z}, {length_m, 0, z}, handle_m),
      BlockPart({length_m, 0, z}, {0.035, 2 * jaw_m + 0.018, handle_m}, 1),
      BlockPart({length_m + 0.034, jaw_m, z}, {0.04, 0.018, handle_m}, 1),
      BlockPart({length_m + 0.03, -jaw_m, z}, {0.032, 0.018, handle_m}, 1)};
  return Compound("wrench", parts);
}

Body Banana(Random& random) {
  constexpr int kPieces = 10;
  const double thickness_m = random.Uniform(0.031, 0.038), length_m = random.Uniform(0.15, 0.19);
  const double bend_m = random.Uniform(0.09, 0.13);  // radius of the arc
  const auto at = [&](double s) {                    // s from -1 at one end to 1 at the other
    const double angle = s * length_m / (2 * bend_m);
    return Eigen::Vector3d(bend_m * std::cos(angle), bend_m * std::sin(angle), 0);
  };
  const auto diameter = [&](double s) {
    return thickness_m * (1 - 0.55 * std::pow(std::abs(s), 3.5));
  };
  std::vector<Part> parts = {BallPart(at(-1), diameter(-1))};
  for (int i = 1; i <= kPieces; ++i) {
    const double from = 2.0 * (i - 1) / kPieces - 1, to = 2.0 * i / kPieces - 1;
    const double rod_m = std::min(diameter(from), diameter(to));
    parts.push_back(RodPart(at(from), at(to), rod_m));
    parts.push_back(BallPart(at(to), diameter(to)));
  }
  parts.push_back(RodPart(at(1), at(1.22), 0.011, 1));
  Body banana = Compound("banana", std::move(parts));
  banana.material = Plain(ColorOf(random.Uniform(0.13, 0.17), random.Uniform(0.7, 0.9), 0.9));
  banana.other_materials = {Plain(ColorOf(0.1, 0.6, 0.35))};
  return banana;
}

}  // namespace fovea::scenes
