// The round walls of hollow things, bowls, cups and pans.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// A wall that stands around a vertical axis.
struct RoundWall {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  // of its circle; in LevelAxesFor(up), metres
  double radius_m = 0;
  bool is_inside = false;  // one sees its hollow side
  double rim_m = 0;        // height along up of its top
  double foot_m = 0;       // and of its lowest visible part
};

// One entry a label, the background's first; none for what is no wall.
using RoundWalls = std::vector<std::optional<RoundWall>>;

// The wall that each segment is for the most part, none if it is not round, bends hardly at all, or
// with a larger radius. `labels`: one entry a voxel; `up`: unit vector. The circle is fitted to the
// places of the upper half of the voxels, where bowls are nearly upright (least squares; Kåsa
// 1976).
RoundWalls FindRoundWalls(const VoxelGrid& grid, const std::vector<int>& labels,
                          const Eigen::Vector3f& up, double max_radius_m);

}  // namespace fovea
