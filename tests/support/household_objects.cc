#include "tests/support/household_objects.h"

#include <array>

#include "tests/support/household_forms.h"
#include "tests/support/random_objects.h"

namespace fovea::scenes {
namespace {

constexpr std::array kVesselsAndTools = {Mug,     Mug, Bottle,      Bottle, FlatBottle, Drill,
                                         Pitcher, Pan, SprayBottle, Banana, Hammer,     Wrench};
constexpr std::array kSupplyThings = {Bag,  Bag,  Bag,      Cloth, Cloth, Plate,
                                      Slab, Slab, Keyboard, Torch, Pear};
constexpr std::array kToolThings = {Spoon, Knife,  Scissors, Scissors, Screwdriver, Brush,
                                    Whisk, Hammer, Wrench,   Torch,    Plate,       Slab};
constexpr std::array kLuggageThings = {Carton, Carton, Carton, Carton, Backpack, Slipper, Slipper};

Material RandomPaint(Random& random) {
  const double saturation = random.Chance(0.35) ? random.Uniform(0, 0.08)  // black, grey, white
                                                : random.Uniform(0.4, 0.95);
  return Plain(ColorOf(random.Unit(), saturation, random.Uniform(0.25, 0.95)));
}

// Most things are of plain colours; some are printed on, and most bags.
void Paint(Body& body, Random& random) {
  const double printed = body.name == "bag" ? 0.8 : 0.3;
  body.material = random.Chance(printed) ? RandomMaterial(random) : RandomPaint(random);
  body.other_materials = {RandomPaint(random), RandomPaint(random)};
  if (body.name == "bottle") body.other_materials[1] = RandomMaterial(random);  // the label
}

// One of the forms or, in a share of all cases, an object of random_objects.h.
template <typename Forms>
Body RandomBody(const Forms& forms, double ordinary, Random& random) {
  if (random.Chance(ordinary)) return RandomObject(random, 1);
  Body body = random.Pick(forms)(random);
  if (body.other_materials.empty()) Paint(body, random);
  body.is_object = true;
  Rest(body, Eigen::Vector2d::Zero(), 0, 0);
  return body;
}

}  // namespace

Body RandomHouseholdObject(Random& random) { return RandomBody(kVesselsAndTools, 0.4, random); }

Body RandomSupply(Random& random) { return RandomBody(kSupplyThings, 0.4, random); }

Body RandomTool(Random& random) { return RandomBody(kToolThings, 0.15, random); }

Body RandomLuggage(Random& random) { return RandomBody(kLuggageThings, 0, random); }

}  // namespace fovea::scenes
