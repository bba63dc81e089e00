#include "server/conversion/object.h"

#include "server/conversion/geometry.h"
#include "server/conversion/mask.h"

namespace fovea::server {
namespace {

Eigen::Isometry3d PoseOf(const OrientedBox& box) {
  // Through a normalised quaternion: float rounding must not leave a matrix that is no rotation.
  const Eigen::Quaterniond orientation(box.rotation.cast<double>());
  return Eigen::Translation3d(box.center.cast<double>()) * orientation.normalized();
}

v1::Color ColorToProto(const std::array<std::uint8_t, 3>& rgb) {
  v1::Color color;
  color.set_red(rgb[0]);
  color.set_green(rgb[1]);
  color.set_blue(rgb[2]);
  return color;
}

v1::Grasp GraspToProto(const Grasp& grasp) {
  v1::Grasp proto;
  *proto.mutable_tool_center_point() = ToProto(grasp.tool_center_point);
  *proto.mutable_approach() = ToProto(grasp.approach);
  *proto.mutable_closing() = ToProto(grasp.closing);
  proto.set_opening_m(grasp.opening_m);
  return proto;
}

}  // namespace

v1::Object ToProto(const DetectedObject& object, const std::string& frame_id,
                   const std::optional<Eigen::Isometry3d>& reference_from_camera) {
  v1::Object proto;
  proto.set_id(frame_id + "/" + std::to_string(object.label));
  proto.set_label(static_cast<std::uint32_t>(object.label));
  proto.set_confidence(object.confidence);
  proto.set_saliency(object.saliency);
  *proto.mutable_bounding_box() = ToProto(object.bounds_px);
  proto.set_num_pixels(static_cast<std::uint32_t>(object.num_pixels));

  const Eigen::Isometry3d camera_from_box = PoseOf(object.box);
  *proto.mutable_oriented_box()->mutable_pose() = ToProto(camera_from_box);
  *proto.mutable_oriented_box()->mutable_size() = ToProto(object.box.size_m);
  if (reference_from_camera) {
    *proto.mutable_pose_in_reference() = ToProto(*reference_from_camera * camera_from_box);
  }

  *proto.mutable_centroid() = ToProto(object.centroid);
  *proto.mutable_mean_color() = ColorToProto(object.mean_color);
  if (object.height_above_support_m) {
    proto.set_height_above_support_m(*object.height_above_support_m);
  }
  proto.set_truncated(object.truncated);
  proto.set_depth_missing(object.depth_missing);
  for (const Grasp& grasp : object.grasps) *proto.add_grasps() = GraspToProto(grasp);
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
