// What cannot be part of an object: surfaces, what stands on none, what is outside the region of
// interest.
#pragma once

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

}  // namespace fovea
