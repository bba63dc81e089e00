"""One object that was found. Frame of all positions: x right, y down, z forward, in metres."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from fovea.geometry import FloatArray, pose_from_proto, vector_from_proto
from fovea.masks import decode_mask
from fovea.v1 import detection_pb2, geometry_pb2


@dataclass(frozen=True)
class BoundingBox2D:
    """Pixels; covers columns x … x + width - 1 and rows y … y + height - 1."""

    x: int
    y: int
    width: int
    height: int


@dataclass(frozen=True, eq=False)
class OrientedBox:
    """A box with its z axis up (against gravity), x along the longer side of its footprint."""

    pose: FloatArray  # 4x4, of the box's centre and axes
    size: FloatArray  # full extents along the box axes


@dataclass(frozen=True, eq=False)
class Grasp:
    """A grasp of a parallel gripper."""

    tool_center_point: FloatArray  # midway between the finger tips
    approach: FloatArray  # unit vector: the way the hand moves in
    closing: FloatArray  # unit vector: the way the fingers close
    opening_m: float  # distance between the fingers that the object needs, without clearance

    @property
    def pose(self) -> FloatArray:
        """4x4 at the tool centre point: x = closing, z = approach, y = z × x."""
        # The vectors were rounded to 32 bits; the matrix is a rotation to the last digits.
        z = self.approach / np.linalg.norm(self.approach)
        y = np.cross(z, self.closing)
        y /= np.linalg.norm(y)
        pose = np.eye(4)
        pose[:3] = np.column_stack([np.cross(y, z), y, z, self.tool_center_point])
        return pose


@dataclass(frozen=True, eq=False)
class PointCloud:
    positions: npt.NDArray[np.float32]  # Nx3
    colors: npt.NDArray[np.uint8]  # Nx3: red, green, blue


@dataclass(frozen=True, eq=False)
class Object:
    """None stands for what was not asked for or does not apply."""

    id: str  # "<frame id>/<label>"
    label: int  # 1, 2, … by falling confidence
    confidence: float  # 0 … 1
    saliency: float  # 0 … 1: how much it stands out
    bounding_box: BoundingBox2D
    num_pixels: int
    oriented_box: OrientedBox
    # Mean of the visible points; lies off the middle, since only one side is seen.
    centroid: FloatArray
    mean_color: tuple[int, int, int]  # red, green, blue
    height_above_support_m: float | None  # of its lowest point; None where there is no support
    truncated: bool  # the mask ends with the image, or with its depth
    # Clear, black or shiny: seen as a hole in the depth of what it stands on, its box is a guess.
    depth_missing: bool
    grasps: list[Grasp]  # best first
    # HxW of the image.
    mask: npt.NDArray[np.bool_] | None = field(repr=False)
    # One point for each pixel of the mask, row-major.
    cloud: PointCloud | None = field(repr=False)
    pose_in_reference: FloatArray | None  # 4x4, of the oriented box; None without camera_pose
    # With DetectOptions.tracking, else None: one number for one thing in all answers with the same
    # Detections.track_epoch.
    track_id: int | None = None
    first_seen_ns: int | None = None  # captured_at_ns of the first answer with it
    times_seen: int = 0  # answers with it; 1: it is new, and may be a mistake
    steadied_box: OrientedBox | None = None  # mean of oriented_box over the last answers
    steadied_over: int = 0  # so many of them; starts again when it was moved
    moving: bool = False  # against the background


def object_from_proto(proto: detection_pb2.Object, height: int, width: int) -> Object:
    box, color = proto.bounding_box, proto.mean_color
    has_height = proto.HasField("height_above_support_m")
    has_reference = proto.HasField("pose_in_reference")
    return Object(
        id=proto.id,
        label=proto.label,
        confidence=proto.confidence,
        saliency=proto.saliency,
        bounding_box=BoundingBox2D(box.x, box.y, box.width, box.height),
        num_pixels=proto.num_pixels,
        oriented_box=box_from_proto(proto.oriented_box),
        centroid=vector_from_proto(proto.centroid),
        mean_color=(color.red, color.green, color.blue),
        height_above_support_m=proto.height_above_support_m if has_height else None,
        truncated=proto.truncated,
        depth_missing=proto.depth_missing,
        grasps=[_grasp(grasp) for grasp in proto.grasps],
        mask=decode_mask(proto.mask, height, width) if proto.HasField("mask") else None,
        cloud=_cloud(proto.cloud) if proto.HasField("cloud") else None,
        pose_in_reference=pose_from_proto(proto.pose_in_reference) if has_reference else None,
        track_id=proto.track_id or None,
        first_seen_ns=proto.first_seen.ToNanoseconds() if proto.HasField("first_seen") else None,
        times_seen=proto.times_seen,
        steadied_box=box_from_proto(proto.steadied_box) if proto.HasField("steadied_box") else None,
        steadied_over=proto.steadied_over,
        moving=proto.moving,
    )


def box_from_proto(proto: geometry_pb2.OrientedBox) -> OrientedBox:
    return OrientedBox(pose=pose_from_proto(proto.pose), size=vector_from_proto(proto.size))


def _grasp(proto: detection_pb2.Grasp) -> Grasp:
    return Grasp(
        tool_center_point=vector_from_proto(proto.tool_center_point),
        approach=vector_from_proto(proto.approach),
        closing=vector_from_proto(proto.closing),
        opening_m=proto.opening_m,
    )


def _cloud(proto: geometry_pb2.PointCloud) -> PointCloud:
    return PointCloud(
        positions=np.array(proto.positions, dtype=np.float32).reshape(-1, 3),
        colors=np.frombuffer(proto.colors, dtype=np.uint8).reshape(-1, 3),
    )
