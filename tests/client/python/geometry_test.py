"""Conversions by hand-worked examples and round trips."""

from __future__ import annotations

import numpy as np
import pytest

from fovea.frame import LensDistortion
from fovea.geometry import pose_from_proto, pose_to_proto
from fovea.masks import decode_mask
from fovea.server_info import require_same_version
from fovea.errors import VersionMismatch
from fovea.v1 import detection_pb2, geometry_pb2


def mask_of(runs: list[int], x: int, y: int, width: int, height: int) -> detection_pb2.Mask:
    bounds = geometry_pb2.BoundingBox2D(x=x, y=y, width=width, height=height)
    return detection_pb2.Mask(bounds=bounds, runs=runs)


def test_masks_begin_with_background() -> None:
    mask = decode_mask(mask_of([1, 3, 1, 1], x=1, y=0, width=3, height=2), height=3, width=4)
    assert mask.dtype == bool
    assert mask.astype(int).tolist() == [[0, 0, 1, 1], [0, 1, 0, 1], [0, 0, 0, 0]]


def test_the_first_run_of_a_mask_may_be_empty() -> None:
    assert decode_mask(mask_of([0, 2], 0, 0, 2, 1), 1, 2).tolist() == [[True, True]]
    assert not decode_mask(mask_of([], 0, 0, 0, 0), 2, 2).any()


def test_masks_that_contradict_themselves_are_refused() -> None:
    with pytest.raises(ValueError, match="cover 5 pixels, not 6"):
        decode_mask(mask_of([2, 3], 0, 0, 3, 2), 2, 3)
    with pytest.raises(ValueError, match="beyond the image"):
        decode_mask(mask_of([6], 1, 0, 3, 2), 2, 3)


def test_a_quarter_turn_about_z() -> None:
    half = np.sqrt(0.5)
    proto = geometry_pb2.Pose(
        position=geometry_pb2.Vector3(x=1, y=2, z=3),
        orientation=geometry_pb2.Quaternion(z=half, w=half),
    )
    expected = [[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]
    assert np.allclose(pose_from_proto(proto), expected)


def test_poses_survive_both_ways() -> None:
    seed = np.random.SeedSequence().entropy
    random = np.random.default_rng(seed)
    # Half turns, of which naive formulas divide by zero, and random ones.
    rotations = [np.diag(d) for d in ([1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1])]
    for _ in range(100):
        rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
        rotations.append(rotation * np.sign(np.linalg.det(rotation)))
    for rotation in rotations:
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = rotation, random.normal(size=3)
        proto = pose_to_proto(pose, "pose")
        q = proto.orientation
        assert np.isclose(np.linalg.norm([q.x, q.y, q.z, q.w]), 1)
        assert np.allclose(pose_from_proto(proto), pose), f"seed {seed}"


def test_versions_match_as_in_semantic_versioning() -> None:
    for server, client in [("0.1.0", "0.1.7"), ("1.2.0", "1.9.3")]:
        require_same_version(server, client)
    for server, client in [("0.2.0", "0.1.0"), ("1.0.0", "2.0.0"), ("1.0.0", "0.1.0")]:
        with pytest.raises(VersionMismatch, match=f"{server}, this library is {client}"):
            require_same_version(server, client)


@pytest.mark.parametrize("shape", [(5,), (1, 5), (5, 1)])
def test_takes_lens_coefficients_in_the_shapes_that_opencv_has(shape: tuple[int, ...]) -> None:
    coefficients = np.arange(5.0).reshape(shape)
    lens = LensDistortion("plumb_bob", coefficients)
    assert lens.to_proto().coefficients == [0, 1, 2, 3, 4]


@pytest.mark.parametrize("model", ["plumb_bob", "equidistant", ""])
def test_takes_lenses_without_coefficients(model: str) -> None:
    assert not LensDistortion(model, []).to_proto().coefficients
