// Merging of segments that touch and look alike (paper section 3.3, refinement).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea::paper {

struct ColorMergeOptions {
  // Neighbouring segments whose colour histograms correlate above this are one object; -1 … 1,
  // 1 never merges. Paper: 0.5.
  double min_correlation = 0.5;
  int bins = 20;  // of each RGB channel. Paper: 20
  // Labels are split into their connected parts first: Eq. 5 may reach across a gap. Paper: not
  // said.
  bool split = false;
  // Pairs are compared again, with the histograms of what was joined, until none is.
  bool iterate = false;
};

// The segments that refinement begins with: the labels of the graph cut, or their connected parts,
// numbered 1 … n in order of the first voxel. Throws TooComplex for more than 65535.
std::vector<int> SegmentsOf(const VoxelGrid& grid, const std::vector<int>& labels,
                            const ColorMergeOptions& options = {});

// Joins neighbouring segments with similar colour histograms (bins³ bins, L2-normalised,
// compared by their correlation coefficient), all pairs at once. `color_rgb`: CV_8UC3 of the frame.
// `labels`: one entry a voxel, 0 = background; the result is numbered 1 … n in order of the first
// voxel.
std::vector<int> MergeByColor(const VoxelGrid& grid, const std::vector<int>& labels,
                              const cv::Mat& color_rgb, const ColorMergeOptions& options = {});

}  // namespace fovea::paper
