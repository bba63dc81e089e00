// What the kinds of random scenes consist of.
#pragma once

#include <span>
#include <string_view>

#include "tests/support/random.h"

namespace fovea::scenes {

enum class Surfaces { kTable, kTwoTables, kFloor, kTote, kShelfBin, kTablet };

// Of random_objects.h and household_objects.h; kMixed: what hands can take of them.
enum class Objects { kSimple, kHousehold, kSupplies, kTools, kLuggage, kMixed };

struct Range {
  double low, high;
  double Draw(Random& random) const { return random.Uniform(low, high); }
};

struct Recipe {
  const char* kind;
  Surfaces surfaces;
  int fewest, most;           // objects
  double radius_m;            // of the area in which they stand
  double beside, on_top;      // shares placed against, and on, others; the rest stands free
  Range pitch_deg, distance;  // of the camera; metres to the middle of the area
  bool furnished;
  Objects objects = Objects::kSimple;
  double roll_deg = 4;  // of the camera, to either side at most
};

std::span<const Recipe> Recipes();

// Throws std::invalid_argument for an unknown kind.
const Recipe& RecipeOf(std::string_view kind);

}  // namespace fovea::scenes
