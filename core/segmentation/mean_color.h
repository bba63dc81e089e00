// Mean colours of voxels and segments, in which the light on a surface counts for less than the
// surface itself.
//
// L + 16, a and b of CIELAB all grow with the cube root of the light that falls on a surface. So
// a / (L + 16) and b / (L + 16) are the same for the sides of one box, whichever faces the light,
// and a share of the light less is a difference in ln(L + 16). Colours here are
// 66 · (ln(L + 16) / 2, a / (L + 16), b / (L + 16)): near L = 50 their units are those of CIELAB,
// but for lightness, which counts half.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// Sum over pixels, so that colours of joined parts add up.
struct MeanColor {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double num_pixels = 0;
  bool is_grey = false;  // of a grey frame, as all of its colours

  void Add(const MeanColor& other) {
    sum += other.sum;
    num_pixels += other.num_pixels;
    is_grey |= other.is_grey;
  }
  // Of the means; in grey frames with a usual difference in hue, which nobody sees.
  double DistanceTo(const MeanColor& other) const {
    constexpr double kUsualHue = 8;
    const double seen = (Mean() - other.Mean()).norm();
    return is_grey && other.is_grey ? std::hypot(seen, kUsualHue) : seen;
  }
  Eigen::Vector3d Mean() const { return sum / (num_pixels > 0 ? num_pixels : 1); }
};

// One entry a voxel. `lab`: CV_8UC3 of the frame, as of LabOf.
std::vector<MeanColor> ColorsOfVoxels(const VoxelGrid& grid, const cv::Mat& lab);

}  // namespace fovea
