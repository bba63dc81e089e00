"""Mistakes are named by their field, before they are sent where that is possible."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Scene
from PIL import Image

import fovea

TURNED = np.eye(4)[[1, 0, 2, 3]]  # a reflection


def _plumb_bob(coefficients: Any) -> fovea.LensDistortion:
    return fovea.LensDistortion("plumb_bob", coefficients)


def _of_lens(field: str, problem: str, distortion: Any) -> tuple[dict[str, Any], str, str]:
    intrinsics = fovea.CameraIntrinsics(5, 5, 3, 3, distortion)
    return {"intrinsics": intrinsics}, f"frame.intrinsics.distortion{field}", problem


# What is caught here: changes to a good frame, the field and a part of the message.
LOCAL: list[tuple[dict[str, Any], str, str]] = [
    ({"color": np.zeros((240, 320), np.uint8)}, "frame.color", "shape (240, 320), not HxWx3"),
    ({"color": np.zeros((240, 320, 4), np.uint8)}, "frame.color", "not HxWx3"),
    ({"color": np.zeros((240, 320, 3))}, "frame.color", "float64, not HxWx3 uint8"),
    ({"color": np.ma.masked_equal(np.zeros((240, 320, 3), np.uint8), 0)}, "frame.color", "masked"),
    ({"color": [[1, 2]]}, "frame.color", "is list, not an array"),
    ({"color": np.zeros((0, 320, 3), np.uint8)}, "frame.color", "is empty"),
    ({"color": Image.new("RGB", (320, 240))}, "frame.color", "np.asarray(image) is one"),
    (
        {"color": "a_color.png"},
        "frame.color",
        "is a path, not an array of HxWx3 uint8; fovea.read_",
    ),
    ({"depth": Path("a_depth.png")}, "frame.depth", "fovea.read_frame(color, depth) reads files"),
    ({"depth": np.ones((240, 320))}, "frame.depth", "float32; .astype(np.float32) makes it that"),
    ({"depth": np.ones((240, 320), bool)}, "frame.depth", "is an array of bool, not HxW uint16"),
    ({"color": b"GIF89a"}, "frame.color.data", "neither a PNG nor a JPEG"),
    ({"color_encoding": "webp"}, "frame.color.encoding", "rgb8, bgr8, png, jpeg"),
    ({"depth": np.zeros((240, 320, 1), np.uint16)}, "frame.depth", "not HxW"),
    ({"depth": np.zeros((240, 320))}, "frame.depth", "float64, not HxW uint16 or float32"),
    ({"depth": np.full((240, 320), -1, np.int32)}, "frame.depth", "values from -1 to -1, which"),
    ({"depth": np.full((240, 320), 65536)}, "frame.depth", "int64 with values from 65536 to 65536"),
    (
        {"depth": np.ones((240, 320), np.uint8)},
        "frame.depth",
        "uint8, in millimetres nothing beyond",
    ),
    ({"depth": np.zeros((320, 240), np.uint16)}, "frame.depth", "is 240x320, colour is 320x240"),
    ({"depth": None}, "frame.depth", "is NoneType"),
    ({"depth": b"\xff\xd8\xff"}, "frame.depth.data", "not a PNG"),
    ({"depth_encoding": "jpeg"}, "frame.depth.encoding", "raw, zstd, png"),
    (
        {"depth": np.ones((240, 320), np.float32), "depth_encoding": "png"},
        "frame.depth.encoding",
        "uint16 only",
    ),
    (
        {"depth": np.ones((240, 320), np.float32), "depth_unit_m": 0.001},
        "frame.depth.unit_m",
        "float depth is in metres; depth_unit_m is for depth in integers",
    ),
    ({"depth_unit_m": 0}, "frame.depth.unit_m", "depth_unit_m=0 is not a finite number above 0"),
    ({"depth_unit_m": "mm"}, "frame.depth.unit_m", "depth_unit_m='mm' is not a finite number"),
    ({"intrinsics": np.eye(4)}, "frame.intrinsics", "shape (4, 4), not (3, 3)"),
    ({"intrinsics": (5, 5, 3, 3)}, "frame.intrinsics", "fovea.CameraIntrinsics(fx, fy, cx, cy)"),
    ({"intrinsics": [[5, 0, 3], [0, 5]]}, "frame.intrinsics", "not made of numbers"),
    ({"intrinsics": "wide"}, "frame.intrinsics", "not made of numbers"),
    ({"intrinsics": [[5, 1, 3], [0, 5, 3], [0, 0, 1]]}, "frame.intrinsics", "is not [[fx, 0"),
    ({"intrinsics": fovea.CameraIntrinsics(10**400, 5, 3, 3)}, "frame.intrinsics.fx", "finite"),
    (
        {"intrinsics": fovea.CameraIntrinsics(np.complex64(5), 5, 3, 3)},
        "frame.intrinsics.fx",
        "5+0j",
    ),
    ({"intrinsics": fovea.CameraIntrinsics(5, np.nan, 3, 3)}, "frame.intrinsics.fy", "finite"),
    _of_lens("", "is tuple, not fovea.LensDistortion", (0, 0, 0, 0)),
    _of_lens(".model", "['x'] is not a str", fovea.LensDistortion(["x"], (0.1,))),  # type: ignore
    _of_lens(".coefficients", "None is not several numbers", _plumb_bob(None)),
    _of_lens(".coefficients", "0.1 is not several numbers", _plumb_bob(0.1)),
    _of_lens(".coefficients", "is not made of numbers", _plumb_bob("wide")),
    _of_lens(".coefficients", "has the shape (2, 2), not that of", _plumb_bob(np.eye(2))),
    ({"id": 7}, "frame.id", "7 is not a str"),
    ({"id": "\ud800"}, "frame.id", "is not Unicode text"),
    ({"captured_at_ns": 1.8e18}, "frame.captured_at", "=1.8e+18 is not a whole number of nano"),
    ({"captured_at_ns": 10**30}, "frame.captured_at", "not in the years 1 to 9999"),
    ({"captured_at_ns": 10**5000}, "frame.captured_at", "=an integer of 16610 bits is not"),
    ({"depth_unit_m": 10**400}, "frame.depth.unit_m", "=an integer of 1329 bits is not a finite"),
    ({"gravity": [0, 10**400, 0]}, "frame.gravity", "has an integer beyond what a float holds"),
    ({"gravity": [0, 1]}, "frame.gravity", "shape (2,), not (3,)"),
    ({"camera_pose": np.eye(3)}, "frame.camera_pose", "shape (3, 3), not (4, 4)"),
    ({"camera_pose": 2 * np.eye(4)}, "frame.camera_pose", "rotation"),
    ({"camera_pose": TURNED}, "frame.camera_pose", "rotation"),
    ({"depth_intrinsics": np.eye(3)}, "frame.color_from_depth", "is missing"),
    ({"color_from_depth": np.eye(4)}, "frame.depth_intrinsics", "is missing"),
    (
        {"depth_intrinsics": np.eye(4), "color_from_depth": np.eye(4)},
        "frame.depth_intrinsics",
        "shape (4, 4), not (3, 3)",
    ),
    (
        {"depth_intrinsics": np.eye(3), "color_from_depth": TURNED},
        "frame.color_from_depth",
        "rotation",
    ),
    (
        {
            "depth_intrinsics": fovea.CameraIntrinsics(np.inf, 5, 3, 3),
            "color_from_depth": np.eye(4),
        },
        "frame.depth_intrinsics.fx",
        "finite",
    ),
]

# What the server finds.
REMOTE: list[tuple[dict[str, Any], str]] = [
    ({"intrinsics": fovea.CameraIntrinsics(0, 5, 3, 3)}, "frame.intrinsics.fx"),
    ({"gravity": [0, 2, 0]}, "frame.gravity"),
    (
        {"depth_intrinsics": np.diag([0, 5, 1]), "color_from_depth": np.eye(4)},
        "frame.depth_intrinsics.fx",
    ),
    (
        {"depth_intrinsics": np.eye(3), "color_from_depth": np.eye(4) + np.eye(4, k=3) * 25},
        "frame.color_from_depth.position",
    ),
    ({"id": "x" * 300}, "frame.id"),
    ({"depth_unit_m": 7.0}, "frame.depth.unit_m"),
    ({"color": b"\x89PNG\r\n\x1a\n", "depth": np.ones((9, 9), np.uint16)}, "frame.color.data"),
    (
        {"color": np.zeros((1800, 1800, 3), np.uint8), "depth": np.ones((1800, 1800), np.uint16)},
        "frame.color.width, height",
    ),
]


@pytest.mark.parametrize(("changes", "field", "problem"), LOCAL)
def test_finds_mistakes_before_sending(
    scene: Scene, changes: dict[str, Any], field: str, problem: str
) -> None:
    nobody = fovea.Client("127.0.0.1:1")
    with pytest.raises(fovea.InvalidArgument) as caught:
        nobody.detect_frame(scene.frame(**changes))
    assert caught.value.field == field
    assert problem in caught.value.message
    assert str(caught.value).startswith(f"INVALID_ARGUMENT: {field}: ")
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize(
    ("tls", "field", "problem"),
    [
        (fovea.TlsOptions(certificate_chain=b"x"), "tls.private_key", "is missing"),
        (fovea.TlsOptions(private_key=b"x"), "tls.certificate_chain", "is missing"),
        (True, "tls", "is bool, not fovea.TlsOptions"),
        (fovea.TlsOptions(b"ca.pem"), "tls.root_certificates", "holds no CERTIFICATE in PEM"),
        (
            fovea.TlsOptions(b"", b"-----BEGIN CERTIFICATE-----", b"robot.key"),
            "tls.private_key",
            "holds no PRIVATE KEY in PEM",
        ),
        (fovea.TlsOptions("x"), "tls.root_certificates", "not bytes"),  # type: ignore[arg-type]
    ],
)
def test_finds_mistakes_of_tls_before_connecting(
    tls: fovea.TlsOptions, field: str, problem: str
) -> None:
    for address in ("127.0.0.1:1", "localhost:1"):  # names are looked up later
        with pytest.raises(fovea.InvalidArgument) as caught:
            fovea.Client(address, tls=tls)
        assert caught.value.field == field
        assert problem in caught.value.message


@pytest.mark.parametrize(("changes", "field"), REMOTE)
def test_reads_the_field_of_the_servers_error(
    client: fovea.Client, scene: Scene, changes: dict[str, Any], field: str
) -> None:
    with pytest.raises(fovea.InvalidArgument) as caught:
        client.detect_frame(scene.frame(**changes))
    assert caught.value.field == field


@pytest.mark.parametrize(
    ("options", "field"),
    [
        (fovea.DetectOptions(profile="fast"), "options.profile"),
        (fovea.DetectOptions(parameters={"no.such": 1}), "options.parameters[no.such]"),
        (fovea.DetectOptions(parameters={"a b: c": 1}), "options.parameters[a b: c]"),
        (
            fovea.DetectOptions(parameters={"mrf.gamma_per_m2": -1}),
            "options.parameters[mrf.gamma_per_m2]",
        ),
        (fovea.DetectOptions(parameters={"x": "much"}), "options.parameters[x]"),  # type: ignore
    ],
)
def test_names_the_option(
    client: fovea.Client, scene: Scene, options: fovea.DetectOptions, field: str
) -> None:
    with pytest.raises(fovea.InvalidArgument) as caught:
        client.detect_frame(scene.frame(), options)
    assert caught.value.field == field


@pytest.mark.parametrize("most", [0, -1, 2048, 4096, 1.5, None])
def test_names_a_size_of_answers_that_no_connection_takes(most: Any) -> None:
    with pytest.raises(fovea.InvalidArgument, match="not a whole number from 1 to 2047") as caught:
        fovea.Client("127.0.0.1:1", max_answer_mib=most)
    assert caught.value.field == "max_answer_mib"


def test_takes_the_largest_size_of_answers(server: Any) -> None:
    for most in (1, np.int64(2047)):
        with fovea.Client(server.address, max_answer_mib=most) as client:
            assert client.get_server_info().version


def test_names_what_cannot_travel_in_a_header() -> None:
    for name in ("robot", "token"):
        for value in ("Küche", b"kitchen"):
            with pytest.raises(fovea.InvalidArgument) as caught:
                fovea.Client("127.0.0.1:1", **{name: value})
            assert caught.value.field.startswith("metadata ")


def test_names_the_line_break_of_a_token_from_a_file() -> None:
    for token in ("0123\n", "0123\r\n"):
        with pytest.raises(fovea.InvalidArgument, match="the token ends in a line break"):
            fovea.Client("127.0.0.1:1", token=token)
    with pytest.raises(fovea.InvalidArgument, match="the token must be printable ASCII"):
        fovea.Client("127.0.0.1:1", token="01\t23")


def test_names_a_robot_that_the_server_does_not_take(client: fovea.Client, server: Any) -> None:
    with fovea.Client(server.address, robot="x" * 65) as nameless:
        with pytest.raises(fovea.InvalidArgument) as caught:
            nameless.get_server_info()
    assert caught.value.field == "metadata fovea-robot"


def test_a_frame_too_large_for_a_message_is_no_overload(client: fovea.Client, scene: Scene) -> None:
    large = np.zeros((2400, 2400, 3), np.uint8)
    with pytest.raises(fovea.ResourceExhausted) as caught:
        client.detect(large, np.ones((2400, 2400), np.uint16), scene.intrinsics)
    assert not isinstance(caught.value, fovea.Overloaded)
    sizes = "the frame is 27.5 MiB, the server takes 24.0 MiB"
    assert caught.value.message.startswith(f"{sizes} (--max-message-mib): send a smaller image")


def test_an_answer_too_large_for_the_client_names_its_limit(server: Any, scene: Scene) -> None:
    with fovea.Client(server.address, max_answer_mib=1) as client:
        with pytest.raises(fovea.ResourceExhausted, match="client takes 1.0 MiB .max_answer_mib"):
            options = fovea.DetectOptions(return_trace=True, return_saliency_maps=True)
            client.detect(
                np.kron(scene.color, np.ones((2, 2, 1), np.uint8)),
                np.kron(scene.depth, np.ones((2, 2), np.uint16)),
                fovea.CameraIntrinsics(525, 525, 319.5, 239.5),
                options,
            )


@pytest.mark.parametrize(
    ("module", "changes", "package"),
    [
        ("PIL", {"color_encoding": "png"}, "python3-pil"),
        ("PIL", {"color_encoding": "jpeg"}, "python3-pil"),
        ("PIL", {"depth_encoding": "png"}, "python3-pil"),
        ("zstandard", {"depth_encoding": "zstd"}, "python3-zstandard"),
    ],
)
def test_names_the_package_that_is_missing(
    scene: Scene, monkeypatch: pytest.MonkeyPatch, module: str, changes: Any, package: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(fovea.MissingPackage) as caught:
        scene.frame(**changes).to_proto()
    assert caught.value.package == package
    assert package in str(caught.value)
