"""What a robot asks of the objects beside what they are."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea


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


def test_the_operator_knows_the_robots_grippers(scene: Scene) -> None:
    cup = '{"name": "cup", "suction": {"diameter_m": 0.02}}'
    with ServerProcess("--gripper", f"arm={cup}") as server:
        with fovea.Client(server.address, robot="arm", timeout=PATIENCE) as client:
            found = detect(client, scene)
            assert found.grippers_source == "server"
            grasps = [grasp for each in found.objects for grasp in each.grasps]
            assert all(grasp.gripper == "cup" for grasp in grasps)
            own = detect(client, scene, grippers=[fovea.Gripper(name="own")])
            assert own.grippers_source == "request"
        with fovea.Client(server.address, robot="cart", timeout=PATIENCE) as client:
            assert detect(client, scene).grippers_source == "default"
