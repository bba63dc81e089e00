#include "tests/support/household_objects.h"

#include <array>

#include "tests/support/household_forms.h"
#include "tests/support/random_objects.h"

namespace fovea::scenes {
namespace {

constexpr std::array kForms = {Mug,     Mug, Bottle,      Bottle, FlatBottle, Drill,
                               Pitcher, Pan, SprayBottle, Banana, Hammer,     Wrench};

Material RandomPaint(Random& random) {
  const double saturation = random.Chance(0.35) ? random.Uniform(0, 0.08)  // black, grey, white
                                                : random.Uniform(0.4, 0.95);
  const Eigen::Vector3d color = ColorOf(random.Unit(), saturation, random.Uniform(0.25, 0.95));
  return {.color = color, .second_color = color};
}

// Most things are of plain colours; some are printed on.
void Paint(Body& body, Random& random) {
  constexpr double kPrinted = 0.3;
  body.material = random.Chance(kPrinted) ? RandomMaterial(random) : RandomPaint(random);
  body.other_materials = {RandomPaint(random), RandomPaint(random)};
  if (body.name == "bottle") body.other_materials[1] = RandomMaterial(random);  // the label
}

}  // namespace

Body RandomHouseholdObject(Random& random) {
  constexpr double kOrdinary = 0.4;
  if (random.Chance(kOrdinary)) return RandomObject(random, 1);
  Body body = random.Pick(kForms)(random);
  if (body.other_materials.empty()) Paint(body, random);
  body.is_object = true;
  Rest(body, Eigen::Vector2d::Zero(), 0, 0);
  return body;
}

}  // namespace fovea::scenes
