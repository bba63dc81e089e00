// Merging of touching segments by the shape of the boundary they share: what bulges is one object,
// what meets in a groove is two. Goes beyond the paper, whose refinement looks at colour alone.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

struct ShapeMergeOptions {
  // Two segments are one object while their boundary is less concave than this on average;
  // degrees, 0 switches the merge off.
  double max_concavity_deg = 0;
  // How much a difference of the mean colours speaks against it; degrees of concavity for each
  // unit of CIELAB distance.
  double color_weight_deg = 0.2;
  // Voxels up to this many cells apart count as being on the boundary.
  int reach_cells = 2;
  // Boundaries with fewer pairs of voxels do not join anything.
  int min_pairs = 5;
  // Nor do those with fewer than this times the square root of the smaller segment's number of
  // voxels, about its width: things that merely touch.
  double min_contact = 0;
  // Segments that together are a plane of this thickness (times z², in metres) or less count as
  // flat where they meet, whatever noise makes of their normals; 1/m, 0: normals decide.
  double plane_noise_per_m = 0;
};

// Joins the pair of segments that speaks most for being one object, again and again, until no
// pair does; boundaries and colours of joined segments are summed up.
//
// `labels`: one entry a voxel, 0 = background; `color_rgb`: CV_8UC3 of the frame. Returns new
// labels, 1 … n in order of their first voxel.
std::vector<int> MergeByShape(const VoxelGrid& grid, const std::vector<int>& labels,
                              const cv::Mat& color_rgb, const ShapeMergeOptions& options = {});

}  // namespace fovea
