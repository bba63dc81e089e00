"""Mistakes in options are named by their field before they are sent."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from conftest import Scene

import fovea

GRIPPER = "options.grasps.grippers[0]"
TWO_KINDS = "has max_opening_m of two fingers and suction_diameter_m of a suction cup"

# Options that are caught here.
LOCAL_OPTIONS: list[tuple[dict[str, Any], str, str]] = [
    (
        {"place_size": (0.05, 0.05)},
        "options.places.size",
        "place_size has the shape (2,), not (3,)",
    ),
    ({"place_size": (0.1, 0, 0.1)}, "options.places.size", "is not a finite number above 0"),
    ({"place_size": 0.05}, "options.places.size", "place_size has the shape ()"),
    ({"place_size": "big"}, "options.places.size", "place_size is not made of numbers"),
    ({"height_map_cell_m": 0}, "options.planning.height_map.cell_m", "height_map_cell_m=0 is"),
    ({"place_size": (1, 1, 1), "place_margin_m": "1"}, "options.places.margin_m", "'1' is not"),
    ({"place_size": (1, 1, 1), "max_places": 0}, "options.places.max_places", "0 is not a whole"),
    (
        {"height_map_cell_m": 1, "height_map_max_cells": 0},
        "options.planning.height_map.max_cells",
        "0 is not a whole number from 1",
    ),
    ({"tracking": True, "tracking_reset": -1}, "options.tracking.reset", "-1 is not a whole"),
    ({"profile": 5}, "options.profile", "5 is not a str"),
    ({"parameters": [("mrf.gamma_per_m2", 80)]}, "options.parameters", "is list, not a dict"),
    ({"parameters": {5: 80}}, "options.parameters", "5 is not a str"),
    ({"time_budget": "1"}, "options.time_budget", "'1' is not a finite number"),
    ({"time_budget": 10**400}, "options.time_budget", "an integer of 1329 bits is not a finite"),
    ({"parameters": {"mrf.lambda": 10**400}}, "options.parameters[mrf.lambda]", "beyond any"),
    ({"parameters": {"mrf.lambda": 10**5000}}, "options.parameters[mrf.lambda]", "beyond any"),
    ({"return_masks": "no"}, "options.return_masks", "'no' is not True or False"),
    ({"return_rejected": None}, "options.return_rejected", "None is not True or False"),
    ({"tracking": "no"}, "options.tracking.enabled", "'no' is not True or False"),
    (
        {"collision_primitives": "no"},
        "options.planning.collision_primitives",
        "'no' is not True or False",
    ),
    ({"grippers": 0.085}, "options.grasps.grippers", "is float, not a fovea.Gripper or several"),
    ({"grippers": "jaw"}, "options.grasps.grippers", "is str, not a fovea.Gripper or several"),
    ({"grippers": [fovea.Gripper(), 1]}, "options.grasps.grippers[1]", "is int, not a"),
]


def _of_gripper(field: str, problem: str, **gripper: Any) -> tuple[dict[str, Any], str, str]:
    return {"grippers": fovea.Gripper("x", **gripper)}, GRIPPER + field, problem


LOCAL_OPTIONS += [
    ({"grippers": fovea.Gripper("\ud800")}, f"{GRIPPER}.name", "is not Unicode text"),
    ({"grippers": fovea.Gripper(5)}, f"{GRIPPER}.name", "5 is not a str"),  # type: ignore[arg-type]
    _of_gripper("", TWO_KINDS, max_opening_m=0.1, suction_diameter_m=0.03),
    _of_gripper("", TWO_KINDS, max_opening_m=0.085, suction_diameter_m=0.03),
    _of_gripper(".jaw.max_opening_m", "max_opening_m=0 is not", max_opening_m=0),
    _of_gripper(".jaw.max_opening_m", "max_opening_m=inf is not", max_opening_m=np.inf),
    _of_gripper(".jaw.max_opening_m", "max_opening_m=an integer of 1329", max_opening_m=10**400),
    _of_gripper(".max_grasps", "an integer of 16610 bits is not a whole", max_grasps=10**5000),
    _of_gripper(".jaw.finger_length_m", "finger_length_m=-0.1 is", finger_length_m=-0.1),
    _of_gripper(".jaw.finger_width_m", "finger_width_m=nan is", finger_width_m=np.nan),
    _of_gripper(".jaw.finger_thickness_m", "finger_thickness_m='1'", finger_thickness_m="1"),
    _of_gripper(".jaw.friction", "friction=0 is not", friction=0),
    _of_gripper(".jaw.palm_size", "shape (2,), not (3,)", palm_size_m=(0.1, 0.1)),
    _of_gripper(".suction.diameter_m", "suction_diameter_m=0 is", suction_diameter_m=0),
    _of_gripper(".suction.diameter_m", "suction_diameter_m is missing", max_curvature_per_m=9),
    _of_gripper(".approach", "shape (1,), not (3,)", approach=(1,)),
    _of_gripper(".max_grasps", "0 is not a whole number from 1", max_grasps=0),
    _of_gripper(".max_tilt_rad", "nan is not a finite number", max_tilt_rad=np.nan),
    _of_gripper(".min_probability", "True is not a finite number", min_probability=True),
    _of_gripper(".jaw.max_opening_m", "max_opening_m=True is not", max_opening_m=True),
]


@pytest.mark.parametrize(("options", "field", "problem"), LOCAL_OPTIONS)
def test_finds_mistakes_of_options_before_sending(
    scene: Scene, options: dict[str, Any], field: str, problem: str
) -> None:
    with pytest.raises(fovea.InvalidArgument) as caught:
        fovea.Client("127.0.0.1:1").detect_frame(scene.frame(), fovea.DetectOptions(**options))
    assert caught.value.field == field
    assert problem in caught.value.message


@pytest.mark.parametrize("options", [None, {"profile": "paper"}])
def test_names_options_that_are_none(scene: Scene, options: Any) -> None:
    nobody = fovea.Client("127.0.0.1:1")
    for call in (
        lambda: nobody.detect(scene.color, scene.depth, scene.intrinsics, options),
        lambda: nobody.stream([scene.frame()], options),
    ):
        with pytest.raises(fovea.InvalidArgument, match="not fovea.DetectOptions") as caught:
            call()
        assert caught.value.field == "options"


def test_flags_may_be_of_numpy() -> None:
    proto = fovea.DetectOptions(return_clouds=np.bool_(True), return_masks=0).to_proto()
    assert proto.return_clouds and not proto.return_masks


def test_a_short_time_budget_is_not_none() -> None:
    assert fovea.DetectOptions(time_budget=1e-12).to_proto().time_budget.nanos == 1
    assert not fovea.DetectOptions().to_proto().HasField("time_budget")


def test_names_arguments_that_are_none(scene: Scene) -> None:
    nobody = fovea.Client("127.0.0.1:1")
    for unknown, problem in (
        ({"grippers": []}, "'grippers'; options=fovea.DetectOptions(grippers=...) takes it"),
        ({"gravty": (0, 1, 0)}, "'gravty'"),
    ):
        with pytest.raises(TypeError) as caught:
            nobody.detect(scene.color, scene.depth, scene.intrinsics, **unknown)
        assert str(caught.value) == f"detect() got an unexpected keyword argument {problem}"
