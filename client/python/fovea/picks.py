"""Objects that people mark for a robot."""

from __future__ import annotations

from dataclasses import dataclass

from fovea.objects import OrientedBox, box_from_proto
from fovea.v1 import detection_service_pb2


@dataclass(frozen=True, eq=False)
class Pick:
    """An object of a frame that was answered before."""

    observer: str  # who marked it
    frame_id: str  # of that frame
    answered_at_ns: int | None  # when that was answered, since 1970
    label: int  # of the object in that answer
    track_id: int | None  # None = that frame was not tracked
    oriented_box: OrientedBox | None  # in the camera frame of that frame


def pick_from_proto(proto: detection_service_pb2.Pick) -> Pick:
    has_time, has_box = proto.HasField("answered_at"), proto.HasField("oriented_box")
    return Pick(
        observer=proto.observer,
        frame_id=proto.frame_id,
        answered_at_ns=proto.answered_at.ToNanoseconds() if has_time else None,
        label=proto.label,
        track_id=proto.track_id or None,
        oriented_box=box_from_proto(proto.oriented_box) if has_box else None,
    )
