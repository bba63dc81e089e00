// How sure the box of an object is.
#pragma once

#include <Eigen/Core>

namespace fovea {

// As fitted to its points and outline, and calibrated on generated scenes.
struct BoxUncertainty {
  // Of the middle of the box (x, y, z in the camera frame, m) and its turn about its z axis (rad).
  Eigen::Matrix4f pose_covariance = Eigen::Matrix4f::Zero();
  Eigen::Vector3f size_sigma_m = Eigen::Vector3f::Zero();  // along the axes of the box
};

}  // namespace fovea
