"""Positions, directions and poses: messages of the contract to and from numpy.

All in metres. A pose is a 4x4 matrix that takes homogeneous coordinates of the thing posed to its
parent frame: p_parent = pose @ p.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from fovea.errors import InvalidArgument
from fovea.v1 import geometry_pb2

FloatArray = npt.NDArray[np.float64]


def vector_from_proto(proto: geometry_pb2.Vector3) -> FloatArray:
    return np.array([proto.x, proto.y, proto.z])


def vector_to_proto(vector: Any, field: str) -> geometry_pb2.Vector3:
    x, y, z = numbers(vector, (3,), field)
    return geometry_pb2.Vector3(x=x, y=y, z=z)


def pose_from_proto(proto: geometry_pb2.Pose) -> FloatArray:
    q = proto.orientation
    x, y, z, w = q.x, q.y, q.z, q.w
    pose = np.eye(4)
    pose[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    pose[:3, 3] = vector_from_proto(proto.position)
    return pose


def pose_to_proto(pose: Any, field: str) -> geometry_pb2.Pose:
    matrix = numbers(pose, (4, 4), field)
    _require_rigid(matrix, field)
    x, y, z, w = _quaternion_of(matrix[:3, :3])
    return geometry_pb2.Pose(
        position=vector_to_proto(matrix[:3, 3], field),
        orientation=geometry_pb2.Quaternion(x=x, y=y, z=z, w=w),
    )


def numbers(value: Any, shape: tuple[int, ...], field: str) -> FloatArray:
    array = _numbers(value, field)
    if array.shape != shape:
        raise InvalidArgument(field, f"has the shape {array.shape}, not {shape}")
    return array


def row_of_numbers(value: Any, field: str) -> FloatArray:
    """However many, in one row or one column."""
    array = _numbers(value, field)
    if array.ndim == 0:
        raise InvalidArgument(field, f"{value!r} is not several numbers")
    if array.size != max(array.shape):
        raise InvalidArgument(field, f"has the shape {array.shape}, not that of one row")
    return array.ravel()


def _numbers(value: Any, field: str) -> FloatArray:
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InvalidArgument(field, "is not made of numbers") from None
    except OverflowError:
        raise InvalidArgument(field, "has an integer beyond what a float holds") from None


def _require_rigid(matrix: FloatArray, field: str) -> None:
    rotation = matrix[:3, :3]
    is_rigid = (
        np.isfinite(matrix).all()
        and np.allclose(rotation @ rotation.T, np.eye(3), atol=1e-3)
        and np.linalg.det(rotation) > 0
        and np.allclose(matrix[3], [0, 0, 0, 1])
    )
    if not is_rigid:
        raise InvalidArgument(field, "is not a rotation and a translation with last row 0 0 0 1")


def _quaternion_of(rotation: FloatArray) -> FloatArray:
    """x, y, z, w of unit length.

    It is the eigenvector of the largest eigenvalue of this symmetric matrix (Bar-Itzhack 2000),
    which holds for every angle and averages out rounding.
    """
    r = rotation
    k = np.array(
        [
            [r[0, 0] - r[1, 1] - r[2, 2], 0, 0, 0],
            [r[1, 0] + r[0, 1], r[1, 1] - r[0, 0] - r[2, 2], 0, 0],
            [r[2, 0] + r[0, 2], r[2, 1] + r[1, 2], r[2, 2] - r[0, 0] - r[1, 1], 0],
            [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], np.trace(r)],
        ]
    )
    return np.asarray(np.linalg.eigh(k)[1][:, 3])  # eigh reads the lower triangle
