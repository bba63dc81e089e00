// Completing hollow things, bowls, cups and pans, from the inside of their walls: the floor between
// them lies too close to the surface that carries it to be told from it. Goes beyond the paper.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/round_wall.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct HollowFillOptions {
  // Walls that stand around a vertical axis with a radius up to this are joined
  // (round_wall_merge.h) and filled; metres, 0 switches both off.
  double max_radius_m = 0;
};

// Gives objects with the inside of a round wall the background within its circle and below its rim,
// unless one sees that the rim is open for more than half of the circle, or what would be filled
// borders for the most part on background.
//
// `objects`: one entry a voxel, 0 = background; `pieces`: the segments that they were joined from,
// whose walls `walls` are; `points`: CV_32FC3 of the frame; `on_wall`: one entry a
// voxel, not 0 on walls of the room, which stay background; `up`: unit vector. Returns new labels,
// 1 … n in order of their first voxel.
std::vector<int> FillHollows(const VoxelGrid& grid, const std::vector<int>& objects,
                             const std::vector<int>& pieces, RoundWalls walls,
                             const cv::Mat& points, const CameraIntrinsics& intrinsics,
                             const std::vector<char>& on_wall, const Eigen::Vector3f& up);

}  // namespace fovea
