// Where two segments of voxels meet.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea {

// Sums over pairs of voxels, one of either segment, so that boundaries of joined segments add up.
struct Boundary {
  double num_pairs = 0;
  double convexity_sum_deg = 0;  // ConvexityDeg of each pair
  double step_sum_deg = 0;       // StepDeg, without its sign
  double contrast_sum = 0;       // distance of the mean colours, units of mean_color.h
  double way_sum_m2 = 0;         // squared distance of their means,
  double rise_sum_m2 = 0;        // and what of it goes along up

  void Add(const Boundary& other);
};

using SegmentPair = std::pair<int, int>;  // first < second
using Boundaries = std::map<SegmentPair, Boundary>;

// The boundaries of all segments that touch: that have voxels which are neighbours along any of the
// 26 directions and have normals. Of those that do not, the boundaries across gaps of one voxel, if
// at least 4 pairs face each other there: at edges sensors leave voxels out. `labels`, `colors`:
// one entry a voxel; the background, 0, takes no part. `up`: unit vector.
Boundaries CollectBoundaries(const VoxelGrid& grid, const std::vector<int>& labels,
                             const std::vector<MeanColor>& colors, const Eigen::Vector3f& up);

}  // namespace fovea
