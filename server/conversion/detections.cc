#include "server/conversion/detections.h"

#include <cmath>

#include "server/build_info.h"
#include "server/conversion/geometry.h"
#include "server/conversion/grasp.h"
#include "server/conversion/gripper.h"
#include "server/conversion/mask.h"
#include "server/conversion/object.h"
#include "server/conversion/place.h"
#include "server/conversion/planning.h"
#include "server/conversion/trace.h"
#include "server/conversion/tracking.h"

namespace fovea::server {
namespace {

v1::GravitySource SourceToProto(Gravity::Source source) {
  switch (source) {
    case Gravity::Source::kGiven:
      return v1::GRAVITY_SOURCE_REQUEST;
    case Gravity::Source::kEstimated:
      return v1::GRAVITY_SOURCE_ESTIMATED;
    case Gravity::Source::kAssumed:
      return v1::GRAVITY_SOURCE_ASSUMED;
  }
  return v1::GRAVITY_SOURCE_UNSPECIFIED;
}

v1::Gravity GravityToProto(const Gravity& gravity) {
  v1::Gravity proto;
  *proto.mutable_direction() = ToProto(gravity.direction);
  proto.set_source(SourceToProto(gravity.source));
  return proto;
}

v1::SupportSurface SupportToProto(const SupportSurface& support) {
  v1::SupportSurface proto;
  *proto.mutable_plane()->mutable_normal() = ToProto(support.normal);
  proto.mutable_plane()->set_offset(support.offset_m);
  proto.set_num_points(support.num_points);
  return proto;
}

v1::Diagnostics DiagnosticsToProto(const Diagnostics& diagnostics) {
  v1::Diagnostics proto;
  proto.set_num_pixels(diagnostics.num_pixels);
  proto.set_num_measured(diagnostics.num_measured);
  proto.set_num_points(diagnostics.num_points);
  proto.set_seeds_from_color(diagnostics.seeds_from_color);
  proto.set_seeds_from_depth(diagnostics.seeds_from_depth);
  proto.set_seeds_without_depth(diagnostics.seeds_without_depth);
  proto.set_seeds_on_support(diagnostics.seeds_on_support);
  proto.set_num_seeds(diagnostics.num_seeds);
  proto.set_num_voxels(diagnostics.num_voxels);
  proto.set_num_segments(diagnostics.num_segments);
  proto.set_num_merged(diagnostics.num_merged);
  proto.set_segments_too_small(diagnostics.segments_too_small);
  proto.set_segments_implausible(diagnostics.segments_implausible);
  for (const std::string& message : diagnostics.messages) proto.add_messages(message);
  return proto;
}

void AddGrippers(const Detections& detections, const v1::GraspOptions& asked,
                 v1::Detections* proto) {
  for (const Gripper& gripper : detections.grippers) {
    const int i = proto->grippers_size();
    *proto->add_grippers() =
        ToProto(gripper, i < asked.grippers_size() ? asked.grippers(i) : v1::Gripper());
  }
}

// After AddGrippers.
void AddObjects(const Detections& detections, const v1::Frame& frame,
                const v1::DetectOptions& options, v1::Detections* proto) {
  std::optional<Eigen::Isometry3d> reference_from_camera;
  if (frame.has_camera_pose()) {
    reference_from_camera = FromProto(frame.camera_pose(), "frame.camera_pose");
  }
  for (const DetectedObject& object : detections.objects) {
    v1::Object& added = *proto->add_objects();
    added = ToProto(object, frame.id(), reference_from_camera, detections.grippers);
    for (v1::Grasp& grasp : *added.mutable_grasps()) {
      const auto i = static_cast<int>(grasp.gripper_index());
      if (i < proto->grippers_size()) KeepWithin(proto->grippers(i), &grasp);
    }
    AddTrack(object, &added);
    if (options.return_masks()) {
      *added.mutable_mask() = MaskToProto(detections.labels, object.label, object.bounds_px);
    }
    if (options.return_clouds()) *added.mutable_cloud() = CloudToProto(object.cloud);
  }
}

void AddRejected(const Detections& detections, v1::Detections* proto) {
  for (const RejectedObject& rejected : detections.rejected) {
    v1::RejectedObject& added = *proto->add_rejected();
    *added.mutable_bounding_box() = ToProto(rejected.bounds_px);
    added.set_probability(rejected.probability);
    added.set_reason(rejected.reason);
  }
}

}  // namespace

v1::StageTime ToProto(const StageTime& time) {
  constexpr std::int64_t kNanosPerSecond = 1'000'000'000;
  const std::int64_t nanos = std::llround(time.duration_ms * 1e6);
  v1::StageTime proto;
  proto.set_stage(time.stage);
  proto.mutable_duration()->set_seconds(nanos / kNanosPerSecond);
  proto.mutable_duration()->set_nanos(static_cast<std::int32_t>(nanos % kNanosPerSecond));
  return proto;
}

v1::Detections ToProto(const Detections& detections, const Trace& trace, const v1::Frame& frame,
                       const v1::DetectOptions& options) {
  v1::Detections proto;
  proto.set_frame_id(frame.id());
  if (frame.has_captured_at()) *proto.mutable_captured_at() = frame.captured_at();
  proto.set_profile(options.profile().empty() ? "default" : options.profile());
  proto.set_width(static_cast<std::uint32_t>(detections.labels.cols));
  proto.set_height(static_cast<std::uint32_t>(detections.labels.rows));
  *proto.mutable_gravity() = GravityToProto(detections.gravity);
  if (detections.support) {
    *proto.mutable_support_surface() = SupportToProto(*detections.support);
  }
  for (const StageTime& time : detections.stage_times) {
    *proto.add_stage_times() = ToProto(time);
  }
  *proto.mutable_diagnostics() = DiagnosticsToProto(detections.diagnostics);
  proto.set_server_version(Version());
  proto.set_server_build(Commit());
  proto.set_incomplete(detections.incomplete);
  AddGrippers(detections, options.grasps(), &proto);
  AddObjects(detections, frame, options, &proto);
  for (const FreePlace& place : detections.free_places) *proto.add_free_places() = ToProto(place);
  for (const CollisionPrimitive& primitive : detections.support_collisions) {
    *proto.add_support_collisions() = ToProto(primitive);
  }
  if (detections.height_map) *proto.mutable_height_map() = ToProto(*detections.height_map);
  if (options.return_rejected()) AddRejected(detections, &proto);
  AddTracking(detections, &proto);
  AddTrace(trace, options, &proto);
  return proto;
}

}  // namespace fovea::server
