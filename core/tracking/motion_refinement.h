// The part of rigid_motion.h that is least squares.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/tracking/rigid_motion.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct MotionProblem {
  const std::vector<PointPair>& pairs;
  const CameraIntrinsics& k;
  double px;  // of an image 640 wide

  // What is left between p, the pair's first point moved, and its second one: pixels on both axes,
  // and depth in standard deviations, which weigh like one pixel.
  Eigen::Vector3d Residual(const PointPair& pair, const Eigen::Vector3d& p) const;
};

// Moves to the least squares of the residuals over the inliers (Gauss-Newton) and sets the error.
// False where these do not determine the motion.
bool Refine(const MotionProblem& problem, RigidMotion& motion);

}  // namespace fovea
