"""What a server is, and what it has done."""

from __future__ import annotations

from dataclasses import dataclass

from fovea.errors import VersionMismatch
from fovea.v1 import detection_service_pb2
from fovea.version import __version__


@dataclass(frozen=True)
class ServerInfo:
    version: str
    started_at_ns: int  # nanoseconds since 1970 UTC
    profiles: list[str]  # of the method, the default one first
    max_message_bytes: int  # largest request
    max_pixels: int  # largest image
    # Frames that are computed at once, that wait beyond those, and that one robot may have of both.
    compute_threads: int
    max_waiting: int
    max_per_robot: int
    build: str  # the commit that it was built from, or "unknown"


@dataclass(frozen=True)
class Option:
    """One option of the method, for DetectOptions.parameters."""

    name: str
    unit: str  # "m", "m2", "1/m", "1/m2", "deg", "px" or ""
    minimum: float
    maximum: float
    integral: bool  # whole numbers only; switches are 0 or 1
    defaults: dict[str, float]  # by profile
    description: str
    fixed: bool = False  # by the server's operator: requests that set it are refused


@dataclass(frozen=True)
class StageStatistics:
    count: int
    total_ms: float


@dataclass(frozen=True)
class Statistics:
    """Since the server started, over all robots."""

    uptime_ms: float
    frames_received: int
    frames_answered: dict[str, int]  # by the name of the status code, for example "OK"
    frames_dropped: int  # of streams, that a newer one took the place of
    frames_waiting: int
    objects: int
    streams: int
    received_bytes: int
    sent_bytes: int
    stages: dict[str, StageStatistics]  # "queue" and "decode" included


def server_info_from_proto(proto: detection_service_pb2.GetServerInfoResponse) -> ServerInfo:
    return ServerInfo(
        version=proto.version,
        started_at_ns=proto.started_at.ToNanoseconds(),
        profiles=list(proto.profiles),
        max_message_bytes=proto.max_message_bytes,
        max_pixels=proto.max_pixels,
        compute_threads=proto.compute_threads,
        max_waiting=proto.max_waiting,
        max_per_robot=proto.max_per_robot,
        build=proto.build,
    )


def options_from_proto(proto: detection_service_pb2.ListOptionsResponse) -> list[Option]:
    return [
        Option(
            name=each.name,
            unit=each.unit,
            minimum=each.minimum,
            maximum=each.maximum,
            integral=each.integral,
            defaults=dict(each.defaults),
            description=each.description,
            fixed=each.fixed,
        )
        for each in proto.options
    ]


def statistics_from_proto(proto: detection_service_pb2.GetStatisticsResponse) -> Statistics:
    return Statistics(
        uptime_ms=proto.uptime.ToNanoseconds() / 1e6,
        frames_received=proto.frames_received,
        frames_answered=dict(proto.frames_answered),
        frames_dropped=proto.frames_dropped,
        frames_waiting=proto.frames_waiting,
        objects=proto.objects,
        streams=proto.streams,
        received_bytes=proto.received_bytes,
        sent_bytes=proto.sent_bytes,
        stages={
            name: StageStatistics(stage.count, stage.total.ToNanoseconds() / 1e6)
            for name, stage in proto.stages.items()
        },
    )


def require_same_version(server: str, client: str = __version__) -> None:
    """As in semantic versioning: the first number, and before 1.0 the second one too, is the same.

    Raises VersionMismatch.
    """
    if _compatible_part(server) != _compatible_part(client):
        raise VersionMismatch(server, client)


def _compatible_part(version: str) -> list[str]:
    numbers = version.split(".")
    return numbers[:2] if numbers[0] == "0" else numbers[:1]
