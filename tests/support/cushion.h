// Where a ray meets the uneven upper side of a cushion.
#pragma once

#include <optional>

#include "tests/support/shape.h"

namespace fovea::scenes {

// Of the upper side above the bottom, at a place in the cushion's frame; 0 beside it.
double CushionHeight(const Shape& cushion, double x, double y);

// Where the ray, which is within the bounding box from one t, 0 or more, to another, enters the
// cushion. Found by steps of at least a quarter of a millimetre: thinner ridges may be missed.
std::optional<Hit> IntersectCushion(const Shape& cushion, const Ray& ray, double from, double to);

}  // namespace fovea::scenes
