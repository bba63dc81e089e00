"""What a robot asks of the objects beside what they are."""

from __future__ import annotations

import inspect
from dataclasses import fields

import numpy as np
import pytest
from comparison import assert_same
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea
from fovea.objects import object_from_proto
from fovea.v1 import detection_pb2


def detect(client: fovea.Client, scene: Scene, **asked: object) -> fovea.Detections:
    options = fovea.DetectOptions(**asked)  # type: ignore[arg-type]
    return client.detect(scene.color, scene.depth, scene.intrinsics, options)


def test_objects_have_colors_and_say_how_sure_their_box_is(
    client: fovea.Client, scene: Scene
) -> None:
    found = detect(client, scene)
    assert found.objects
    for each in found.objects:
        shares = [part.share for part in each.colors]
        assert shares == sorted(shares, reverse=True) and 0 < sum(shares) <= 1 + 1e-6
        assert (
            each.colors[0].name in "black gray white red orange yellow green blue purple pink brown"
        )
        assert each.uncertainty is not None
        covariance = each.uncertainty.pose_covariance
        assert np.allclose(covariance, covariance.T, rtol=1e-3)
        assert np.linalg.eigvalsh(covariance).min() >= -1e-9
        assert (each.uncertainty.size_sigma > 0).all()
        assert each.collision is None
    assert found.height_map is None and not found.support_collisions


def test_what_planners_need_comes_if_asked_for(client: fovea.Client, scene: Scene) -> None:
    found = detect(client, scene, collision_primitives=True, height_map_cell_m=0.03)
    for each in found.objects:
        assert each.collision is not None
        assert each.collision.kind in ("box", "cylinder", "sphere")
        assert (each.collision.size > 0).all()
        # It is where the object is.
        apart = np.linalg.norm(each.collision.pose[:3, 3] - each.oriented_box.pose[:3, 3])
        assert apart < np.linalg.norm(each.oriented_box.size) / 2
    assert found.support_collisions[0].kind == "box"
    height_map = found.height_map
    assert height_map is not None and height_map.cell_m == pytest.approx(0.03)
    known = height_map.heights_m[~np.isnan(height_map.heights_m)]
    assert 0 < known.size < height_map.heights_m.size  # what is hidden is unknown
    assert np.count_nonzero(np.abs(known) < 0.02) > known.size / 5  # the table
    points = height_map.points()
    assert points.shape == (known.size, 3) and (points[:, 2] > 0).all()
    top = max(each.oriented_box.size[2] for each in found.objects)
    assert known.max() > 0.5 * top


def test_a_wrong_cell_is_refused(client: fovea.Client, scene: Scene) -> None:
    with pytest.raises(fovea.InvalidArgument, match="options.planning.height_map.cell_m"):
        detect(client, scene, height_map_cell_m=5)


def test_a_height_map_has_at_most_so_many_cells(client: fovea.Client, scene: Scene) -> None:
    all_cells = detect(client, scene, height_map_cell_m=0.03).height_map.heights_m
    few = detect(client, scene, height_map_cell_m=0.03, height_map_max_cells=100).height_map
    assert 80 < few.heights_m.size <= 100 < all_cells.size


def test_free_places_keep_the_margin_and_the_number(client: fovea.Client, scene: Scene) -> None:
    small = {"place_size": (0.02, 0.02, 0.02)}
    found = detect(client, scene, **small)
    assert len(found.free_places) == 5
    assert len(detect(client, scene, **small, max_places=7).free_places) == 7
    least = found.free_places[0].clearance_m / 2
    for margin, is_kept in ((None, False), (least, True)):
        some = detect(client, scene, **small, place_margin_m=margin, max_places=100).free_places
        assert some and all(each.clearance_m >= least for each in some) == is_kept
    with pytest.raises(fovea.InvalidArgument, match="options.places.margin_m"):
        detect(client, scene, **small, place_margin_m=2)


