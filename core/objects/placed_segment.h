// Where segments are in relation to the surfaces that things stand on.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea {

// A support and a connected part of its footprint, by their numbers.
using SupportPart = std::pair<std::size_t, int>;

struct PlacedSegment {
  std::vector<Eigen::Vector3f> points;  // means of its voxels
  int num_pixels = 0;
  // Above the support below: the lowest and the highest voxel, metres, and the highest one as a
  // multiple of what may be noise there.
  float lowest_m = std::numeric_limits<float>::max();
  float highest_m = 0;
  float rise = 0;
  // How many of its voxels are above each part of each support.
  std::map<SupportPart, int> num_above;
  // Of the voxels that a support covers from above: how many, and the least distance to it.
  std::size_t num_covered = 0;
  float least_depth_m = std::numeric_limits<float>::max();
};

// `labels`: one entry a voxel, 0 = background. One entry a label, the background's first and empty.
std::vector<PlacedSegment> PlaceSegments(const VoxelGrid& grid, const std::vector<int>& labels,
                                         const std::vector<Support>& supports,
                                         const SupportOptions& options);

}  // namespace fovea
