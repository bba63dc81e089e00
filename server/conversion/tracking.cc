#include "server/conversion/tracking.h"

#include "server/conversion/geometry.h"
#include "server/conversion/object.h"

namespace fovea::server {
namespace {

google::protobuf::Timestamp TimeToProto(const CaptureTime& time) {
  google::protobuf::Timestamp proto;
  proto.set_seconds(time.seconds);
  proto.set_nanos(time.nanos);
  return proto;
}

v1::CameraMotionSource SourceToProto(CameraMotionSource source) {
  switch (source) {
    case CameraMotionSource::kFirstFrame:
      break;
    case CameraMotionSource::kGiven:
      return v1::CAMERA_MOTION_SOURCE_REQUEST;
    case CameraMotionSource::kEstimated:
      return v1::CAMERA_MOTION_SOURCE_ESTIMATED;
    case CameraMotionSource::kStanding:
      return v1::CAMERA_MOTION_SOURCE_STANDING;
    case CameraMotionSource::kUnknown:
      return v1::CAMERA_MOTION_SOURCE_NONE;
  }
  return v1::CAMERA_MOTION_SOURCE_UNSPECIFIED;
}

v1::HiddenReason ReasonToProto(HiddenReason reason) {
  switch (reason) {
    case HiddenReason::kCovered:
      return v1::HIDDEN_REASON_COVERED;
    case HiddenReason::kOutOfView:
      return v1::HIDDEN_REASON_OUT_OF_VIEW;
    case HiddenReason::kNotDetected:
      return v1::HIDDEN_REASON_NOT_DETECTED;
    case HiddenReason::kGone:
      return v1::HIDDEN_REASON_GONE;
  }
  return v1::HIDDEN_REASON_UNSPECIFIED;
}

v1::HiddenTrack HiddenToProto(const HiddenTrack& track) {
  v1::HiddenTrack proto;
  proto.set_track_id(track.id);
  *proto.mutable_last_box() = ToProto(track.box);
  if (track.last_seen) *proto.mutable_last_seen() = TimeToProto(*track.last_seen);
  proto.set_times_seen(track.times_seen);
  proto.set_reason(ReasonToProto(track.reason));
  return proto;
}

}  // namespace

FrameContext ContextOf(const v1::Frame& frame) {
  FrameContext context;
  if (frame.has_camera_pose()) {
    context.camera_pose = FromProto(frame.camera_pose(), "frame.camera_pose");
  }
  if (frame.has_captured_at()) {
    context.captured_at = CaptureTime{frame.captured_at().seconds(), frame.captured_at().nanos()};
  }
  return context;
}

void AddTrack(const DetectedObject& object, v1::Object* proto) {
  if (!object.track) return;
  const ObjectTrack& track = *object.track;
  proto->set_track_id(track.id);
  if (track.first_seen) *proto->mutable_first_seen() = TimeToProto(*track.first_seen);
  proto->set_times_seen(track.times_seen);
  *proto->mutable_steadied_box() = ToProto(track.steadied_box);
  proto->set_steadied_over(track.steadied_over);
  proto->set_moving(track.is_moving);
}

void AddTracking(const Detections& detections, v1::Detections* proto) {
  if (!detections.tracking) return;
  const Tracking& tracking = *detections.tracking;
  proto->set_track_epoch(tracking.epoch);
  if (tracking.motion.source != CameraMotionSource::kFirstFrame) {
    proto->mutable_camera_motion()->set_source(SourceToProto(tracking.motion.source));
    *proto->mutable_camera_motion()->mutable_motion() = ToProto(tracking.motion.last_from_this);
  }
  for (const HiddenTrack& track : tracking.hidden) {
    *proto->add_hidden_tracks() = HiddenToProto(track);
  }
}

}  // namespace fovea::server
