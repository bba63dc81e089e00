// Household objects of random size and look.
#pragma once

#include "tests/support/random.h"
#include "tests/support/scene.h"

namespace fovea::scenes {

// A box, book, can, tube, ball, bowl or cup, standing (tubes: lying) on z = 0 around the origin.
// `scale` multiplies its size; 1 is what a hand can grasp.
Body RandomObject(Random& random, double scale);

// Plain or patterned, in any colours.
Material RandomMaterial(Random& random);

// True if another object can stand on top of it.
bool HasFlatTop(const Body& body);

// Moves a body so that it stands on `height_m` with its centre above `center`, turned by
// `yaw_rad` about the vertical from the orientation it has.
void Rest(Body& body, const Eigen::Vector2d& center, double height_m, double yaw_rad);

// Linear RGB of a displayed colour: hue (0 … 1, from red over green and blue back to red),
// saturation and value.
Eigen::Vector3d ColorOf(double hue, double saturation, double value);

}  // namespace fovea::scenes
