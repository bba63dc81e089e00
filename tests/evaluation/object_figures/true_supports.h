// What truly stands on what.
#pragma once

#include <vector>

#include "tests/support/scene.h"

namespace fovea::evaluation {

// For each object, by label, the labels of the objects that it rests on: their footprints overlap
// and its bottom is on their top to 2 mm. Empty: only furniture carries it.
std::vector<std::vector<int>> TrueSupports(const scenes::Scene& scene);

}  // namespace fovea::evaluation
