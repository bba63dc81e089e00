// Merging of segments by statics: what hangs in the air beside the only things that it touches
// cannot stand by itself, so it is a part of what holds it: the handle of a pan, the head of a
// drill. Goes beyond the paper.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct StabilityMergeOptions {
  // The centre of a segment may lie this far beside what the things that it touches cover, seen
  // from above; metres. Farther out it would fall. 0 switches the merge off.
  double max_overhang_m = 0;
};

// Joins, the largest overhang first, each segment that rests on no support, has nothing in front of
// its lower border and whose centre is beside everything it touches with the one that it touches
// most.
//
// `labels`: one entry a voxel, 0 = background; `points`: CV_32FC3 of the frame, NaN = none;
// `up`: unit vector. Returns new labels, 1 … n in order of their first voxel. Joins nothing where
// there is no support.
std::vector<int> MergeUnstable(const VoxelGrid& grid, const std::vector<int>& labels,
                               const cv::Mat& points, const CameraIntrinsics& intrinsics,
                               const std::vector<Support>& supports,
                               const SupportOptions& support_options, const Eigen::Vector3f& up,
                               const StabilityMergeOptions& options = {});

}  // namespace fovea
