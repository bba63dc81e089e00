#pragma once

#include <Eigen/Geometry>
#include <string>

#include "fovea/v1/geometry.pb.h"

namespace fovea::server {

v1::Vector3 ToProto(const Eigen::Vector3f& vector);
v1::Pose ToProto(const Eigen::Isometry3d& pose);

Eigen::Vector3d FromProto(const v1::Vector3& vector);

// Throws std::invalid_argument that starts with `path` unless all numbers are finite and the
// quaternion's length is one within 1e-3 (it is normalised then).
Eigen::Isometry3d FromProto(const v1::Pose& pose, const std::string& path);

}  // namespace fovea::server
