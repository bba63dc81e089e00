#include "server/conversion/geometry.h"

#include <cmath>

#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

v1::Vector3 VectorToProto(const Eigen::Vector3d& vector) {
  v1::Vector3 proto;
  proto.set_x(vector.x());
  proto.set_y(vector.y());
  proto.set_z(vector.z());
  return proto;
}

}  // namespace

v1::Vector3 ToProto(const Eigen::Vector3f& vector) { return VectorToProto(vector.cast<double>()); }

v1::Pose ToProto(const Eigen::Isometry3d& pose) {
  v1::Pose proto;
  *proto.mutable_position() = VectorToProto(pose.translation());
  const Eigen::Quaterniond orientation(pose.linear());
  proto.mutable_orientation()->set_x(orientation.x());
  proto.mutable_orientation()->set_y(orientation.y());
  proto.mutable_orientation()->set_z(orientation.z());
  proto.mutable_orientation()->set_w(orientation.w());
  return proto;
}

Eigen::Isometry3d PoseOf(const OrientedBox& box) {
  // Through a normalised quaternion: float rounding must not leave a matrix that is no rotation.
  const Eigen::Quaterniond orientation(box.rotation.cast<double>());
  return Eigen::Translation3d(box.center.cast<double>()) * orientation.normalized();
}

v1::OrientedBox ToProto(const OrientedBox& box) {
  v1::OrientedBox proto;
  *proto.mutable_pose() = ToProto(PoseOf(box));
  *proto.mutable_size() = ToProto(box.size_m);
  return proto;
}

Eigen::Vector3d FromProto(const v1::Vector3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Eigen::Isometry3d FromProto(const v1::Pose& pose, const std::string& path) {
  const Eigen::Vector3d position = FromProto(pose.position());
  RequireField(position.allFinite(), path + ".position", "must be finite");

  const auto& q = pose.orientation();
  const Eigen::Quaterniond orientation(q.w(), q.x(), q.y(), q.z());
  const double length = orientation.norm();
  RequireField(std::isfinite(length) && std::abs(length - 1) <= 1e-3, path + ".orientation",
               "must be a unit quaternion; its length is " + std::to_string(length));
  return Eigen::Translation3d(position) * orientation.normalized();
}

}  // namespace fovea::server
