// Mean colours of segments.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// Sum over pixels, so that the colours of joined segments add up.
struct SegmentColor {
  Eigen::Vector3d lab_sum = Eigen::Vector3d::Zero();  // CIELAB, L in 0 … 100
  double num_pixels = 0;

  void Add(const SegmentColor& other) {
    lab_sum += other.lab_sum;
    num_pixels += other.num_pixels;
  }
  // Distance of the mean colours in CIELAB units.
  double DistanceTo(const SegmentColor& other) const { return (Mean() - other.Mean()).norm(); }

 private:
  Eigen::Vector3d Mean() const { return lab_sum / (num_pixels > 0 ? num_pixels : 1); }
};

// One entry a label; that of the background, the first, stays empty. `color_rgb`: CV_8UC3 of the
// frame.
std::vector<SegmentColor> ColorsOfSegments(const VoxelGrid& grid, const std::vector<int>& labels,
                                           const cv::Mat& color_rgb);

}  // namespace fovea
