// Large forms that stand on floors.
#include "tests/support/compound_parts.h"
#include "tests/support/household_forms.h"
#include "tests/support/random_objects.h"

namespace fovea::scenes {

Body Carton(Random& random) {
  Body carton;
  carton.name = "carton";
  carton.shape.size_m = {random.Uniform(0.18, 0.7), random.Uniform(0.14, 0.45),
                         random.Uniform(0.1, 0.55)};
  const bool cardboard = random.Chance(0.6);
  carton.material.pattern = random.Chance(0.6) ? Pattern::kPrint : Pattern::kPlain;
  carton.material.color =
      cardboard
          ? ColorOf(random.Uniform(0.06, 0.1), random.Uniform(0.3, 0.55), random.Uniform(0.5, 0.85))
          : ColorOf(random.Unit(), random.Uniform(0, 0.8), random.Uniform(0.2, 0.95));
  carton.material.second_color =
      ColorOf(random.Unit(), random.Uniform(0, 0.8), random.Uniform(0.1, 0.95));
  carton.material.scale_m = random.Uniform(0.04, 0.12);
  carton.material.seed = static_cast<std::uint32_t>(random.Bits());
  carton.other_materials = {carton.material};  // painted: the caller's colours are not for it
  return carton;
}

Body Backpack(Random& random) {
  const Eigen::Vector3d size_m(random.Uniform(0.3, 0.45), random.Uniform(0.22, 0.32),
                               random.Uniform(0.12, 0.22));
  Body body;
  body.name = "backpack";
  const Relief relief = {.fullness = random.Uniform(1.5, 4),
                         .depth_m = random.Uniform(0.1, 0.35) * size_m.z(),
                         .scale_m = random.Uniform(0.06, 0.15),
                         .seed = static_cast<std::uint32_t>(random.Bits())};
  body.shape = {ShapeKind::kCushion, size_m, 0, {}, relief};
  return SometimesLying(body, 0.5, random);
}

Body Slipper(Random& random) {
  const double length_m = random.Uniform(0.23, 0.3), width_m = random.Uniform(0.085, 0.11);
  const double sole_m = random.Uniform(0.015, 0.03), toe_m = 0.35 * length_m;
  const std::vector<Part> parts = {BlockPart({0, 0, sole_m / 2}, {length_m, width_m, sole_m}),
                                   RodPart({length_m / 2 - toe_m, 0, sole_m},
                                           {length_m / 2 - 0.02, 0, sole_m}, 0.95 * width_m, 1)};
  return Compound("slipper", parts);
}

}  // namespace fovea::scenes
