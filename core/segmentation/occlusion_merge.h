// Merging of segments that do not touch in the image but are one object: the parts left and right
// of something in front, and the inside of a hollow object with its outside. Goes beyond the paper.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct OcclusionMergeOptions {
  // Parts behind a common occluder are one object if at least this share of each lies on the
  // surface of the other, 0 … 1; 0 switches the merge off.
  double min_shared_surface = 0.3;
  // A segment that bends inwards about the vertical with at least this mean curvature and whose
  // near rim another segment hides is the inside of that one; 1/m, 0 switches the merge off.
  double min_hollow_curvature_per_m = 3;
};

// `labels`: one entry a voxel, 0 = background; `points`: CV_32FC3 of the frame; `colors`: one
// entry a voxel; `up`: unit vector. Returns new labels, 1 … n in order of their first voxel.
std::vector<int> MergeOccluded(const VoxelGrid& grid, const std::vector<int>& labels,
                               const cv::Mat& points, const std::vector<MeanColor>& colors,
                               const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up,
                               const OcclusionMergeOptions& options = {});

}  // namespace fovea
