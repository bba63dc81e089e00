"""Streams: order, drops, bad frames, early exits."""

from __future__ import annotations

import itertools
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from threading import Event, get_ident
from typing import Any

import numpy as np
import pytest
from comparison import assert_same
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea


def test_every_frame_is_answered_in_order(client: fovea.Client, scene: Scene) -> None:
    expected = client.detect_frame(scene.frame(id="f"))
    answers = list(client.stream([scene.frame(id="f")] * 5, every_frame=True))
    assert [answer.sequence for answer in answers] == [0, 1, 2, 3, 4]
    for answer in answers:
        assert (answer.frame_id, answer.dropped, answer.error) == ("f", 0, None)
        assert_same(answer.detections, expected)


def test_things_keep_their_ids_where_that_is_asked_for(client: fovea.Client, scene: Scene) -> None:
    frames = [scene.frame(id=str(i), captured_at_ns=10**18 + i * 10**8) for i in range(3)]
    options = fovea.DetectOptions(tracking=True)
    answers = [answer.detections for answer in client.stream(frames, options, every_frame=True)]
    first, last = answers[0], answers[-1]
    assert first.camera_motion is None and last.camera_motion.source == "standing"
    assert np.allclose(last.camera_motion.motion, np.eye(4))
    assert len({answer.track_epoch for answer in answers}) == 1 and first.track_epoch
    ids = [each.track_id for each in first.objects]
    assert ids == list(range(1, len(ids) + 1)) and len(ids) >= 3
    assert [each.track_id for each in last.objects] == ids
    for each in last.objects:
        assert (each.times_seen, each.steadied_over, each.first_seen_ns) == (3, 3, 10**18)
        assert np.allclose(each.steadied_box.pose, each.oriented_box.pose, atol=1e-5)
    assert last.hidden_tracks == []
    assert "tracking" in last.stage_times_ms

    again = [answer.detections for answer in client.stream(frames, options, every_frame=True)]
    assert again[0].track_epoch != first.track_epoch
    plain = [answer.detections for answer in client.stream(frames[:1], every_frame=True)]
    assert plain[0].track_epoch is None and plain[0].objects[0].track_id is None


def test_tracks_start_anew_where_that_is_asked_for(client: fovea.Client, scene: Scene) -> None:
    reset = fovea.DetectOptions(tracking=True, tracking_reset=1)
    frames = [scene.frame(), scene.frame(), (scene.frame(), reset), scene.frame()]
    tracking = fovea.DetectOptions(tracking=True)
    answers = [answer.detections for answer in client.stream(frames, tracking, every_frame=True)]
    before, same, anew, still = [answer.track_epoch for answer in answers]
    assert before == same != anew == still
    assert [answer.objects[0].times_seen for answer in answers] == [1, 2, 1, 2]


def test_a_single_call_has_no_frames_to_track(client: fovea.Client, scene: Scene) -> None:
    with pytest.raises(fovea.InvalidArgument, match="call Client.stream"):
        client.detect_frame(scene.frame(), fovea.DetectOptions(tracking=True))


def test_the_newest_frame_is_answered_and_those_between_are_counted(
    client: fovea.Client, scene: Scene
) -> None:
    frames = [scene.frame(id=str(number)) for number in range(30)]
    next_expected = 0
    for answer in client.stream(frames):
        assert answer.sequence == next_expected + answer.dropped
        assert answer.frame_id == str(answer.sequence)
        next_expected = answer.sequence + 1
    assert next_expected == 30


