"""Finds unknown objects in RGB-D frames: client of fovea-server.

    import fovea

    with fovea.Client("127.0.0.1:50051") as client:
        found = client.detect(color, depth, fovea.CameraIntrinsics(525, 525, 319.5, 239.5))
    for each in found.objects:
        print(each.label, each.oriented_box.pose[:3, 3], each.mask.sum())

Positions are in metres in the camera's optical frame: x right, y down, z forward.
"""

from fovea.client import Client
from fovea.detections import (
    Detections,
    Diagnostics,
    FreePlace,
    Gravity,
    RejectedObject,
    RemovedSeed,
    Seed,
    SupportSurface,
    Trace,
)
from fovea.errors import (
    Cancelled,
    DeadlineExceeded,
    FoveaError,
    InvalidArgument,
    MissingPackage,
    Overloaded,
    ResourceExhausted,
    Unauthenticated,
    Unavailable,
    VersionMismatch,
)
from fovea.files import read_frame
from fovea.frame import CameraIntrinsics, Frame, LensDistortion
from fovea.grippers import Gripper
from fovea.objects import (
    BoundingBox2D,
    BoxUncertainty,
    ColorPart,
    Grasp,
    NoGrasp,
    Object,
    OrientedBox,
    PointCloud,
    Shape,
)
from fovea.options import DetectOptions, RetryOptions, TlsOptions
from fovea.picks import Pick
from fovea.planning import CollisionPrimitive, HeightMap
from fovea.server_info import Option, ServerInfo, StageStatistics, Statistics
from fovea.stream import StreamAnswer
from fovea.tracking import CameraMotion, HiddenTrack
from fovea.version import __version__

__all__ = [
    "BoundingBox2D",
    "BoxUncertainty",
    "CameraIntrinsics",
    "CameraMotion",
    "Cancelled",
    "Client",
    "CollisionPrimitive",
    "ColorPart",
    "DeadlineExceeded",
    "DetectOptions",
    "Detections",
    "Diagnostics",
    "FoveaError",
    "Frame",
    "FreePlace",
    "Grasp",
    "Gravity",
    "Gripper",
    "HeightMap",
    "HiddenTrack",
    "InvalidArgument",
    "LensDistortion",
    "MissingPackage",
    "NoGrasp",
    "Object",
    "Option",
    "OrientedBox",
    "Overloaded",
    "Pick",
    "PointCloud",
    "RejectedObject",
    "RemovedSeed",
    "ResourceExhausted",
    "RetryOptions",
    "Seed",
    "ServerInfo",
    "Shape",
    "StageStatistics",
    "Statistics",
    "StreamAnswer",
    "SupportSurface",
    "TlsOptions",
    "Trace",
    "Unauthenticated",
    "Unavailable",
    "VersionMismatch",
    "__version__",
    "read_frame",
]
