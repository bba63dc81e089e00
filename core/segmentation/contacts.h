// Where segments touch, or nearly do.
#pragma once

#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// Every pair of voxels of two segments whose cells differ by at most `reach_cells` along each axis,
// once. `labels`: one entry a voxel; 0 is no segment.
std::vector<VoxelEdge> FindContacts(const VoxelGrid& grid, const std::vector<int>& labels,
                                    int reach_cells);

}  // namespace fovea