def test_a_bad_frame_gets_an_error_and_the_stream_goes_on(
    client: fovea.Client, scene: Scene
) -> None:
    frames = [
        scene.frame(id="good"),
        scene.frame(id="found by the server", gravity=[0, 2, 0]),
        scene.frame(id="found here", depth=scene.depth[:5]),
        scene.frame(id="found here, too", color=b"GIF89a"),
        scene.frame(id="good again"),
    ]
    answers = list(client.stream(frames, every_frame=True))
    assert [answer.frame_id for answer in answers] == [frame.id for frame in frames]
    fields = [answer.error.field if answer.error else None for answer in answers]
    assert fields == [None, "frame.gravity", "frame.depth", "frame.color.data", None]
    assert [answer.detections is None for answer in answers] == [bool(field) for field in fields]
    assert "is 320x5, colour is 320x240" in str(answers[2].error)


def test_a_lens_that_is_none_is_the_error_of_its_frame(client: fovea.Client, scene: Scene) -> None:
    lens = fovea.LensDistortion("plumb_bob", None)
    for distortion in (lens, (0, 0, 0, 0)):
        intrinsics = fovea.CameraIntrinsics(262.5, 262.5, 159.5, 119.5, distortion)
        frames = [scene.frame(), scene.frame(intrinsics=intrinsics), scene.frame()]
        answers = list(client.stream(frames, every_frame=True))
        assert [answer.error is None for answer in answers] == [True, False, True]
        assert answers[1].error.field.startswith("frame.intrinsics.distortion")


def test_errors_of_dropped_frames_are_not_mistaken(client: fovea.Client, scene: Scene) -> None:
    frames = [scene.frame(), scene.frame(color=b"GIF89a")] * 15
    for answer in client.stream(frames):
        assert (answer.error is not None) == (answer.sequence % 2 == 1)


def test_options_hold_for_all_frames(client: fovea.Client, scene: Scene) -> None:
    one = fovea.DetectOptions(parameters={"objects.max_objects": 1}, return_masks=False)
    for answer in client.stream([scene.frame()] * 3, one, every_frame=True):
        assert len(answer.detections.objects) == 1
        assert answer.detections.objects[0].mask is None
    with pytest.raises(fovea.InvalidArgument):
        client.stream([], fovea.DetectOptions(parameters={"x": None}))  # type: ignore[dict-item]


def test_options_of_a_frame_hold_from_there_on(client: fovea.Client, scene: Scene) -> None:
    one = fovea.DetectOptions(parameters={"objects.max_objects": 1})
    frames = [scene.frame(), (scene.frame(), one), scene.frame()]
    answers = list(client.stream(frames, every_frame=True))
    assert len(answers[0].detections.objects) > 1
    assert [len(answers[i].detections.objects) for i in (1, 2)] == [1, 1]


@pytest.mark.parametrize(
    "wrong", [{"profile": 5}, {"parameters": {"no.such": 1}}], ids=["here", "by_the_server"]
)
def test_options_that_are_refused_hold_too(
    client: fovea.Client, scene: Scene, wrong: dict[str, Any]
) -> None:
    frame, good = scene.frame(id="f"), fovea.DetectOptions()
    frames = [frame, (frame, fovea.DetectOptions(**wrong)), frame, (frame, good), frame]
    answers = list(client.stream(frames, every_frame=True))
    assert [answer.error is None for answer in answers] == [True, False, False, True, True]
    assert {answer.frame_id for answer in answers} == {"f"}
    for answer in answers[1:3]:
        assert answer.error.field.startswith("options.p")


def test_no_frames_no_answers(client: fovea.Client) -> None:
    assert list(client.stream([])) == []


def test_leaving_the_loop_ends_the_stream(scene: Scene) -> None:
    go_on = Event()

    def hanging_camera() -> Iterator[fovea.Frame]:
        yield scene.frame()
        go_on.wait(PATIENCE)

    with ServerProcess() as server, fovea.Client(server.address, timeout=PATIENCE) as client:
        for camera in (hanging_camera(), map(lambda _: scene.frame(), itertools.count())):
            for _ in client.stream(camera):
                assert client.get_statistics().streams == 1
                break
            patience_ends = time.monotonic() + PATIENCE
            while client.get_statistics().streams > 0:
                assert time.monotonic() < patience_ends, "the server still has the stream"
        go_on.set()


