"""Answers with all that they may hold, and whether two are the same to the last bit."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

import fovea

EVERYTHING = fovea.DetectOptions(return_clouds=True, return_saliency_maps=True, return_seeds=True)


def assert_same(one: Any, other: Any, path: str = "answer") -> None:
    """All but the times that the stages took."""
    assert type(one) is type(other), path
    if dataclasses.is_dataclass(one):
        for field in dataclasses.fields(one):
            if field.name != "stage_times_ms":
                values = getattr(one, field.name), getattr(other, field.name)
                assert_same(*values, f"{path}.{field.name}")
    elif isinstance(one, list):
        assert len(one) == len(other), path
        for index, pair in enumerate(zip(one, other)):
            assert_same(*pair, f"{path}[{index}]")
    elif isinstance(one, dict):
        assert one.keys() == other.keys(), path
        for key in one:
            assert_same(one[key], other[key], f"{path}[{key}]")
    elif isinstance(one, np.ndarray):
        assert one.dtype == other.dtype, path
        assert np.array_equal(one, other), path
    else:
        assert one == other, path
