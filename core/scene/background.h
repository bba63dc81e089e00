// What cannot be part of an object: surfaces, what stands on none, what is outside the region of
// interest.
#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/region.h"
#include "core/scene/support_surface.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// One entry a voxel: 1 where it stands on no support (if there is one) or lies outside the region.
std::vector<char> FindBackground(const VoxelGrid& grid, const std::vector<Support>& supports,
                                 const SupportOptions& options, const CameraIntrinsics& intrinsics,
                                 const RegionOptions& region);

// One entry a voxel: 1 where the region alone keeps it from being part of an object. Empty where
// there is no region, which costs nothing.
std::vector<char> FindHiddenByRegion(const VoxelGrid& grid, const std::vector<Support>& supports,
                                     const SupportOptions& options,
                                     const CameraIntrinsics& intrinsics,
                                     const RegionOptions& region);

// Of object k at k − 1: whether one of its voxels has a hidden one beside it, on which it may go
// on. `objects`: one entry a voxel, 1 … `num_objects`, 0 = background; `hidden`: as of
// FindHiddenByRegion. Empty where that is. Cost: proportional to the neighbours.
std::vector<char> FindCutByRegion(const VoxelGrid& grid, const std::vector<int>& objects,
                                  std::size_t num_objects, const std::vector<char>& hidden);

}  // namespace fovea
