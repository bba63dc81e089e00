// Ways to put an object into a scene. Each leaves the object on what carries it, inside the
// support's edges, clear of all other bodies, and answers false if it found no place.
#pragma once

#include "tests/support/random.h"
#include "tests/support/scene.h"

namespace fovea::scenes {

// Objects stay within this distance from the support's centre.
struct Area {
  Support support;
  double radius_m = 0;
};

// Anywhere in the area, at least `gap_m` from everything that stands there.
bool PlaceFreely(Scene& scene, Body object, const Area& area, double gap_m, Random& random);

// Against the side of an object that is there already: closer than 0.1 mm; boxes often flush.
bool PlaceBeside(Scene& scene, Body object, const Area& area, Random& random);

// On top of an object, its centre above the other's middle.
bool PlaceOnTop(Scene& scene, Body object, Random& random);

}  // namespace fovea::scenes
