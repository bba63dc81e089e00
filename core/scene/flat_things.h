// Things that lie flat on a support, too low for depth alone to tell them from it, but of another
// colour: scissors, cutlery, the thin end of a tool. Goes beyond the paper.
#pragma once

#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea {

struct FlatThingOptions {
  // Voxels on a support whose colour is farther than this from all that is usual there may belong
  // to a thing; units of mean_color.h, 0 switches the search off.
  double min_contrast = 26;
};

// Connected voxels that stand out on their support (standing_out.h), of the size of a thing, and in
// the mean a little higher than what is around them: prints and shadows are not. What is close to
// objects may be their edge, where colour and depth mix: it counts only where it goes on beyond
// that.
//
// `colors`, `is_background`: one entry a voxel. Returns one entry a voxel, 1 = part of such a
// thing; only of what is background. Cost: linear in voxels.
std::vector<char> FindFlatThings(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                                 const std::vector<char>& is_background,
                                 const std::vector<Support>& supports,
                                 const SupportOptions& tolerance,
                                 const FlatThingOptions& options = {});

}  // namespace fovea
