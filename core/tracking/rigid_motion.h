// How a camera moved, from points that it saw before and after.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea {

// A point of the scene in two frames; camera frames, metres.
struct PointPair {
  Eigen::Vector3d from, to;
  Eigen::Vector2d to_px;
};

struct RigidMotion {
  Eigen::Isometry3d to_from_from = Eigen::Isometry3d::Identity();  // p_to = … · p_from
  std::vector<char> is_inlier;                                     // of each pair
  int num_inliers = 0;
  double error_m = 0;  // standard deviation, where most of the inliers are
};

// Random samples of three pairs (Fischler and Bolles 1981), each of which gives a motion (Umeyama
// 1991); the one with most pairs within three pixels and the noise of depth, then least squares of
// reprojection and depth over these (Gauss-Newton). The samples are the same in each run. Nothing
// where fewer than kFewestInliers agree, or less than a quarter of all. O(256 · pairs): 1 ms for
// 400.
constexpr int kFewestInliers = 12;
std::optional<RigidMotion> FindRigidMotion(const std::vector<PointPair>& pairs,
                                           const CameraIntrinsics& intrinsics, int width_px);

}  // namespace fovea
