// What objects are taken for, as lines in space: the overlay draws them, the cloud has them as
// dots.
#pragma once

#include <optional>
#include <vector>

#include "client/cli/overlay/block.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// Cylinders, spheres and what is round about an axis by rings and outline, all others by their
// oriented box.
std::vector<SpaceLine> LinesOf(const v1::Object& object);

std::vector<SpaceLine> LinesOf(const v1::CollisionPrimitive& primitive);

// Through both ends and a little beyond; none without an axis.
std::optional<SpaceLine> AxisOf(const v1::Object& object);

}  // namespace fovea::cli
