#pragma once

#include <Eigen/Geometry>
#include <string>

#include "core/types/detections.h"
#include "fovea/v1/geometry.pb.h"

namespace fovea::server {

v1::Vector3 ToProto(const Eigen::Vector3f& vector);
v1::Pose ToProto(const Eigen::Isometry3d& pose);

// The pose of a box, a rotation to the last digits of double.
Eigen::Isometry3d PoseOf(const OrientedBox& box);
v1::OrientedBox ToProto(const OrientedBox& box);

Eigen::Vector3d FromProto(const v1::Vector3& vector);

// Throws std::invalid_argument that starts with `path` unless all numbers are finite and the
// quaternion's length is one within 1e-3 (it is normalised then).
Eigen::Isometry3d FromProto(const v1::Pose& pose, const std::string& path);

}  // namespace fovea::server
