// What kind of shape a true object has, and which answers are right for it.
#pragma once

#include <string>
#include <vector>

#include "core/types/shape.h"
#include "tests/support/scene.h"

namespace fovea::evaluation {

struct TrueClass {
  std::string name;  // of a row of figures: "box", "flat", "can", "tube", "ball", "vessel", "soft",
                     // "compound"
  std::vector<Shape::Kind> accepted;  // the first is what it is called in a table of confusions
};

// Boxes are boxes, standing and lying cylinders cylinders, balls spheres, bowls and cups of
// revolution, cushions (bags, cloth, backpacks) other. Of compounds bottles, torches and pears that
// stand may be of revolution or cylinders, lying ones cylinders or other; mugs, pitchers and pans,
// which are round but for a handle, may be of revolution or other; keyboards may be boxes; the rest
// is other. What is lower than 30 mm is flat, and may as well be called what it is above.
TrueClass ClassOf(const scenes::Body& body);

// Round about the upright: yaw means nothing. Of compounds: all parts are, about one axis.
bool IsRoundUpright(const scenes::Body& body);

}  // namespace fovea::evaluation
