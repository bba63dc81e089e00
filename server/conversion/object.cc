#include "server/conversion/object.h"

#include "server/conversion/color.h"
#include "server/conversion/geometry.h"
#include "server/conversion/grasp.h"
#include "server/conversion/mask.h"
#include "server/conversion/planning.h"
#include "server/conversion/shape.h"

namespace fovea::server {
namespace {

v1::BoxUncertainty UncertaintyToProto(const BoxUncertainty& uncertainty) {
  v1::BoxUncertainty proto;
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) {
      proto.add_pose_covariance(uncertainty.pose_covariance(row, column));
    }
  }
  *proto.mutable_size_sigma() = ToProto(uncertainty.size_sigma_m);
  return proto;
}

}  // namespace

v1::Object ToProto(const DetectedObject& object, const std::string& frame_id,
                   const std::optional<Eigen::Isometry3d>& reference_from_camera,
                   const std::vector<Gripper>& grippers) {
  v1::Object proto;
  proto.set_id(frame_id + "/" + std::to_string(object.label));
  proto.set_label(static_cast<std::uint32_t>(object.label));
  proto.set_confidence(object.confidence);
  proto.set_saliency(object.saliency);
  *proto.mutable_bounding_box() = ToProto(object.bounds_px);
  proto.set_num_pixels(static_cast<std::uint32_t>(object.num_pixels));

  *proto.mutable_oriented_box() = ToProto(object.box);
  *proto.mutable_visible_box() = ToProto(object.visible_box);
  if (reference_from_camera) {
    *proto.mutable_pose_in_reference() = ToProto(*reference_from_camera * PoseOf(object.box));
  }
  *proto.mutable_shape() = ToProto(object.shape);
  proto.set_yaw_is_arbitrary(object.yaw_is_arbitrary);
  proto.set_unseen_share(object.unseen_share);
  if (object.uncertainty) *proto.mutable_uncertainty() = UncertaintyToProto(*object.uncertainty);
  if (object.collision) *proto.mutable_collision() = ToProto(*object.collision);

  *proto.mutable_centroid() = ToProto(object.centroid);
  *proto.mutable_mean_color() = ColorToProto(object.mean_color);
  for (const ColorPart& part : object.colors) *proto.add_colors() = ToProto(part);
  if (object.height_above_support_m) {
    proto.set_height_above_support_m(*object.height_above_support_m);
  }
  proto.set_truncated(object.truncated);
  proto.set_depth_missing(object.depth_missing);
  const auto name_of = [&](std::size_t gripper) {
    return gripper < grippers.size() ? grippers[gripper].name : std::string();
  };
  for (const Grasp& grasp : object.grasps) {
    *proto.add_grasps() = ToProto(grasp, name_of(grasp.gripper));
  }
  for (const NoGrasp& none : object.no_grasps) {
    *proto.add_no_grasps() = ToProto(none, name_of(none.gripper));
  }
  for (const int label : object.stands_on) proto.add_stands_on(static_cast<std::uint32_t>(label));
  for (const int label : object.leans_on) proto.add_leans_on(static_cast<std::uint32_t>(label));
  for (const int label : object.blocked_by) proto.add_blocked_by(static_cast<std::uint32_t>(label));
  return proto;
}

v1::PointCloud CloudToProto(const std::vector<ColoredPoint>& cloud) {
  v1::PointCloud proto;
  proto.mutable_positions()->Reserve(static_cast<int>(3 * cloud.size()));
  proto.mutable_colors()->reserve(3 * cloud.size());
  for (const auto& point : cloud) {
    proto.add_positions(point.x);
    proto.add_positions(point.y);
    proto.add_positions(point.z);
    for (const std::uint8_t channel : {point.r, point.g, point.b}) {
      proto.mutable_colors()->push_back(static_cast<char>(channel));
    }
  }
  return proto;
}

}  // namespace fovea::server
