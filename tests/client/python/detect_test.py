"""Answers: the same objects as the command line's, and what else they say."""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import fields, is_dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from comparison import EVERYTHING
from conftest import Scene
from PIL import Image
from server_process import ServerProcess

import fovea


def _arrays_in(value: object) -> list[np.ndarray]:
    if isinstance(value, np.ndarray):
        return [value]
    if is_dataclass(value):
        value = [getattr(value, each.name) for each in fields(value)]
    if isinstance(value, dict):
        value = list(value.values())
    return [array for each in value for array in _arrays_in(each)] if type(value) is list else []


def test_arrays_of_an_answer_may_be_written_to(client: fovea.Client, scene: Scene) -> None:
    options = replace(
        EVERYTHING,
        return_trace=True,
        collision_primitives=True,
        height_map_cell_m=0.02,
        place_size=(0.02, 0.02, 0.02),
    )
    found = client.detect_frame(scene.frame(), options)
    assert found.height_map and found.trace and found.saliency_maps and found.objects[0].cloud
    arrays = _arrays_in(found)
    assert len(arrays) > 20
    for array in arrays:
        array[...] = 0
    assert not found.height_map.heights_m.any()


def test_finds_the_objects_that_the_command_line_finds(
    client: fovea.Client, server: ServerProcess, scene: Scene, tmp_path: Path
) -> None:
    labels, answer = tmp_path / "labels.png", tmp_path / "answer.json"
    command = [os.environ["FOVEA_CLI"], "detect", "--server", server.address]
    command += ["--color", str(scene.color_file), "--depth", str(scene.depth_file)]
    command += ["--intrinsics", "262.5,262.5,159.5,119.5", "--id", "a"]
    subprocess.run([*command, "--labels", str(labels), "--json", str(answer)], check=True)
    expected = json.loads(answer.read_text())["objects"]

    found = client.detect(scene.color, scene.depth, scene.intrinsics, id="a")

    assert len(found.objects) >= 3
    assert np.array_equal(found.label_image(), np.array(Image.open(labels)))
    assert len(found.objects) == len(expected)
    for each, same in zip(found.objects, expected):
        assert each.id == same["id"]
        assert each.confidence == same["confidence"]
        assert each.num_pixels == same["num_pixels"] == each.mask.sum()
        assert list(each.centroid) == [same["centroid"][axis] for axis in "xyz"]
        position = same["oriented_box"]["pose"]["position"]
        assert list(each.oriented_box.pose[:3, 3]) == [position[axis] for axis in "xyz"]
        assert list(each.oriented_box.size) == [
            same["oriented_box"]["size"][axis] for axis in "xyz"
        ]


def test_boxes_bound_the_masks_and_the_clouds(client: fovea.Client, scene: Scene) -> None:
    # Flying pixels would get the depth of a surface beside them.
    options = replace(EVERYTHING, parameters={"flying_pixels.max_angle_deg": 90})
    found = client.detect_frame(scene.frame(), options)
    for each in found.objects:
        rows, columns = np.nonzero(each.mask)
        box = each.bounding_box
        assert (box.x, box.y) == (columns.min(), rows.min())
        assert (box.width, box.height) == (np.ptp(columns) + 1, np.ptp(rows) + 1)

        positions = each.cloud.positions
        assert positions.shape == (each.num_pixels, 3) == each.cloud.colors.shape
        assert np.array_equal(each.cloud.colors, scene.color[each.mask])
        depth_m = scene.depth[each.mask] * 0.001
        assert np.allclose(positions[:, 2], depth_m, atol=1e-6)
        assert np.allclose(positions[:, 0], (columns - 159.5) / 262.5 * depth_m, atol=1e-5)
        assert np.allclose(each.centroid, positions.mean(axis=0), atol=1e-5)
        box_from_camera = np.linalg.inv(each.visible_box.pose)
        in_box = positions @ box_from_camera[:3, :3].T + box_from_camera[:3, 3]
        # The box may leave out strays, but not more than a few of them.
        inside = (np.abs(in_box) <= each.visible_box.size / 2 + 1e-4).all(axis=1)
        assert inside.mean() > 0.8


def test_grasps_are_poses(client: fovea.Client, scene: Scene) -> None:
    found = client.detect_frame(scene.frame())
    grasps = [grasp for each in found.objects for grasp in each.grasps]
    assert grasps
    for grasp in grasps:
        rotation = grasp.pose[:3, :3]
        assert np.allclose(rotation @ rotation.T, np.eye(3))
        assert np.linalg.det(rotation) > 0
        assert np.allclose(rotation[:, 0], grasp.closing, atol=1e-6)
        assert np.allclose(rotation[:, 2], grasp.approach, atol=1e-6)
        assert np.array_equal(grasp.pose[:3, 3], grasp.tool_center_point)
        assert grasp.approach @ found.gravity.direction > 0.9  # from above


def test_only_what_was_asked_for_comes_back(client: fovea.Client, scene: Scene) -> None:
    little = client.detect_frame(scene.frame(), fovea.DetectOptions(return_masks=False))
    assert little.objects and not little.saliency_maps and not little.seeds
    assert all(each.mask is None and each.cloud is None for each in little.objects)
    assert all(each.pose_in_reference is None for each in little.objects)
    with pytest.raises(ValueError, match="return_masks"):
        little.label_image()

    much = client.detect_frame(scene.frame(), EVERYTHING)
    assert len(much.seeds) == much.diagnostics.num_seeds
    assert {seed.source for seed in much.seeds} <= {
        "color_saliency",
        "depth_saliency",
        "unexplained_region",
    }
    assert set(much.saliency_maps) == {"color", "depth"}
    for saliency in much.saliency_maps.values():
        assert saliency.shape == (240, 320)
        assert (saliency.min(), saliency.max()) == (0, 255)


