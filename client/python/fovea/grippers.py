"""Grippers that grasps are planned for."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from fovea.checks import positive, real, text, whole
from fovea.errors import InvalidArgument
from fovea.geometry import vector_to_proto
from fovea.v1 import detection_pb2, geometry_pb2

_GRIPPERS = "options.grasps.grippers"
_JAW = ("max_opening_m", "finger_length_m", "finger_width_m", "finger_thickness_m", "friction")
_OF_FINGERS = (*_JAW, "palm_size_m")
# Here and in the contract.
_SUCTION = {"suction_diameter_m": "diameter_m", "max_curvature_per_m": "max_curvature_per_m"}


@dataclass(frozen=True)
class Gripper:
    """A gripper that grasps are planned for: two fingers, or a suction cup if it has a diameter.

    None stands for the values given here. Those of an answer have every length of their kind, and
    None for what the other kind has.

    name: comes back with its grasps.
    max_opening_m: 0.085; finger_length_m: 0.04; finger_width_m: 0.02; finger_thickness_m: 0.01.
    suction_diameter_m: None: fingers.
    max_tilt_rad: how far a grasp's approach may be from the one preferred; 0.35, with suction 0.8.
    max_grasps: for each object.
    min_probability: what is less likely to succeed is not returned; 0.5. Less, if failing costs
        little.
    palm_size_m: of the box behind the fingers, along x, y and z of the hand. 0 along x: as wide as
        the fingers at their widest; along y and z: 0.04. None is all of that.
    friction: coefficient between fingers and object; 0.5.
    max_curvature_per_m: of what the cup still seals on; 12.
    approach: the way to move in that is preferred: a unit vector in the camera frame; along gravity.
    """

    name: str = ""
    max_opening_m: float | None = None
    finger_length_m: float | None = None
    finger_width_m: float | None = None
    finger_thickness_m: float | None = None
    suction_diameter_m: float | None = None
    max_tilt_rad: float | None = None
    max_grasps: int = 5
    min_probability: float | None = None
    palm_size_m: tuple[float, float, float] | None = None
    friction: float | None = None
    max_curvature_per_m: float | None = None
    approach: tuple[float, float, float] | None = None

    def to_proto(self, field: str = f"{_GRIPPERS}[0]") -> detection_pb2.Gripper:
        """Raises InvalidArgument that names what is wrong below `field`."""
        name = text(self.name, f"{field}.name")
        max_grasps = whole(self.max_grasps, f"{field}.max_grasps")
        proto = detection_pb2.Gripper(name=name, max_grasps=max_grasps)
        self._add_hand(proto, field)
        if self.approach is not None:
            proto.approach.CopyFrom(vector_to_proto(self.approach, f"{field}.approach"))
        if self.max_tilt_rad is not None:
            proto.max_tilt_rad = real(self.max_tilt_rad, f"{field}.max_tilt_rad")
        if self.min_probability is not None:
            proto.min_probability = real(self.min_probability, f"{field}.min_probability")
        return proto

    def _add_hand(self, proto: detection_pb2.Gripper, field: str) -> None:
        fingers = [name for name in _OF_FINGERS if getattr(self, name) is not None]
        cup = [name for name in _SUCTION if getattr(self, name) is not None]
        if fingers and cup:
            raise InvalidArgument(
                field, f"has {fingers[0]} of two fingers and {cup[0]} of a suction cup; give one"
            )
        if cup:
            self._add_cup(proto.suction, f"{field}.suction")
        else:
            self._add_fingers(proto.jaw, f"{field}.jaw")

    def _add_cup(self, proto: detection_pb2.SuctionGripper, field: str) -> None:
        if self.suction_diameter_m is None:
            raise InvalidArgument(f"{field}.diameter_m", "suction_diameter_m is missing")
        for name, theirs in _SUCTION.items():
            if (value := getattr(self, name)) is not None:
                setattr(proto, theirs, positive(value, f"{field}.{theirs}", name))

    def _add_fingers(self, proto: detection_pb2.JawGripper, field: str) -> None:
        proto.SetInParent()  # all may have the values given
        for name in _JAW:
            if (value := getattr(self, name)) is not None:
                setattr(proto, name, positive(value, f"{field}.{name}", name))
        if self.palm_size_m is not None:
            proto.palm_size.CopyFrom(vector_to_proto(self.palm_size_m, f"{field}.palm_size"))


def grippers_to_proto(grippers: Iterable[Gripper] | Gripper) -> list[detection_pb2.Gripper]:
    if isinstance(grippers, Gripper):
        grippers = [grippers]
    if isinstance(grippers, (str, bytes)) or not isinstance(grippers, Iterable):
        kind = type(grippers).__name__
        raise InvalidArgument(_GRIPPERS, f"is {kind}, not a fovea.Gripper or several of them")
    protos = []
    for index, each in enumerate(grippers):
        field = f"{_GRIPPERS}[{index}]"
        if not isinstance(each, Gripper):
            raise InvalidArgument(field, f"is {type(each).__name__}, not a fovea.Gripper")
        protos.append(each.to_proto(field))
    return protos


def gripper_from_proto(proto: detection_pb2.Gripper) -> Gripper:
    if proto.HasField("suction"):
        hand: dict[str, Any] = {
            name: _short(getattr(proto.suction, theirs)) for name, theirs in _SUCTION.items()
        }
    else:
        hand = {name: _short(getattr(proto.jaw, name)) for name in _JAW}
        hand["palm_size_m"] = _tuple_of(proto.jaw.palm_size)
    has_tilt, has_least = proto.HasField("max_tilt_rad"), proto.HasField("min_probability")
    return Gripper(
        name=proto.name,
        # Of 32 bits pi / 2 is more than that, which the server would refuse.
        max_tilt_rad=min(_short(proto.max_tilt_rad), math.pi / 2) if has_tilt else None,
        max_grasps=proto.max_grasps,
        min_probability=_short(proto.min_probability) if has_least else None,
        approach=_tuple_of(proto.approach) if proto.HasField("approach") else None,
        **hand,
    )


def _short(value: float) -> float:
    """The server keeps 32 bits: 0.14 for 0.14000000059604645, which is the same there."""
    return float(str(np.float32(value)))


def _tuple_of(vector: geometry_pb2.Vector3) -> tuple[float, float, float]:
    return _short(vector.x), _short(vector.y), _short(vector.z)
