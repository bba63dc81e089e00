// What is known of a segment that may be a part of an object.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Sums and extremes, so that joined parts add up.
struct Part {
  double num_voxels = 0;
  double z_sum_m = 0;                                // over the voxels
  double area_m2 = 0;                                // as seen from the camera
  float top_m = -std::numeric_limits<float>::max();  // heights along up
  float bottom_m = std::numeric_limits<float>::max();
  MeanColor color;

  void Add(const Part& other);
};

// One entry a label, the background's first. `labels`, `colors`: one entry a voxel; `up`: unit
// vector.
std::vector<Part> CollectParts(const VoxelGrid& grid, const std::vector<int>& labels,
                               const std::vector<MeanColor>& colors,
                               const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up);

}  // namespace fovea
