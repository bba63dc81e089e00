// How much of an object could be seen.
#pragma once

#include <string>
#include <vector>

#include "tests/support/scene.h"

namespace fovea::evaluation {

// Pixels of each object (by label) if nothing else were there, in an image twice as wide and as
// high with the same middle; at least 1.
std::vector<int> PixelsAlone(const scenes::Scene& scene);

// The group of a share that is seen: "seen < 0.4", "seen 0.4-0.7" and so on.
std::string VisibilityName(double visible_share);

}  // namespace fovea::evaluation