def test_grasps_say_each_thing_as_it_was_sent() -> None:
    proto = detection_pb2.Object()
    sent = proto.grasps.add(kind=detection_pb2.GRASP_KIND_HANDLE, gripper="hand")
    for number, field in enumerate(sent.DESCRIPTOR.fields, start=1):
        if field.message_type:
            getattr(sent, field.name).x = number
        elif field.type != field.TYPE_STRING and not field.enum_type:
            setattr(sent, field.name, number)
    (grasp,) = object_from_proto(proto, 1, 1).grasps
    assert {each.name for each in fields(grasp)} == {each.name for each in sent.DESCRIPTOR.fields}
    assert (grasp.kind, grasp.gripper) == ("handle", "hand")
    for field in sent.DESCRIPTOR.fields:
        said = getattr(grasp, field.name)
        if field.message_type:
            assert said.tolist() == [getattr(sent, field.name).x, 0, 0], field.name
        elif not field.enum_type:
            assert said == getattr(sent, field.name), field.name


def test_the_operator_knows_the_robots_grippers(scene: Scene) -> None:
    cup = '{"name": "cup", "suction": {"diameter_m": 0.02}}'
    with ServerProcess("--gripper", f"arm={cup}") as server:
        with fovea.Client(server.address, robot="arm", timeout=PATIENCE) as client:
            found = detect(client, scene)
            assert found.grippers_source == "server"
            grasps = [grasp for each in found.objects for grasp in each.grasps]
            assert grasps and all(grasp.gripper == "cup" for grasp in grasps)
            (gripper,) = found.grippers
            assert gripper.name == "cup" and gripper.max_opening_m is None
            assert gripper.suction_diameter_m == pytest.approx(0.02)
            assert gripper.max_curvature_per_m and gripper.max_tilt_rad == pytest.approx(0.8)
            own = detect(client, scene, grippers=[fovea.Gripper(name="own")])
            assert own.grippers_source == "request"
        with fovea.Client(server.address, robot="cart", timeout=PATIENCE) as client:
            assert detect(client, scene).grippers_source == "default"


def test_answers_have_the_grippers_with_every_length(client: fovea.Client, scene: Scene) -> None:
    jaw = fovea.Gripper("jaw", max_opening_m=0.14, approach=(0, 0, 1), palm_size_m=(0.1, 0, 0.05))
    cup = fovea.Gripper("cup", suction_diameter_m=0.03, max_grasps=7, min_probability=0.25)
    found = detect(client, scene, grippers=[jaw, cup])
    one, other = found.grippers
    lengths = one.max_opening_m, one.finger_length_m, one.finger_width_m, one.finger_thickness_m
    assert lengths == pytest.approx((0.14, 0.04, 0.02, 0.01))
    assert (one.friction, one.max_tilt_rad, one.min_probability) == pytest.approx((0.5, 0.35, 0.5))
    assert one.palm_size_m == pytest.approx((0.1, 0.04, 0.05))  # 0: what stands for it
    assert one.approach == pytest.approx((0, 0, 1))
    assert (one.suction_diameter_m, one.max_curvature_per_m) == (None, None)
    assert (other.suction_diameter_m, other.max_curvature_per_m) == pytest.approx((0.03, 12))
    assert (other.max_grasps, other.min_probability, other.approach) == (7, 0.25, None)
    assert (other.max_opening_m, other.palm_size_m, other.friction) == (None, None, None)
    assert detect(client, scene, grippers=()).grippers == []


def test_grippers_of_an_answer_can_be_sent_as_they_came(client: fovea.Client, scene: Scene) -> None:
    widest = fovea.Gripper(
        "widest", max_opening_m=1, finger_thickness_m=0.2, max_tilt_rad=np.pi / 2
    )
    largest = fovea.Gripper("largest", suction_diameter_m=0.3, approach=(0, 0.6, 0.8))
    found = detect(client, scene, grippers=[widest, largest, fovea.Gripper(max_opening_m=0.14)])
    assert found.grippers[2].max_opening_m == 0.14  # not what 32 bits make of it
    assert_same(detect(client, scene, grippers=found.grippers), found)
    assert detect(client, scene, grippers=()).grippers == []


def test_help_says_what_a_gripper_has_where_nothing_is_given() -> None:
    told = inspect.getdoc(fovea.Gripper)
    assert told and "max_opening_m: 0.085" in told
    assert [each.name for each in fields(fovea.Gripper) if f"{each.name}: " not in told] == []


def test_a_gripper_alone_is_a_list_of_one(client: fovea.Client, scene: Scene) -> None:
    one = fovea.Gripper("one", max_opening_m=0.14)
    assert_same(detect(client, scene, grippers=one), detect(client, scene, grippers=[one]))
    # What is not given has the values that the contract says.
    assert_same(
        detect(client, scene, grippers=fovea.Gripper()).objects, detect(client, scene).objects
    )