def test_frames_are_taken_one_by_one_in_another_thread(client: fovea.Client, scene: Scene) -> None:
    threads = []
    ended = Event()

    def camera() -> Iterator[fovea.Frame]:
        try:
            while True:
                threads.append(get_ident())
                yield scene.frame()
        finally:  # nobody holds it any more
            ended.set()

    answers = client.stream(camera(), every_frame=True)
    next(answers)
    answers.close()
    assert ended.wait(PATIENCE)
    assert len(threads) == 1 and get_ident() not in threads


def test_what_the_camera_raises_comes_after_the_answers(client: fovea.Client, scene: Scene) -> None:
    def camera() -> Iterator[fovea.Frame]:
        yield scene.frame()
        raise OSError("the camera is gone")

    answers = client.stream(camera())
    assert next(answers).detections
    with pytest.raises(OSError, match="the camera is gone"):
        next(answers)


def test_other_things_than_frames_are_refused(client: fovea.Client) -> None:
    with pytest.raises(TypeError, match="must be fovea.Frame, not tuple"):
        list(client.stream([(1, 2, 3)]))  # type: ignore[list-item]


def test_a_missing_package_ends_the_stream(
    client: fovea.Client, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "zstandard", None)
    with pytest.raises(fovea.MissingPackage):
        list(client.stream([scene.frame(depth_encoding="zstd")]))


def test_a_camera_may_pause_longer_than_the_timeout(client: fovea.Client, scene: Scene) -> None:
    def camera() -> Iterator[fovea.Frame]:
        yield scene.frame(gravity=[0, 2, 0])  # answered at once
        Event().wait(3.5)  # the pause itself is what is tested
        yield scene.frame(gravity=[0, 2, 0], id="last")

    assert [answer.frame_id for answer in client.stream(camera(), timeout=3.0)] == ["", "last"]


def test_a_program_ends_though_its_camera_hangs(server: ServerProcess, scene: Scene) -> None:
    program = """
import sys, threading, fovea
from pathlib import Path
def camera():
    color, depth = (Path(file).read_bytes() for file in sys.argv[2:])
    yield fovea.Frame(color, depth, fovea.CameraIntrinsics(262.5, 262.5, 159.5, 119.5))
    threading.Event().wait()
for answer in fovea.Client(sys.argv[1], timeout=60).stream(camera()):
    print(len(answer.detections.objects))
    break
"""
    finished = subprocess.run(
        [sys.executable, "-c", program, server.address, scene.color_file, scene.depth_file],
        env=os.environ,
        timeout=PATIENCE,
        check=True,
        capture_output=True,
        text=True,
    )
    assert int(finished.stdout) >= 3


def test_a_program_ends_though_its_stream_waits(server: ServerProcess, scene: Scene) -> None:
    program = """
import sys, threading, fovea
from pathlib import Path
def camera():
    color, depth = (Path(file).read_bytes() for file in sys.argv[2:])
    yield fovea.Frame(color, depth, fovea.CameraIntrinsics(262.5, 262.5, 159.5, 119.5))
    threading.Event().wait()
answered = threading.Event()
def work():
    for answer in fovea.Client(sys.argv[1], timeout=60).stream(camera()):
        answered.set()
threading.Thread(target=work, daemon=True).start()
answered.wait()
"""
    command = [sys.executable, "-c", program, server.address, scene.color_file, scene.depth_file]
    subprocess.run(command, env=os.environ, timeout=PATIENCE, check=True)


def test_a_camera_that_ends_its_thread_ends_the_stream(client: fovea.Client, scene: Scene) -> None:
    def camera() -> Iterator[fovea.Frame]:
        yield scene.frame()
        sys.exit("no more")

    answers = client.stream(camera())
    assert next(answers).detections
    with pytest.raises(SystemExit, match="no more"):
        next(answers)
