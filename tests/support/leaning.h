// Things that lean against others.
#pragma once

#include <cstdint>
#include <optional>

#include "tests/support/scene.h"

namespace fovea::scenes {

struct LeaningThing {
  int label = 0;    // of the thing, the last object of its scene
  int against = 0;  // label of the box that holds it up
};

// Adds a book or board that stands on the support and leans against a box of the scene, on a side
// that the camera sees, 12 to 40 degrees from the upright. None, and the scene unchanged, where no
// box is high enough or there is no room. The same scene and seed give the same thing.
std::optional<LeaningThing> AddLeaningThing(Scene& scene, std::uint64_t seed);

}  // namespace fovea::scenes
