"""One object that was found. Frame of all positions: x right, y down, z forward, in metres."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from fovea.arrays import array_of
from fovea.enums import name_of
from fovea.geometry import FloatArray, pose_from_proto, vector_from_proto
from fovea.masks import decode_mask
from fovea.planning import CollisionPrimitive, primitive_from_proto
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
    """A box with its z axis up, the normal of the support surface that it is above (against gravity
    where there is none), x along the longer side of its footprint."""

    pose: FloatArray  # 4x4, of the box's centre and axes
    size: FloatArray  # full extents along the box axes


@dataclass(frozen=True, eq=False)
class Shape:
    """The solid that an object is taken for. None stands for what this kind does not have."""

    kind: str  # "other", "box", "cylinder", "sphere", "revolution" or "flat"
    confidence: float  # that it is of this kind, 0 … 1
    residual_m: float  # root mean square distance between its surface and the points seen
    center: FloatArray | None  # the middle of the axis, or of the sphere
    axis: FloatArray | None  # unit vector, upwards where it stands
    radius_m: float | None  # the largest
    length_m: float | None  # along the axis
    radii_m: FloatArray  # of "revolution": at evenly spaced heights, the lowest first; else empty
    hollow: bool  # of "revolution": open at its top, as bowls and cups


@dataclass(frozen=True, eq=False)
class BoxUncertainty:
    """How sure an oriented box is: standard deviations and covariances of its errors."""

    # 4x4: of x, y, z of the middle (camera frame, m) and of the turn about the box's z axis (rad).
    pose_covariance: FloatArray
    size_sigma: FloatArray  # standard deviations of the sizes along the box axes, m


@dataclass(frozen=True, eq=False)
class ColorPart:
    """The pixels of an object that have one of the eleven basic colours."""

    # "black", "gray", "white", "red", "orange", "yellow", "green", "blue", "purple", "pink" or
    # "brown"
    name: str
    share: float  # of the mask, 0 … 1
    mean: tuple[int, int, int]  # red, green, blue
    centroid: FloatArray  # mean of their points


@dataclass(frozen=True, eq=False)
class Grasp:
    """A grasp of a gripper with two parallel fingers, or with a suction cup."""

    tool_center_point: FloatArray  # midway between the finger tips; the middle of the cup's lip
    approach: FloatArray  # unit vector: the way the hand moves in
    closing: FloatArray  # unit vector: the way the fingers close
    # Distance between the fingers that the object needs, without clearance; 0 with suction.
    opening_m: float
    kind: str = "across"  # "across", "rim", "handle", "side" or "suction"
    gripper: str = ""  # its name
    gripper_index: int = 0  # in Detections.grippers
    probability: float = 0.0  # of success, 0 … 1, calibrated
    # Where the tool centre point is before the hand moves in, clear of everything.
    pre_grasp_position: FloatArray | None = None
    # Smallest distance between the open hand on its way in and everything else; at most 0.02.
    clearance_m: float = 0.0
    # share of both contact areas, or of the lip of a suction cup, that no pixel shows, 0 … 1
    unseen_contacts: float = 0.0
    # With suction: of the patch from a plane or sphere, root mean square; the widest cup that fits
    # on it, of 1, 1.25, 1.5, 2 and 3 times the gripper's; how far the object's middle is from the
    # tool's axis.
    unevenness_m: float = 0.0
    usable_diameter_m: float = 0.0
    off_center_m: float = 0.0
    # How far apart the fingers should be before and while the hand moves in; 0 with suction.
    pre_grasp_opening_m: float = 0.0
    # Of what the palm or the tube of the cup passes on its way in: how much of a cross section the
    # camera did not see to be free, where that is most, 0 … 1.
    unseen_way: float = 0.0

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


@dataclass(frozen=True)
class NoGrasp:
    """A gripper that has no grasp of the object, and what most of its candidates failed for."""

    gripper: str  # its name
    gripper_index: int
    # "too_wide", "neighbor", "covered", "too_low", "sloped", "cut", "too_little_seen", "no_seal" or
    # "unlikely"
    reason: str


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
    oriented_box: OrientedBox  # of the whole object, with what the camera cannot see of its shape
    visible_box: OrientedBox  # around what was seen alone, with a yaw of its own
    shape: Shape
    yaw_is_arbitrary: bool  # round about the upright: any yaw describes it as well
    unseen_share: float  # of its surface without the bottom, 0 … 1; 1 with depth_missing
    # Mean of the visible points; lies off the middle, since only one side is seen.
    centroid: FloatArray
    mean_color: tuple[int, int, int]  # red, green, blue
    height_above_support_m: float | None  # of its lowest point; None where there is no support
    truncated: bool  # the mask ends with the image, its depth or the region
    # Clear, black or shiny: seen as a hole in the depth of what it stands on, its box is a guess.
    depth_missing: bool
    grasps: list[Grasp]  # of each gripper, likeliest first
    no_grasps: list[NoGrasp]  # the grippers without one
    stands_on: list[int]  # labels of what carries it, 0 = a support surface
    blocked_by: list[int]  # labels of what must be taken away before it, in this order
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
    # By name, the largest part first; those of an eighth of the mask and more.
    colors: list[ColorPart] = field(default_factory=list)
    uncertainty: BoxUncertainty | None = None  # of oriented_box; None with depth_missing
    leans_on: list[int] = field(default_factory=list)  # labels of what holds it up at its side
    # With DetectOptions.collision_primitives, else None: encloses the object.
    collision: CollisionPrimitive | None = None


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
        visible_box=box_from_proto(proto.visible_box),
        shape=_shape(proto.shape),
        yaw_is_arbitrary=proto.yaw_is_arbitrary,
        unseen_share=proto.unseen_share,
        centroid=vector_from_proto(proto.centroid),
        mean_color=(color.red, color.green, color.blue),
        height_above_support_m=proto.height_above_support_m if has_height else None,
        truncated=proto.truncated,
        depth_missing=proto.depth_missing,
        grasps=[_grasp(grasp) for grasp in proto.grasps],
        no_grasps=[_no_grasp(none) for none in proto.no_grasps],
        stands_on=list(proto.stands_on),
        blocked_by=list(proto.blocked_by),
        mask=decode_mask(proto.mask, height, width) if proto.HasField("mask") else None,
        cloud=_cloud(proto.cloud) if proto.HasField("cloud") else None,
        pose_in_reference=pose_from_proto(proto.pose_in_reference) if has_reference else None,
        track_id=proto.track_id or None,
        first_seen_ns=proto.first_seen.ToNanoseconds() if proto.HasField("first_seen") else None,
        times_seen=proto.times_seen,
        steadied_box=box_from_proto(proto.steadied_box) if proto.HasField("steadied_box") else None,
        steadied_over=proto.steadied_over,
        moving=proto.moving,
        colors=[_color_part(each) for each in proto.colors],
        uncertainty=_uncertainty(proto.uncertainty) if proto.HasField("uncertainty") else None,
        leans_on=list(proto.leans_on),
        collision=primitive_from_proto(proto.collision) if proto.HasField("collision") else None,
    )


def box_from_proto(proto: geometry_pb2.OrientedBox) -> OrientedBox:
    return OrientedBox(pose=pose_from_proto(proto.pose), size=vector_from_proto(proto.size))


def _color_part(proto: detection_pb2.ColorPart) -> ColorPart:
    return ColorPart(
        name=name_of(detection_pb2.ColorName, proto.name),
        share=proto.share,
        mean=(proto.mean.red, proto.mean.green, proto.mean.blue),
        centroid=vector_from_proto(proto.centroid),
    )


def _uncertainty(proto: detection_pb2.BoxUncertainty) -> BoxUncertainty:
    return BoxUncertainty(
        pose_covariance=np.array(proto.pose_covariance).reshape(4, 4),
        size_sigma=vector_from_proto(proto.size_sigma),
    )


def _grasp(proto: detection_pb2.Grasp) -> Grasp:
    return Grasp(
        tool_center_point=vector_from_proto(proto.tool_center_point),
        approach=vector_from_proto(proto.approach),
        closing=vector_from_proto(proto.closing),
        opening_m=proto.opening_m,
        kind=name_of(detection_pb2.GraspKind, proto.kind),
        gripper=proto.gripper,
        gripper_index=proto.gripper_index,
        probability=proto.probability,
        pre_grasp_position=vector_from_proto(proto.pre_grasp_position),
        clearance_m=proto.clearance_m,
        unseen_contacts=proto.unseen_contacts,
        unevenness_m=proto.unevenness_m,
        usable_diameter_m=proto.usable_diameter_m,
        off_center_m=proto.off_center_m,
        pre_grasp_opening_m=proto.pre_grasp_opening_m,
        unseen_way=proto.unseen_way,
    )


def _no_grasp(proto: detection_pb2.NoGrasp) -> NoGrasp:
    return NoGrasp(
        gripper=proto.gripper,
        gripper_index=proto.gripper_index,
        reason=name_of(detection_pb2.NoGraspReason, proto.reason),
    )


def _shape(proto: detection_pb2.Shape) -> Shape:
    is_round = proto.HasField("center")
    return Shape(
        kind=name_of(detection_pb2.ShapeKind, proto.kind),
        confidence=proto.confidence,
        residual_m=proto.residual_m,
        center=vector_from_proto(proto.center) if is_round else None,
        axis=vector_from_proto(proto.axis) if proto.HasField("axis") else None,
        radius_m=proto.radius_m if is_round else None,
        length_m=proto.length_m if is_round else None,
        radii_m=np.array(proto.radii_m),
        hollow=proto.hollow,
    )


def _cloud(proto: geometry_pb2.PointCloud) -> PointCloud:
    return PointCloud(
        positions=np.array(proto.positions, dtype=np.float32).reshape(-1, 3),
        colors=array_of(proto.colors, np.uint8, -1, 3),
    )
