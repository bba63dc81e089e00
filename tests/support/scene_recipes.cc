#include "tests/support/scene_recipes.h"

#include <array>
#include <stdexcept>
#include <string>

namespace fovea::scenes {
namespace {

using enum Surfaces;
using enum Objects;

// The place in the table is part of a scene's seed: new kinds go to its end.
// kind, surfaces, fewest, most, radius_m, beside, on_top, pitch_deg, distance, furnished, objects,
// roll_deg
constexpr auto kRecipes = std::to_array<Recipe>({
    {"tabletop", kTable, 3, 6, 0.25, 0.0, 0.0, {32, 48}, {0.9, 1.1}, false},
    {"cluttered", kTable, 9, 13, 0.28, 0.3, 0.1, {32, 50}, {0.95, 1.15}, false},
    {"stacked", kTable, 5, 8, 0.22, 0.0, 0.6, {28, 45}, {0.9, 1.1}, false},
    {"touching", kTable, 4, 8, 0.22, 0.7, 0.0, {30, 48}, {0.9, 1.1}, false},
    {"occluded", kTable, 6, 9, 0.22, 0.0, 0.0, {16, 26}, {0.9, 1.1}, false},
    {"steep", kTable, 3, 7, 0.22, 0.2, 0.1, {62, 80}, {0.8, 1.0}, false},
    {"shallow", kTable, 3, 5, 0.25, 0.0, 0.1, {10, 18}, {0.9, 1.2}, true},
    {"room", kTable, 4, 7, 0.35, 0.2, 0.1, {18, 30}, {1.6, 2.1}, true},
    {"two_tables", kTwoTables, 5, 8, 0.25, 0.2, 0.1, {25, 40}, {1.5, 1.9}, true},
    {"floor", kFloor, 3, 7, 0.45, 0.2, 0.1, {28, 50}, {1.3, 1.8}, true},
    {"empty_table", kTable, 0, 0, 0.25, 0.0, 0.0, {30, 48}, {0.9, 1.2}, true},
    {"household", kTable, 5, 9, 0.3, 0.25, 0.15, {25, 50}, {0.8, 1.3}, true, kHousehold},
    {"household_floor", kFloor, 4, 8, 0.35, 0.25, 0.15, {25, 50}, {1.0, 1.5}, true, kHousehold},
    {"supplies", kTable, 5, 9, 0.3, 0.25, 0.15, {25, 50}, {0.8, 1.3}, true, kSupplies},
    {"supplies_floor", kFloor, 4, 8, 0.35, 0.25, 0.15, {25, 50}, {1.0, 1.5}, true, kSupplies},
    {"luggage", kFloor, 2, 5, 0.6, 0.2, 0.1, {4, 35}, {0.8, 1.8}, true, kLuggage, 30},
    {"tools", kTable, 2, 7, 0.18, 0.1, 0.0, {50, 88}, {0.55, 0.8}, false, kTools, 20},
    {"tote", kTote, 4, 10, 0.3, 0.2, 0.15, {55, 88}, {0.65, 0.95}, false, kSupplies, 10},
    {"shelf", kShelfBin, 2, 5, 0.25, 0.3, 0.1, {0, 25}, {0.6, 1.0}, false, kHousehold},
    {"tablet", kTablet, 1, 3, 0.08, 0.2, 0.0, {20, 50}, {0.75, 1.4}, true, kHousehold},
    {"desk", kTable, 5, 10, 0.5, 0.15, 0.1, {8, 25}, {1.8, 2.6}, true, kHousehold},
    {"crowded", kTable, 24, 30, 0.45, 0.2, 0.1, {42, 60}, {1.1, 1.3}, false},
});

}  // namespace

std::span<const Recipe> Recipes() { return kRecipes; }

const Recipe& RecipeOf(std::string_view kind) {
  for (const Recipe& recipe : kRecipes) {
    if (recipe.kind == kind) return recipe;
  }
  throw std::invalid_argument(std::string(kind) + ": there is no such kind of scene");
}

}  // namespace fovea::scenes
