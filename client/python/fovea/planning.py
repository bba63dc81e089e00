"""What motion planners need. Camera frame, in metres."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from fovea.arrays import array_of
from fovea.enums import name_of
from fovea.geometry import FloatArray, pose_from_proto, vector_from_proto
from fovea.v1 import detection_pb2


@dataclass(frozen=True, eq=False)
class CollisionPrimitive:
    """A solid that collision checkers know."""

    kind: str  # "box", "cylinder" or "sphere"
    pose: FloatArray  # 4x4, of its middle; the axis of a cylinder is z
    # Full extents along its axes: of cylinders x = y = the diameter, of spheres all three.
    size: FloatArray


@dataclass(frozen=True, eq=False)
class HeightMap:
    """How high what was seen reaches, on a level grid."""

    # 4x4: x along a row of cells, y from row to row, z up; the origin is the middle of cell [0, 0]
    # at height 0, which is in the support surface where there is one.
    pose: FloatArray
    cell_m: float
    heights_m: npt.NDArray[np.float32]  # rows x columns; NaN = unknown

    def points(self) -> FloatArray:
        """Nx3, camera frame: the known cells, their middles at their heights."""
        rows, columns = np.nonzero(~np.isnan(self.heights_m))
        heights = self.heights_m[rows, columns]
        level = np.column_stack([columns * self.cell_m, rows * self.cell_m, heights])
        return np.asarray(level @ self.pose[:3, :3].T + self.pose[:3, 3])


def primitive_from_proto(proto: detection_pb2.CollisionPrimitive) -> CollisionPrimitive:
    return CollisionPrimitive(
        kind=name_of(detection_pb2.CollisionKind, proto.kind),
        pose=pose_from_proto(proto.pose),
        size=vector_from_proto(proto.size),
    )


def height_map_from_proto(proto: detection_pb2.HeightMap) -> HeightMap:
    return HeightMap(
        pose=pose_from_proto(proto.pose),
        cell_m=proto.cell_m,
        heights_m=array_of(proto.data, "<f4", proto.height, proto.width),
    )
