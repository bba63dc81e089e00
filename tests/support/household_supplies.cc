// Forms that are soft, flat or small.
#include "tests/support/compound_parts.h"
#include "tests/support/household_forms.h"

namespace fovea::scenes {
namespace {

Body Cushion(const char* name, const Eigen::Vector3d& size_m, const Relief& relief) {
  Body body;
  body.name = name;
  body.shape = {ShapeKind::kCushion, size_m, 0, {}, relief};
  return body;
}

}  // namespace

Body Bag(Random& random) {
  const Eigen::Vector3d size_m(random.Uniform(0.14, 0.25), random.Uniform(0.1, 0.18),
                               random.Uniform(0.035, 0.075));
  const Relief relief = {.fullness = random.Uniform(1, 3),
                         .depth_m = random.Uniform(0.2, 0.6) * size_m.z(),
                         .scale_m = random.Uniform(0.025, 0.06),
                         .seed = static_cast<std::uint32_t>(random.Bits())};
  return SometimesLying(Cushion("bag", size_m, relief), 0.4, random);
}

Body Cloth(Random& random) {
  const bool folded = random.Chance(0.4);
  const double height_m = folded ? random.Uniform(0.02, 0.04) : random.Uniform(0.05, 0.1);
  const Eigen::Vector3d size_m(random.Uniform(0.16, 0.28), random.Uniform(0.12, 0.22), height_m);
  const Relief relief = {.fullness = folded ? random.Uniform(4, 8) : random.Uniform(1, 2),
                         .depth_m = (folded ? 0.25 : random.Uniform(0.4, 0.7)) * height_m,
                         .scale_m = random.Uniform(0.035, 0.08),
                         .seed = static_cast<std::uint32_t>(random.Bits())};
  return Cushion("cloth", size_m, relief);
}

Body Plate(Random& random) {
  const double diameter_m = random.Uniform(0.18, 0.26);
  Body body;
  body.name = "plate";
  body.shape = {ShapeKind::kBowl, {diameter_m, diameter_m, random.Uniform(0.02, 0.03)}, 0.005, {}};
  return body;
}

Body Slab(Random& random) {
  Body body;
  body.name = "slab";
  body.shape.size_m = {random.Uniform(0.13, 0.24), random.Uniform(0.065, 0.16),
                       random.Uniform(0.01, 0.02)};
  return body;
}

Body Keyboard(Random& random) {
  const double length_m = random.Uniform(0.3, 0.44), width_m = random.Uniform(0.12, 0.15);
  const double height_m = random.Uniform(0.016, 0.024);
  constexpr int kRows = 5;
  std::vector<Part> parts = {BlockPart({0, 0, height_m / 2}, {length_m, width_m, height_m})};
  const double pitch_m = (width_m - 0.02) / kRows;
  for (int row = 0; row < kRows; ++row) {
    const double y = (row - (kRows - 1) / 2.0) * pitch_m;
    parts.push_back(
        BlockPart({0, y, height_m + 0.003}, {length_m - 0.02, 0.75 * pitch_m, 0.006}, 1));
  }
  return Compound("keyboard", std::move(parts));
}

Body Torch(Random& random) {
  const double grip_m = random.Uniform(0.026, 0.036), lamp_m = grip_m * random.Uniform(1.25, 1.5);
  const double length_m = random.Uniform(0.14, 0.22);
  const std::vector<Part> parts = {DiskPart(0, 0.04, lamp_m, 1),
                                   DiskPart(0.04, 0.055, (grip_m + lamp_m) / 2),
                                   DiskPart(0.055, length_m, grip_m)};
  return SometimesLying(Compound("torch", parts), 0.7, random);
}

Body Pear(Random& random) {
  const double diameter_m = random.Uniform(0.06, 0.08), upper_m = diameter_m * 0.62;
  const double up_m = random.Uniform(0.4, 0.6) * diameter_m;
  const std::vector<Part> parts = {BallPart({0, 0, 0}, diameter_m),
                                   BallPart({0, 0, up_m / 2}, (diameter_m + upper_m) / 2),
                                   BallPart({0, 0, up_m}, upper_m)};
  return SometimesLying(Compound("pear", parts), 0.5, random);
}

}  // namespace fovea::scenes
