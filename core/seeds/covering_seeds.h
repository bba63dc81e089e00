// Seeds where salient positions are too few: objects without a seed vanish or fuse with a
// neighbour, and the paper's seeds miss every third object of cluttered tables.
#pragma once

#include <vector>

#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea {

struct CoverOptions {
  // No voxel of an object candidate is farther than this from a seed, along the surface; metres,
  // 0 adds no seeds.
  double spacing_m = 0.05;
};

// Adds seeds until every connected part of the voxels that are not background is covered: first
// the most central voxel of each part without a seed, then again and again the voxel farthest
// from all seeds along the voxel graph (farthest-point sampling). Parts of fewer than 20 voxels and
// those longer than 1.5 m get none.
//
// `is_background`: one entry a voxel. Returns `seeds` followed by the new ones.
std::vector<Seed> CoverWithSeeds(const VoxelGrid& grid, const std::vector<char>& is_background,
                                 const std::vector<Seed>& seeds, const CoverOptions& options = {});

}  // namespace fovea
