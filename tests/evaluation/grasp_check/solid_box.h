// Boxes in any direction, and whether they meet.
#pragma once

#include <Eigen/Geometry>

namespace fovea::evaluation {

struct SolidBox {
  Eigen::Isometry3d world_from_box = Eigen::Isometry3d::Identity();  // origin in the middle
  Eigen::Vector3d half_m = Eigen::Vector3d::Zero();
};

// True if they share volume (separating axes).
bool Meet(const SolidBox& a, const SolidBox& b);

bool Contains(const SolidBox& box, const Eigen::Vector3d& point);

}  // namespace fovea::evaluation
