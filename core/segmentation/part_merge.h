// Merging of touching segments that are likely parts of one object. Goes beyond the paper, whose
// refinement looks at colour alone.
#pragma once

#include <vector>

#include "core/segmentation/segment_graph.h"

namespace fovea {

struct PartMergeOptions {
  // Two touching segments are one object if the probability of it is above this; 0 … 1, 1 switches
  // the merge off.
  double min_probability = 1;
};

// Joins the pair of segments that are most likely one object (LogOdds), again and again, until no
// pair is likely enough; what is known of joined segments is summed up.
//
// `labels`: one entry a voxel, 0 = background; `colors`: one entry a voxel; `up`: unit vector.
// Returns new labels, 1 … n in order of their first voxel.
std::vector<int> MergeParts(const VoxelGrid& grid, const std::vector<int>& labels,
                            const std::vector<MeanColor>& colors,
                            const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up,
                            const PartMergeOptions& options = {});

}  // namespace fovea
