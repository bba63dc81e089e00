// Mean colours of voxels and segments.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// Sum over pixels, so that colours of joined parts add up.
struct MeanColor {
  Eigen::Vector3d lab_sum = Eigen::Vector3d::Zero();  // CIELAB, L in 0 … 100
  double num_pixels = 0;

  void Add(const MeanColor& other) {
    lab_sum += other.lab_sum;
    num_pixels += other.num_pixels;
  }
  // Distance of the means in CIELAB units.
  double DistanceTo(const MeanColor& other) const { return (Mean() - other.Mean()).norm(); }

 private:
  Eigen::Vector3d Mean() const { return lab_sum / (num_pixels > 0 ? num_pixels : 1); }
};

// One entry a voxel; empty for voxels outside of the bounding rectangle of all that has a label
// above 0. `color_rgb`: CV_8UC3 of the frame. Where that rectangle is dark, its colours are taken
// farther apart, as if it were lit (its light places have L = 50, by a factor of 4 at most); where
// it is grey, by 1.75, for the differences in hue that are not there.
std::vector<MeanColor> ColorsOfVoxels(const VoxelGrid& grid, const std::vector<int>& labels,
                                      const cv::Mat& color_rgb);

}  // namespace fovea
