"""What a stream knows of things beyond one frame."""

from __future__ import annotations

from dataclasses import dataclass

from fovea.enums import name_of
from fovea.geometry import FloatArray, pose_from_proto
from fovea.objects import OrientedBox, box_from_proto
from fovea.v1 import detection_pb2


@dataclass(frozen=True, eq=False)
class CameraMotion:
    """What tracking takes for the camera's motion since the frame answered before."""

    # "request" (by camera_pose), "estimated" (from both frames), "standing", or "none": it is not
    # known, and guessed: see the contract.
    source: str
    motion: FloatArray  # 4x4, of this frame's camera in the camera frame of that one


@dataclass(frozen=True, eq=False)
class HiddenTrack:
    """A thing of the answers before that is not among the objects of this one."""

    track_id: int
    last_box: OrientedBox  # where it should be now, in this answer's camera frame
    last_seen_ns: int | None  # captured_at_ns of the last answer with it
    times_seen: int
    # "covered", "out_of_view", "not_detected" (it seems to be there), or "gone": the camera sees
    # through where it was.
    reason: str


def camera_motion_from_proto(proto: detection_pb2.CameraMotion) -> CameraMotion:
    return CameraMotion(
        source=name_of(detection_pb2.CameraMotionSource, proto.source),
        motion=pose_from_proto(proto.motion),
    )


def hidden_track_from_proto(proto: detection_pb2.HiddenTrack) -> HiddenTrack:
    has_time = proto.HasField("last_seen")
    return HiddenTrack(
        track_id=proto.track_id,
        last_box=box_from_proto(proto.last_box),
        last_seen_ns=proto.last_seen.ToNanoseconds() if has_time else None,
        times_seen=proto.times_seen,
        reason=name_of(detection_pb2.HiddenReason, proto.reason),
    )
