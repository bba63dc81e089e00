"""Frames, whatever way they come: files, arrays of many kinds, encodings, cameras of their own."""

from __future__ import annotations

import pickle
import zlib
from pathlib import Path

import numpy as np
import pytest
from comparison import EVERYTHING, assert_same
from conftest import Scene
from numpy.typing import NDArray
from PIL import Image

import fovea


def test_takes_frames_from_files(client: fovea.Client, scene: Scene, tmp_path: Path) -> None:
    color, depth = fovea.read_frame(scene.color_file, str(scene.depth_file))
    assert color.dtype == np.uint8 and np.array_equal(color, scene.color)
    assert depth.dtype == np.uint16 and np.array_equal(depth, scene.depth)
    Image.fromarray(color).save(tmp_path / "color.jpg")
    assert fovea.read_frame(tmp_path / "color.jpg", scene.depth_file)[0].shape == color.shape

    with pytest.raises(fovea.InvalidArgument, match="is not a PNG of 16 bits a pixel"):
        fovea.read_frame(scene.color_file, scene.color_file)
    with pytest.raises(fovea.InvalidArgument, match="is not an image of 8 bits"):
        fovea.read_frame(scene.depth_file, scene.depth_file)
    with pytest.raises(FileNotFoundError):
        fovea.read_frame(tmp_path / "none.png", scene.depth_file)


def png_of_16_bits(pixels: NDArray[np.uint16]) -> bytes:
    """Of three channels, which Pillow does not write."""
    height, width = pixels.shape[:2]

    def chunk(kind: bytes, content: bytes) -> bytes:
        checksum = zlib.crc32(kind + content).to_bytes(4, "big")
        return len(content).to_bytes(4, "big") + kind + content + checksum

    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + b"\x10\x02\0\0\0"
    rows = b"".join(b"\0" + row.astype(">u2").tobytes() for row in pixels)
    end = chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + end


def test_takes_no_colour_of_16_bits(scene: Scene, tmp_path: Path) -> None:
    path = tmp_path / "color.png"
    path.write_bytes(png_of_16_bits(scene.color.astype(np.uint16) * 16))
    assert Image.open(path).mode == "RGB"  # as if it had 8
    with pytest.raises(fovea.InvalidArgument, match="is not an image of 8 bits"):
        fovea.read_frame(path, scene.depth_file)


def test_reads_no_file_without_an_end(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fovea.files, "_LARGEST_FILE", 1 << 20)
    with pytest.raises(fovea.InvalidArgument, match="/dev/zero has more than 1 GiB"):
        fovea.read_frame("/dev/zero", scene.depth_file)


@pytest.mark.parametrize("which", ["color", "depth"])
def test_names_a_file_that_is_broken(scene: Scene, tmp_path: Path, which: str) -> None:
    broken = tmp_path / "broken.png"
    files = {"color": scene.color_file, "depth": scene.depth_file}
    whole = files[which].read_bytes()
    files[which] = broken
    for content in (whole[: len(whole) // 2], whole[:20], b"", b"no image"):
        broken.write_bytes(content)
        with pytest.raises(fovea.InvalidArgument) as caught:
            fovea.read_frame(files["color"], files["depth"])
        assert caught.value.field == f"frame.{which}"
        assert str(broken) in caught.value.message
        assert isinstance(caught.value, OSError)  # as of files that cannot be opened
        assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_takes_depth_of_other_integers(client: fovea.Client, scene: Scene) -> None:
    wanted = client.detect_frame(scene.frame())
    for kind in (np.int32, np.int64, np.uint32):
        assert_same(client.detect_frame(scene.frame(depth=scene.depth.astype(kind))), wanted)


def test_takes_depth_of_8_bits_whose_unit_is_said(scene: Scene) -> None:
    coarse = (scene.depth // 20).astype(np.uint8)
    frame = scene.frame(depth=coarse, depth_unit_m=0.02)
    assert frame.to_proto().depth.data == coarse.astype("<u2").tobytes()


@pytest.mark.parametrize(
    ("kind", "encoding"),
    [(np.uint16, "raw"), (np.uint16, "png"), (np.int32, "raw"), (np.float32, "raw")],
)
def test_masked_depth_is_not_measured(scene: Scene, kind: type, encoding: str) -> None:
    depth = scene.depth.astype(kind)
    hidden = np.arange(depth.size).reshape(depth.shape) % 320 < 160
    plain = np.where(hidden, np.nan if kind is np.float32 else 0, depth).astype(kind)
    sent = [
        scene.frame(depth=each, depth_encoding=encoding).to_proto().depth
        for each in (np.ma.MaskedArray(depth, mask=hidden), plain)
    ]
    assert sent[0] == sent[1]


def test_arrays_that_mask_nothing_are_as_others(scene: Scene) -> None:
    frame = scene.frame(color=np.ma.MaskedArray(scene.color), depth=np.ma.MaskedArray(scene.depth))
    assert frame.to_proto() == scene.frame().to_proto()


def test_registers_depth_of_a_camera_of_its_own(client: fovea.Client, scene: Scene) -> None:
    """Here every second pixel of each row and column: a camera in the same place."""
    expected = client.detect_frame(scene.frame())
    k = scene.intrinsics
    coarse = fovea.CameraIntrinsics(k.fx / 2, k.fy / 2, k.cx / 2, k.cy / 2)
    found = client.detect(
        scene.color,
        scene.depth[::2, ::2],
        k,
        depth_intrinsics=coarse,
        color_from_depth=np.eye(4),
    )
    assert len(found.objects) == len(expected.objects)
    for each in expected.objects:
        overlaps = [(each.mask & o.mask).sum() / (each.mask | o.mask).sum() for o in found.objects]
        assert max(overlaps) > 0.7


def test_the_same_frame_gives_the_same_answer_in_every_lossless_way(
    client: fovea.Client, scene: Scene
) -> None:
    expected = client.detect_frame(scene.frame(), EVERYTHING)
    float_depth = np.where(scene.depth == 0, np.nan, scene.depth * 0.001).astype(np.float32)
    ways = [
        {"color": scene.color_file.read_bytes(), "depth": scene.depth_file.read_bytes()},
        {"color_encoding": "png", "depth_encoding": "png"},
        {"depth": scene.depth.astype(">u2"), "depth_encoding": "png"},
        {"color": scene.color[..., ::-1], "color_encoding": "bgr8", "depth_encoding": "zstd"},
        {"depth": float_depth},
        {"depth": float_depth, "depth_encoding": "zstd"},
        {"depth": scene.depth.astype(">u2")},
        {"color": np.asfortranarray(scene.color), "depth": np.asfortranarray(scene.depth)},
        {"depth": scene.depth * np.uint16(2), "depth_unit_m": 0.0005},
        {"intrinsics": [[262.5, 0, 159.5], [0, 262.5, 119.5], [0, 0, 1]]},
    ]
    for way in ways:
        assert_same(client.detect_frame(scene.frame(**way), EVERYTHING), expected)


def test_jpeg_is_sent_as_jpeg(client: fovea.Client, scene: Scene) -> None:
    frame = scene.frame(color_encoding="jpeg")
    file = frame.to_proto().color.data
    assert file.startswith(b"\xff\xd8\xff")
    assert len(file) < scene.color.nbytes / 4
    found = client.detect_frame(frame)
    assert found.objects
    assert_same(client.detect_frame(scene.frame(color=file)), found)
