"""A frame of an RGB-D camera, as it is sent."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
from google.protobuf.timestamp_pb2 import Timestamp

from fovea.checks import real, shown, text
from fovea.errors import InvalidArgument
from fovea.geometry import numbers, pose_to_proto, row_of_numbers, vector_to_proto
from fovea.images import make_color_image, make_depth_image
from fovea.v1 import frame_pb2

_INTRINSICS = "frame.intrinsics"
_DEPTH_INTRINSICS = "frame.depth_intrinsics"
_FIRST_SECOND, _LAST_SECOND = -62_135_596_800, 253_402_300_799  # that a Timestamp may hold


_MODELS = {
    "plumb_bob": frame_pb2.DISTORTION_MODEL_BROWN_CONRADY,
    "rational_polynomial": frame_pb2.DISTORTION_MODEL_BROWN_CONRADY,
    "equidistant": frame_pb2.DISTORTION_MODEL_KANNALA_BRANDT,
}


@dataclass(frozen=True)
class LensDistortion:
    """How a lens bends rays, by the names and numbers of ROS's camera_info, in OpenCV's order.

    model: "plumb_bob" (k1, k2, p1, p2, k3), "rational_polynomial" (and k4, k5, k6) or "equidistant"
        (k1 to k4 of a fisheye). Without coefficients nothing is distorted, and it may be empty.
    """

    model: str
    coefficients: npt.ArrayLike  # also of the shape 1xN or Nx1, as OpenCV has them

    def to_proto(self, field: str = _INTRINSICS) -> frame_pb2.LensDistortion:
        model = text(self.model, f"{field}.distortion.model")
        values = row_of_numbers(self.coefficients, f"{field}.distortion.coefficients")
        if not model and values.size == 0:  # a camera_info that says nothing
            return frame_pb2.LensDistortion()
        if model not in _MODELS:
            known = ", ".join(_MODELS)
            raise InvalidArgument(f"{field}.distortion.model", f"{model!r} is not one of {known}")
        return frame_pb2.LensDistortion(model=_MODELS[model], coefficients=values.tolist())


@dataclass(frozen=True)
class CameraIntrinsics:
    """Pinhole model, in pixels of the camera's image, and what its lens does to it.

    The centre of the top left pixel is (0, 0). Without `distortion`, images are rectified. With it,
    the server undistorts them and answers in the pixels that were sent.
    """

    fx: float
    fy: float
    cx: float
    cy: float
    distortion: LensDistortion | None = None

    @staticmethod
    def from_matrix(matrix: npt.ArrayLike, field: str = _INTRINSICS) -> CameraIntrinsics:
        """From [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]. Errors name `field`."""
        k = numbers(matrix, (3, 3), field)
        if not np.array_equal(k[[0, 1, 2, 2, 2], [1, 0, 0, 1, 2]], [0, 0, 0, 0, 1]):
            raise InvalidArgument(field, "is not [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]")
        return CameraIntrinsics(k[0, 0], k[1, 1], k[0, 2], k[1, 2])

    def to_proto(self, field: str = _INTRINSICS) -> frame_pb2.CameraIntrinsics:
        for name in ("fx", "fy", "cx", "cy"):
            real(getattr(self, name), f"{field}.{name}")
        proto = frame_pb2.CameraIntrinsics(fx=self.fx, fy=self.fy, cx=self.cx, cy=self.cy)
        if self.distortion is not None:
            if not isinstance(self.distortion, LensDistortion):
                kind = type(self.distortion).__name__
                raise InvalidArgument(f"{field}.distortion", f"is {kind}, not fovea.LensDistortion")
            proto.distortion.CopyFrom(self.distortion.to_proto(field))
        return proto


@dataclass(frozen=True, eq=False)
class Frame:
    """Colour and depth, registered: pixel (u, v) of both looks along the same ray, and both have
    one size; or with depth_intrinsics and color_from_depth, after which the server registers depth.
    Nothing is checked or copied before the frame is sent.

    color: HxWx3 uint8 in the order of color_encoding, or the bytes of a PNG or JPEG file.
    depth: HxW uint16 in units of depth_unit_m, 0 = not measured, or other integers that fit into
        it; or HxW float32 in metres, NaN or <= 0 = not measured; or the bytes of a 16-bit PNG file.
        Along the optical axis. What a masked array masks is not measured.
    depth_unit_m: metres, of integers and PNG files; None: 0.001. Float depth is in metres and goes
        without it.
    intrinsics: of the colour camera; CameraIntrinsics or a 3x3 matrix.
    id: comes back with the answer, and stands in the ids of objects.
    captured_at_ns: when the camera took it, in nanoseconds since 1970 UTC as time.time_ns() says.
    gravity: unit vector that points down, in the camera frame (x right, y down, z forward).
        Estimated from the scene where absent.
    camera_pose: 4x4, of the camera in a frame of your choice. Objects then have their pose there,
        too, as pose_in_reference.
    color_encoding: "rgb8", "bgr8", "png" or "jpeg"; depth_encoding: "raw", "zstd" or "png". Of
        arrays; files are sent as they are.
    depth_intrinsics: of the depth camera, in pixels of depth, where depth is not registered.
    color_from_depth: with it, 4x4, the depth camera's pose in the colour camera's frame.
    """

    color: npt.NDArray[np.uint8] | bytes
    depth: npt.NDArray[np.uint16] | npt.NDArray[np.float32] | bytes
    intrinsics: CameraIntrinsics | npt.ArrayLike
    id: str = ""
    captured_at_ns: int | None = None
    gravity: npt.ArrayLike | None = None
    camera_pose: npt.ArrayLike | None = None
    depth_unit_m: float | None = None
    color_encoding: str = "rgb8"
    depth_encoding: str = "raw"
    depth_intrinsics: CameraIntrinsics | npt.ArrayLike | None = None
    color_from_depth: npt.ArrayLike | None = None

    def to_proto(self) -> frame_pb2.Frame:
        """Raises InvalidArgument that names the field."""
        proto = frame_pb2.Frame(
            id=text(self.id, "frame.id"),
            intrinsics=_intrinsics_to_proto(self.intrinsics, _INTRINSICS),
            color=make_color_image(self.color, self.color_encoding),
            depth=make_depth_image(self.depth, self.depth_encoding, self.depth_unit_m),
        )
        self._add_depth_camera(proto)
        if self.captured_at_ns is not None:
            proto.captured_at.CopyFrom(_time_to_proto(self.captured_at_ns))
        if self.gravity is not None:
            proto.gravity.CopyFrom(vector_to_proto(self.gravity, "frame.gravity"))
        if self.camera_pose is not None:
            proto.camera_pose.CopyFrom(pose_to_proto(self.camera_pose, "frame.camera_pose"))
        return proto

    def _add_depth_camera(self, proto: frame_pb2.Frame) -> None:
        if self.depth_intrinsics is None and self.color_from_depth is None:
            _require_same_size(self.color, self.depth)
            return
        together = "is missing; depth_intrinsics and color_from_depth go together"
        if self.depth_intrinsics is None:
            raise InvalidArgument("frame.depth_intrinsics", together)
        if self.color_from_depth is None:
            raise InvalidArgument("frame.color_from_depth", together)
        intrinsics = _intrinsics_to_proto(self.depth_intrinsics, _DEPTH_INTRINSICS)
        proto.depth_intrinsics.CopyFrom(intrinsics)
        pose = pose_to_proto(self.color_from_depth, "frame.color_from_depth")
        proto.color_from_depth.CopyFrom(pose)


def _time_to_proto(captured_at_ns: Any) -> Timestamp:
    field = "frame.captured_at"
    if not isinstance(captured_at_ns, (int, np.integer)):
        problem = f"captured_at_ns={shown(captured_at_ns)} is not a whole number of nanoseconds"
        raise InvalidArgument(field, problem)
    seconds, nanos = divmod(int(captured_at_ns), 1_000_000_000)
    if not _FIRST_SECOND <= seconds <= _LAST_SECOND:
        problem = f"captured_at_ns={shown(captured_at_ns)} is not in the years 1 to 9999"
        raise InvalidArgument(field, problem)
    return Timestamp(seconds=seconds, nanos=nanos)


def _intrinsics_to_proto(
    intrinsics: CameraIntrinsics | npt.ArrayLike, field: str
) -> frame_pb2.CameraIntrinsics:
    if not isinstance(intrinsics, CameraIntrinsics):
        if _are_four_numbers(intrinsics):
            problem = "is four numbers; fovea.CameraIntrinsics(fx, fy, cx, cy) takes them"
            raise InvalidArgument(field, problem)
        intrinsics = CameraIntrinsics.from_matrix(intrinsics, field)
    return intrinsics.to_proto(field)


def _are_four_numbers(value: Any) -> bool:
    if isinstance(value, np.ndarray):
        return value.shape == (4,)
    is_row = isinstance(value, (tuple, list)) and len(value) == 4
    return is_row and all(isinstance(each, (int, float, np.number)) for each in value)


def _require_same_size(color: Any, depth: Any) -> None:
    """The sizes of files the server checks."""
    if isinstance(color, np.ndarray) and isinstance(depth, np.ndarray):
        if color.shape[:2] != depth.shape:
            raise InvalidArgument(
                "frame.depth",
                f"is {depth.shape[1]}x{depth.shape[0]}, colour is "
                f"{color.shape[1]}x{color.shape[0]}; depth must be registered to colour, or "
                "else depth_intrinsics and color_from_depth are needed",
            )
