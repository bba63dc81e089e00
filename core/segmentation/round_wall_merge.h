// Joining the pieces of the walls of bowls, cups and pans: the far side, seen from inside, and the
// near one, seen from outside, hardly touch, but share a circle and a rim. Goes beyond the paper.
#pragma once

#include <vector>

#include "core/segmentation/round_wall.h"

namespace fovea {

// Joins segments that are pieces of one round wall if one sees the inside of one of them. `labels`:
// one entry a voxel, 0 = background; `walls`: theirs. Returns new labels, 1 … n in order of their
// first voxel.
std::vector<int> MergeRoundWalls(const std::vector<int>& labels, const RoundWalls& walls);

}  // namespace fovea
