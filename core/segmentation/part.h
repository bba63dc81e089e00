// What is known of a segment that may be a part of an object.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Sums and extremes, so that joined parts add up.
struct Part {
  double num_voxels = 0;
  double z_sum_m = 0;          // over the voxels
  double area_m2 = 0;          // as seen from the camera
  Eigen::AlignedBox3f extent;  // to the right, away from the camera and up, in metres
  MeanColor color;

  void Add(const Part& other);
  float Top_m() const { return extent.max().z(); }
  float Bottom_m() const { return extent.min().z(); }
  float Height_m() const { return Top_m() - Bottom_m(); }
};

// One entry a label, the background's first and empty. `labels`, `colors`: one entry a voxel; `up`:
// unit vector.
std::vector<Part> CollectParts(const VoxelGrid& grid, const std::vector<int>& labels,
                               const std::vector<MeanColor>& colors,
                               const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up);

}  // namespace fovea
