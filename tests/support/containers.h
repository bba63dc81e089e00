// Supports that are small or have walls.
#pragma once

#include "tests/support/random.h"
#include "tests/support/scene.h"

namespace fovea::scenes {

// An open box with a rim, of one colour, that stands on `height_m` around the origin. Its bottom is
// added to the scene's supports.
void AddTote(Scene& scene, double height_m, Random& random);

// One bin of a shelf around the origin, its open side towards -y: board below, sides, back and the
// board above. The lower board is added to the scene's supports.
void AddShelfBin(Scene& scene, double height_m, Random& random);

// A chair's writing tablet of some 0.06 m2 around the origin, the chair behind it. The tablet is
// added to the scene's supports.
void AddTablet(Scene& scene, double height_m, Random& random);

}  // namespace fovea::scenes
