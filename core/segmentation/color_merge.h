// Merging of segments that touch and look alike (paper section 3.3, refinement).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

struct ColorMergeOptions {
  // Neighbouring segments whose colour histograms correlate above this are one object; -1 … 1,
  // 1 never merges. Paper: 0.5.
  double min_correlation = 0.5;
  int bins = 20;  // of each RGB channel. Paper: 20
};

// Joins neighbouring segments with similar colour histograms (bins³ bins, L2-normalised,
// compared by their correlation coefficient), all pairs at once. `color_rgb`: CV_8UC3 of the frame.
// `labels`: one entry a voxel, 0 = background; the result is numbered 1 … n in order of the first
// voxel.
std::vector<int> MergeByColor(const VoxelGrid& grid, const std::vector<int>& labels,
                              const cv::Mat& color_rgb, const ColorMergeOptions& options = {});

}  // namespace fovea
