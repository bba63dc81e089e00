// Joining the pieces of the walls of bowls, cups and pans: the far side, seen from inside, and the
// near one, seen from outside, hardly touch, but share a circle and a rim. Goes beyond the paper.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// Joins segments that are pieces of one round wall with a radius up to `max_radius_m` (0: none) if
// one sees the inside of one of them. `labels`: one entry a voxel, 0 = background; `up`: unit
// vector. Returns new labels, 1 … n in order of their first voxel.
std::vector<int> MergeRoundWalls(const VoxelGrid& grid, const std::vector<int>& labels,
                                 const Eigen::Vector3f& up, double max_radius_m);

}  // namespace fovea
