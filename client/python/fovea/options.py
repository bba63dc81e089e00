"""How a client connects, and what it asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from fovea.errors import InvalidArgument
from fovea.v1 import detection_pb2


@dataclass(frozen=True)
class TlsOptions:
    """PEM texts, not paths."""

    # Whom to trust; empty = the authorities of this machine.
    root_certificates: bytes = b""
    # What the server asks for with mutual TLS; both or none.
    certificate_chain: bytes = b""
    private_key: bytes = field(default=b"", repr=False)


@dataclass(frozen=True)
class RetryOptions:
    """When a call is made again because its server was away, stopping or had too much to do."""

    max_attempts: int = 5  # 1 = never again
    # Seconds before the second attempt; doubles with each, up to the maximum. The real wait is
    # random between half of it and all of it, so that robots do not come back all at once.
    backoff: float = 0.05
    max_backoff: float = 2.0


@dataclass(frozen=True)
class Gripper:
    """A gripper that grasps are planned for: two fingers, or a suction cup if it has a diameter."""

    name: str = ""  # comes back with its grasps
    max_opening_m: float = 0.085
    finger_length_m: float = 0.04
    finger_width_m: float = 0.02
    finger_thickness_m: float = 0.01
    suction_diameter_m: float = 0  # 0: fingers
    # How far the approach may be from straight down, radians; None: 0.35, with suction 0.8.
    max_tilt_rad: float | None = None
    max_grasps: int = 5  # for each object
    # What is less likely to succeed is not returned; None: 0.5. Less, if failing costs little.
    min_probability: float | None = None

    def to_proto(self) -> detection_pb2.Gripper:
        proto = detection_pb2.Gripper(name=self.name, max_grasps=self.max_grasps)
        if self.suction_diameter_m:
            proto.suction.diameter_m = self.suction_diameter_m
        else:
            proto.jaw.max_opening_m = self.max_opening_m
            proto.jaw.finger_length_m = self.finger_length_m
            proto.jaw.finger_width_m = self.finger_width_m
            proto.jaw.finger_thickness_m = self.finger_thickness_m
        if self.max_tilt_rad is not None:
            proto.max_tilt_rad = self.max_tilt_rad
        if self.min_probability is not None:
            proto.min_probability = self.min_probability
        return proto


@dataclass(frozen=True)
class DetectOptions:
    """What is computed and what comes back beside the objects' attributes."""

    # "default" or "paper"; empty means "default".
    profile: str = ""
    # Changes to the profile by option name, for example {"mrf.gamma_per_m2": 80}; docs/options.md
    # has all names, units and ranges.
    parameters: Mapping[str, float] = field(default_factory=dict)
    return_masks: bool = True
    return_clouds: bool = False
    return_saliency_maps: bool = False
    return_seeds: bool = False
    # Detections.trace and the saliency maps: what each step made of the frame.
    return_trace: bool = False
    # Detections.rejected: what was considered and is not reported, and why.
    return_rejected: bool = False
    # Seconds that the detection may take: what is most salient is looked at first, and
    # Detections.incomplete tells if that was not all. 0: as long as it takes. Not with
    # return_trace.
    time_budget: float = 0
    # Only in streams: objects keep a track_id from frame to frame.
    tracking: bool = False
    # The robot's grippers; None: those that the server's operator has set for this robot, else one
    # with two fingers that opens 0.085 m; (): no grasps, sooner.
    grippers: Sequence[Gripper] | None = None
    # Length, width and height in metres of what free places are looked for; None: none are.
    place_size: tuple[float, float, float] | None = None
    # Object.collision and Detections.support_collisions.
    collision_primitives: bool = False
    # Metres: Detections.height_map in cells of this size; None: none.
    height_map_cell_m: float | None = None

    def to_proto(self) -> detection_pb2.DetectOptions:
        """Raises InvalidArgument for a parameter that is no number, or a budget out of range."""
        proto = detection_pb2.DetectOptions(
            profile=self.profile,
            return_masks=self.return_masks,
            return_clouds=self.return_clouds,
            return_saliency_maps=self.return_saliency_maps,
            return_seeds=self.return_seeds,
            return_trace=self.return_trace,
            return_rejected=self.return_rejected,
        )
        if self.grippers is not None:
            proto.grasps.none = not self.grippers
            proto.grasps.grippers.extend(each.to_proto() for each in self.grippers)
        if self.place_size is not None:
            size = proto.places.size
            size.x, size.y, size.z = self.place_size
        proto.planning.collision_primitives = self.collision_primitives
        if self.height_map_cell_m is not None:
            proto.planning.height_map.cell_m = self.height_map_cell_m
        if self.tracking:
            proto.tracking.enabled = True
        if self.time_budget:
            if not 0 < self.time_budget < 3600:
                raise InvalidArgument(
                    "options.time_budget",
                    f"{self.time_budget!r} s is not from 0 (none) to less than an hour",
                )
            proto.time_budget.FromNanoseconds(round(self.time_budget * 1e9))
        for name, value in self.parameters.items():
            try:
                proto.parameters[name] = float(value)
            except (TypeError, ValueError):
                raise InvalidArgument(
                    f"options.parameters[{name}]", f"{value!r} is not a number"
                ) from None
        return proto
