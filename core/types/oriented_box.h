// A box in the camera frame (optical: x right, y down, z forward), metres.
#pragma once

#include <Eigen/Core>

namespace fovea {

// The smallest box around an object among those with one axis along gravity.
// Columns of `rotation` are the box axes in the camera frame: x along the longer side of the
// footprint, y along the shorter, z up (against gravity); right-handed.
struct OrientedBox {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
  Eigen::Vector3f size_m = Eigen::Vector3f::Zero();  // full extents along the box axes
};

}  // namespace fovea
