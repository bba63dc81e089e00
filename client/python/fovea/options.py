"""How a client connects, and what it asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from fovea.checks import flag, positive, real, shown, text, whole
from fovea.errors import InvalidArgument
from fovea.geometry import numbers
from fovea.grippers import Gripper, grippers_to_proto
from fovea.v1 import detection_pb2, geometry_pb2

# Here and in the contract.
_RETURNED = (
    "return_masks",
    "return_clouds",
    "return_saliency_maps",
    "return_seeds",
    "return_trace",
    "return_rejected",
)


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

    # 1 = never again. With these waits five pass within 0.4 to 0.8 s where connections are refused;
    # a call that is to outlast a restart needs more of them, and a timeout as long. Where a server
    # with too much to do says when to come back, a call goes on until its timeout (unless this is 1).
    max_attempts: int = 5
    # Seconds before the second attempt; doubles with each, up to the maximum. The real wait is
    # random between half of it and all of it, so that robots do not come back all at once.
    backoff: float = 0.05
    max_backoff: float = 2.0


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
    # Only in Client.stream: objects keep a track_id from frame to frame.
    tracking: bool = False
    # The tracks start anew with the first frame whose number here is another one than before.
    tracking_reset: int = 0
    # The robot's grippers, one or several; None: those that the server's operator has set for this
    # robot, else one with two fingers that opens 0.085 m; (): no grasps, sooner.
    grippers: Sequence[Gripper] | Gripper | None = None
    # Length, width and height in metres of what free places are looked for; None: none are.
    place_size: tuple[float, float, float] | None = None
    # Metres kept free around it, and to edges and to what is unseen, up to 1; None: 0.02.
    place_margin_m: float | None = None
    max_places: int = 5  # up to 100
    # Object.collision and Detections.support_collisions.
    collision_primitives: bool = False
    # Metres: Detections.height_map in cells of this size; None: none.
    height_map_cell_m: float | None = None
    # At most, up to 1048576: what is nearest to the camera, where that is not all.
    height_map_max_cells: int = 65536

    def to_proto(self) -> detection_pb2.DetectOptions:
        """Raises InvalidArgument that names the field."""
        proto = detection_pb2.DetectOptions(profile=text(self.profile, "options.profile"))
        for name in _RETURNED:
            setattr(proto, name, flag(getattr(self, name), f"options.{name}"))
        if self.grippers is not None:
            proto.grasps.grippers.extend(grippers_to_proto(self.grippers))
            proto.grasps.none = not proto.grasps.grippers
        if self.place_size is not None:
            proto.places.CopyFrom(self._places_to_proto())
        proto.planning.collision_primitives = flag(
            self.collision_primitives, "options.planning.collision_primitives"
        )
        if self.height_map_cell_m is not None:
            proto.planning.height_map.cell_m = positive(
                self.height_map_cell_m, "options.planning.height_map.cell_m", "height_map_cell_m"
            )
            proto.planning.height_map.max_cells = whole(
                self.height_map_max_cells, "options.planning.height_map.max_cells"
            )
        if flag(self.tracking, "options.tracking.enabled"):
            proto.tracking.enabled = True
            proto.tracking.reset = whole(self.tracking_reset, "options.tracking.reset", least=0)
        if self.time_budget:
            if not 0 < real(self.time_budget, "options.time_budget") <= 3600:
                raise InvalidArgument(
                    "options.time_budget",
                    f"{shown(self.time_budget)} s is not from 0 (none) to an hour",
                )
            # Nothing on the wire stands for no limit.
            proto.time_budget.FromNanoseconds(max(1, round(self.time_budget * 1e9)))
        self._add_parameters(proto)
        return proto

    def _places_to_proto(self) -> detection_pb2.PlaceOptions:
        proto = detection_pb2.PlaceOptions(
            size=_place_size_to_proto(self.place_size),
            max_places=whole(self.max_places, "options.places.max_places"),
        )
        if self.place_margin_m is not None:
            proto.margin_m = real(self.place_margin_m, "options.places.margin_m")
        return proto

    def _add_parameters(self, proto: detection_pb2.DetectOptions) -> None:
        if not isinstance(self.parameters, Mapping):
            raise InvalidArgument(
                "options.parameters", f"is {type(self.parameters).__name__}, not a dict"
            )
        for name, value in self.parameters.items():
            field = f"options.parameters[{text(name, 'options.parameters')}]"
            try:
                proto.parameters[name] = float(value)
            except (TypeError, ValueError):
                raise InvalidArgument(field, f"{value!r} is not a number") from None
            except OverflowError:
                raise InvalidArgument(field, f"{shown(value)} is beyond any float") from None


def options_to_proto(options: Any) -> detection_pb2.DetectOptions:
    if not isinstance(options, DetectOptions):
        kind = type(options).__name__
        raise InvalidArgument("options", f"is {kind}, not fovea.DetectOptions")
    return options.to_proto()


def _place_size_to_proto(place_size: Any) -> geometry_pb2.Vector3:
    field = "options.places.size"
    try:
        size = numbers(place_size, (3,), field)
    except InvalidArgument as error:
        problem = error.message.removeprefix(f"{field}: ")
        raise InvalidArgument(field, f"place_size {problem}: length, width and height") from None
    for each in size:
        positive(each, field, "place_size")
    return geometry_pb2.Vector3(x=size[0], y=size[1], z=size[2])
