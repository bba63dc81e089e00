// Upright surfaces that are too large to be a side of an object: walls, cupboards, partitions. Goes
// beyond the paper, whose scenes show a table and nothing else.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea {

struct WallOptions {
  // Connected parts of an upright plane at least this long along the horizon or the vertical are
  // wall; metres, 0 switches the search off.
  double min_extent_m = 0.6;
};

// Finds up to eight upright planes by voting for their direction and distance, the largest first,
// fits each by least squares and keeps its large connected parts. What lies on one of `supports`
// counts for none: noise tilts the normals of a floor far away, and its strip would connect all
// that stands on it in one line. `tolerance`: the distance from a plane that still belongs to it,
// as of a support. Returns one entry a voxel, 1 = on a wall.
std::vector<char> FindWalls(const VoxelGrid& grid, const Eigen::Vector3f& up,
                            const std::vector<Support>& supports, const SupportOptions& tolerance,
                            const WallOptions& options = {});

}  // namespace fovea
