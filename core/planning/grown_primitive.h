// Primitives that grow to hold what was seen.
#pragma once

#include <vector>

#include "core/types/detections.h"
#include "core/types/planning.h"

namespace fovea {

// How far the point lies outside, 0 inside; of boxes and cylinders the farthest of their ways out.
float OutsideBy_m(const CollisionPrimitive& primitive, const Eigen::Vector3f& point);

// Cubic metres.
float VolumeOf(const CollisionPrimitive& primitive);

// Grown along its axes to hold all but a hundredth of the points, of which each of its sides lets
// go as many: strays, where a mask reaches beyond its thing. Nothing shrinks. Cost: proportional to
// the points.
CollisionPrimitive GrownTo(const std::vector<ColoredPoint>& cloud, CollisionPrimitive primitive);

}  // namespace fovea
