// Whether two segments that do not touch lie on one surface.
#pragma once

#include <span>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

struct SameSurface {
  double max_angle_deg = 0;  // between the normals of two voxels
  double max_offset_m = 0;   // of each voxel from the tangent plane of the other
};

// Of the voxels `a` and of the voxels `b`, the share that lies on the surface of a voxel of the
// other segment; the smaller of both, 0 … 1. Compares at most some 150 voxels of each, evenly.
double SharedSurface(const VoxelGrid& grid, std::span<const int> a, std::span<const int> b,
                     const SameSurface& same);

}  // namespace fovea