def test_echoes_the_frame_and_takes_gravity_and_camera_pose(
    client: fovea.Client, scene: Scene
) -> None:
    camera_pose = np.array([[0, 0, 1, 0.1], [-1, 0, 0, -0.2], [0, -1, 0, 1.3], [0, 0, 0, 1]])
    gravity = [0, np.cos(0.6), np.sin(0.6)]
    found = client.detect(
        scene.color,
        scene.depth,
        scene.intrinsics,
        id="kitchen 7",
        captured_at_ns=1_700_000_000_123_456_789,
        gravity=gravity,
        camera_pose=camera_pose,
    )
    assert (found.frame_id, found.captured_at_ns) == ("kitchen 7", 1_700_000_000_123_456_789)
    assert (found.width, found.height, found.profile) == (320, 240, "default")
    assert found.gravity.source == "request"
    assert np.allclose(found.gravity.direction, gravity, atol=1e-6)
    assert [each.id for each in found.objects] == [
        f"kitchen 7/{i + 1}" for i in range(len(found.objects))
    ]
    for each in found.objects:
        assert np.allclose(each.pose_in_reference, camera_pose @ each.oriented_box.pose, atol=1e-6)


def test_profile_and_parameters_count(client: fovea.Client, scene: Scene) -> None:
    paper = client.detect_frame(scene.frame(), fovea.DetectOptions(profile="paper"))
    assert paper.profile == "paper"
    one = fovea.DetectOptions(parameters={"objects.max_objects": 1})
    assert len(client.detect_frame(scene.frame(), one).objects) == 1


def test_an_empty_answer_explains_itself(client: fovea.Client, scene: Scene) -> None:
    found = client.detect_frame(scene.frame(depth=np.zeros_like(scene.depth)))
    assert found.objects == [] and found.support_surface is None
    assert found.diagnostics.num_pixels == 320 * 240
    assert found.diagnostics.num_measured == 0
    assert found.diagnostics.messages
    assert not found.label_image().any()


def test_stages_have_times(client: fovea.Client, scene: Scene) -> None:
    times = client.detect_frame(scene.frame()).stage_times_ms
    assert list(times)[:2] == ["queue", "decode"]
    assert sum(times.values()) > 0


@pytest.mark.parametrize("profile", ["default", "paper"])
def test_traces_the_steps(client: fovea.Client, scene: Scene, profile: str) -> None:
    assert client.detect_frame(scene.frame()).trace is None
    found = client.detect_frame(
        scene.frame(), fovea.DetectOptions(profile=profile, return_trace=True)
    )
    trace = found.trace
    assert trace is not None and set(found.saliency_maps) == {"color", "depth"}
    assert len(trace.seeds) == found.diagnostics.num_seeds
    removed = [each.reason for each in trace.removed_seeds]
    assert removed.count("without_depth") == found.diagnostics.seeds_without_depth
    assert removed.count("on_support") == found.diagnostics.seeds_on_support
    assert trace.filled_depth.shape == scene.depth.shape
    assert (trace.filled_depth > 0).sum() >= found.diagnostics.num_points
    assert 0 < trace.hypotheses.max() <= len(trace.seeds)
    assert 0 < trace.segments.max() <= found.diagnostics.num_segments
    assert trace.merged.max() <= trace.segments.max()
    # Each object consists of whole segments where depth was measured, but for flying pixels, and of
    # what these enclose.
    labels = found.label_image()
    for segment in set(np.unique(trace.segments[labels > 0])) - {0}:
        of_segment = labels[(trace.segments == segment) & (scene.depth > 0)]
        assert set(of_segment) <= {0, of_segment.max()}
        assert (of_segment > 0).mean() > 0.9
    for label in np.unique(labels[labels > 0]):
        own = labels == label
        rows, columns = np.nonzero(own & (trace.segments > 0))
        holes = np.argwhere(own & (trace.segments == 0))
        assert len(holes) < len(rows)
        assert (holes > (rows.min(), columns.min())).all()
        assert (holes < (rows.max(), columns.max())).all()


def test_tells_what_it_rejected(client: fovea.Client, scene: Scene) -> None:
    assert client.detect_frame(scene.frame()).rejected == []
    strict = {"objects.min_probability": 1.0}
    options = fovea.DetectOptions(parameters=strict, return_rejected=True)
    found = client.detect_frame(scene.frame(), options)
    assert found.objects == []
    assert len(found.rejected) == found.diagnostics.segments_implausible > 0
    likeliest = found.rejected[0]
    assert 0.5 < likeliest.probability <= 1 and likeliest.reason
    assert likeliest.width * likeliest.height >= 20
    assert likeliest.probability == max(each.probability for each in found.rejected)


def test_answers_with_what_it_has_when_its_time_ends(client: fovea.Client, scene: Scene) -> None:
    assert not client.detect_frame(scene.frame(), fovea.DetectOptions(time_budget=3600)).incomplete
    found = client.detect_frame(scene.frame(), fovea.DetectOptions(time_budget=1e-9))
    assert found.incomplete and found.objects == []
    assert "time budget" in found.diagnostics.messages[0]
    for budget in (-1, 3601, float("nan")):
        with pytest.raises(fovea.InvalidArgument, match="options.time_budget"):
            client.detect_frame(scene.frame(), fovea.DetectOptions(time_budget=budget))
