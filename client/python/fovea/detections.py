"""What was found in a frame."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from fovea.arrays import array_of
from fovea.enums import name_of
from fovea.geometry import FloatArray, vector_from_proto
from fovea.grippers import Gripper, gripper_from_proto
from fovea.objects import Object, OrientedBox, box_from_proto, object_from_proto
from fovea.planning import (
    CollisionPrimitive,
    HeightMap,
    height_map_from_proto,
    primitive_from_proto,
)
from fovea.tracking import (
    CameraMotion,
    HiddenTrack,
    camera_motion_from_proto,
    hidden_track_from_proto,
)
from fovea.v1 import detection_pb2, frame_pb2


@dataclass(frozen=True, eq=False)
class Gravity:
    direction: FloatArray  # unit vector that points down
    source: str  # "estimated", "request" or, where nothing was measured, "assumed"


@dataclass(frozen=True, eq=False)
class SupportSurface:
    """The plane normal · p + offset = 0. The normal is a unit vector that points up; the points are
    those on it of all that it was fitted to."""

    normal: FloatArray
    offset: float
    num_points: int


@dataclass(frozen=True, eq=False)
class Seed:
    """A position at which an object was looked for."""

    x: int
    y: int
    position: FloatArray
    source: str  # "color_saliency", "depth_saliency" or "unexplained_region"


@dataclass(frozen=True)
class RemovedSeed:
    """A salient position that did not become an object hypothesis."""

    x: int
    y: int
    source: str  # as of Seed
    reason: str  # "without_depth" or "on_support": on a support surface, or where none is below


@dataclass(frozen=True, eq=False)
class Trace:
    """The steps between a frame and its objects. All images are HxW, as the colour image is."""

    filled_depth: npt.NDArray[np.uint16]  # millimetres after hole filling; 0 = none
    gamma_per_m2: float  # how fast the hypotheses fade with the distance from their seeds
    seeds: list[Seed]  # hypothesis k is that of seeds[k - 1]
    removed_seeds: list[RemovedSeed]
    # 0 = background.
    hypotheses: npt.NDArray[np.uint16]  # after the graph cut: k where hypothesis k won
    segments: npt.NDArray[np.uint16]  # before those of one object are joined
    merged: npt.NDArray[np.uint16]  # after, before it is decided what is an object


@dataclass(frozen=True)
class RejectedObject:
    """Something that was considered and is not reported."""

    x: int  # of the smallest upright rectangle around it, in pixels of the colour image
    y: int
    width: int
    height: int
    probability: float  # that it is an object
    reason: str  # for people: what speaks against it most


@dataclass(frozen=True)
class Diagnostics:
    """How much there was at each step: says why there are few objects, or none."""

    num_pixels: int  # of the colour image
    num_measured: int  # with depth
    num_points: int  # within max_depth_m, without flying pixels
    # Salient positions, and those that became no seed; 0 where "default" finds a support surface,
    # all of what stands on which it looks at.
    seeds_from_color: int
    seeds_from_depth: int
    seeds_without_depth: int
    seeds_on_support: int
    num_seeds: int  # all that objects were looked for at
    num_voxels: int
    num_segments: int  # after the graph cut
    num_merged: int  # by how many these became fewer as they were joined to others
    segments_too_small: int
    segments_implausible: int  # considered, and not likely enough an object
    messages: list[str]  # for people: what limited the result, most telling first


@dataclass(frozen=True, eq=False)
class FreePlace:
    """Where something can be put down: the support was seen to be empty there."""

    box: OrientedBox  # as it would stand there
    clearance_m: float  # around it, to whatever is not seen to be free


@dataclass(frozen=True, eq=False)
class Detections:
    frame_id: str
    captured_at_ns: int | None
    profile: str
    width: int  # of the colour image, in pixels
    height: int
    objects: list[Object]
    gravity: Gravity
    support_surface: SupportSurface | None  # None where none was found
    # Milliseconds, in the order of the pipeline; "queue" and "decode" are the server's part;
    # "processor_wait" is in the others: how long it waited for a processor that other
    # threads or programs had.
    stage_times_ms: dict[str, float]
    diagnostics: Diagnostics
    # By name, "color" and "depth": HxW uint8, 255 = most salient of this frame.
    saliency_maps: dict[str, npt.NDArray[np.uint8]]
    seeds: list[Seed]
    # What made this answer: version and commit of the server.
    server_version: str
    server_build: str
    trace: Trace | None = None  # unless asked for
    rejected: list[RejectedObject] = field(default_factory=list)  # likeliest first; if asked for
    incomplete: bool = False  # the time budget ended before all of the frame was looked at
    # Where something of DetectOptions.place_size can be put down, most room first.
    free_places: list[FreePlace] = field(default_factory=list)
    # With DetectOptions.tracking, else None: track_ids of one epoch belong together; another one
    # says that they started anew, as they do when a stream was opened again.
    track_epoch: int | None = None
    camera_motion: CameraMotion | None = None  # None also for the first frame of an epoch
    # For two seconds after a thing was seen last, by track_id.
    hidden_tracks: list[HiddenTrack] = field(default_factory=list)
    # Whose the grippers are that grasps were planned for: "request"; "server", as its operator says
    # for this robot; "default", one that opens 0.085 m; None of older servers.
    grippers_source: str | None = None
    # With DetectOptions.collision_primitives: a box below each surface that things stand on.
    support_collisions: list[CollisionPrimitive] = field(default_factory=list)
    height_map: HeightMap | None = None  # with DetectOptions.height_map_cell_m
    # That grasps were planned for, with every length: Grasp.gripper_index counts them. Empty where
    # none were to be planned, and of servers that do not say.
    grippers: list[Gripper] = field(default_factory=list)

    def label_image(self) -> npt.NDArray[np.uint16]:
        """HxW: 0 = background, k = the object with label k. Needs masks."""
        labels = np.zeros((self.height, self.width), dtype=np.uint16)
        for found in self.objects:
            if found.mask is None:
                raise ValueError("there are no masks; ask for them with return_masks=True")
            labels[found.mask] = found.label
        return labels


def detections_from_proto(proto: detection_pb2.Detections) -> Detections:
    captured_at = proto.captured_at.ToNanoseconds() if proto.HasField("captured_at") else None
    return Detections(
        frame_id=proto.frame_id,
        captured_at_ns=captured_at,
        profile=proto.profile,
        width=proto.width,
        height=proto.height,
        objects=[object_from_proto(each, proto.height, proto.width) for each in proto.objects],
        gravity=Gravity(
            direction=vector_from_proto(proto.gravity.direction),
            source=name_of(detection_pb2.GravitySource, proto.gravity.source),
        ),
        support_surface=_support(proto.support_surface)
        if proto.HasField("support_surface")
        else None,
        stage_times_ms={
            time.stage: time.duration.ToNanoseconds() / 1e6 for time in proto.stage_times
        },
        diagnostics=_diagnostics(proto.diagnostics),
        saliency_maps={
            each.name: array_of(each.data, np.uint8, each.height, each.width)
            for each in proto.saliency_maps
        },
        seeds=[_seed(seed) for seed in proto.seeds],
        server_version=proto.server_version,
        server_build=proto.server_build,
        trace=_trace(proto.trace) if proto.HasField("trace") else None,
        rejected=[_rejected(each) for each in proto.rejected],
        incomplete=proto.incomplete,
        free_places=[
            FreePlace(box=box_from_proto(each.box), clearance_m=each.clearance_m)
            for each in proto.free_places
        ],
        track_epoch=proto.track_epoch or None,
        camera_motion=camera_motion_from_proto(proto.camera_motion)
        if proto.HasField("camera_motion")
        else None,
        hidden_tracks=[hidden_track_from_proto(each) for each in proto.hidden_tracks],
        grippers_source=name_of(detection_pb2.GripperSource, proto.grippers_source)
        if proto.grippers_source
        else None,
        grippers=[gripper_from_proto(each) for each in proto.grippers],
        support_collisions=[primitive_from_proto(each) for each in proto.support_collisions],
        height_map=height_map_from_proto(proto.height_map)
        if proto.HasField("height_map")
        else None,
    )


def _support(proto: detection_pb2.SupportSurface) -> SupportSurface:
    return SupportSurface(
        normal=vector_from_proto(proto.plane.normal),
        offset=proto.plane.offset,
        num_points=proto.num_points,
    )


def _seed(proto: detection_pb2.Seed) -> Seed:
    source = name_of(detection_pb2.SeedSource, proto.source)
    return Seed(x=proto.x, y=proto.y, position=vector_from_proto(proto.position), source=source)


def _rejected(proto: detection_pb2.RejectedObject) -> RejectedObject:
    box = proto.bounding_box
    return RejectedObject(
        x=box.x,
        y=box.y,
        width=box.width,
        height=box.height,
        probability=proto.probability,
        reason=proto.reason,
    )


def _diagnostics(proto: detection_pb2.Diagnostics) -> Diagnostics:
    names = [name for name in Diagnostics.__dataclass_fields__ if name != "messages"]
    return Diagnostics(
        messages=list(proto.messages), **{name: getattr(proto, name) for name in names}
    )


def _image(
    proto: detection_pb2.LabelImage | frame_pb2.DepthImage,
) -> npt.NDArray[np.uint16]:
    return array_of(proto.data, "<u2", proto.height, proto.width)


def _trace(proto: detection_pb2.Trace) -> Trace:
    return Trace(
        filled_depth=_image(proto.filled_depth),
        gamma_per_m2=proto.gamma_per_m2,
        seeds=[_seed(seed) for seed in proto.seeds],
        removed_seeds=[
            RemovedSeed(
                x=each.x,
                y=each.y,
                source=name_of(detection_pb2.SeedSource, each.source),
                reason=name_of(detection_pb2.SeedRemoval, each.reason),
            )
            for each in proto.removed_seeds
        ],
        hypotheses=_image(proto.hypotheses),
        segments=_image(proto.segments),
        merged=_image(proto.merged),
    )
