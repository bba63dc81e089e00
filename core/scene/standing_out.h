// What on a support does not look like it.
#pragma once

#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea {

struct OnSupports {
  // One entry a voxel.
  std::vector<float> height_m;   // over the support that it lies on; NaN = on none
  std::vector<char> stands_out;  // 1 where it lies on one and looks different
};

// Looks at the voxels that are `is_background` and within the tolerance of a support. Different is
// what is farther than `min_contrast` (units of mean_color.h) from all the colours that much of the
// support has, by area: of a chequered cloth both.
OnSupports FindStandingOut(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                           const std::vector<char>& is_background,
                           const std::vector<Support>& supports, const SupportOptions& tolerance,
                           double min_contrast);

}  // namespace fovea
