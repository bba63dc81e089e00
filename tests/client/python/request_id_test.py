"""By what operators find the requests of robots in the log."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea


@contextmanager
def logging_to(path: Path) -> Iterator[fovea.Client]:
    """A client of a server whose log is whole afterwards."""
    with path.open("w") as file, ServerProcess(log=file) as server:
        with fovea.Client(server.address, timeout=PATIENCE) as client:
            yield client
        server.stop()


def detect_nothing(client: fovea.Client, scene: Scene, request_id: str = "") -> fovea.FoveaError:
    with pytest.raises(fovea.InvalidArgument) as caught:
        client.detect_frame(scene.frame(gravity=(0, 2, 0)), request_id=request_id)
    return caught.value


def test_an_id_of_the_callers_choice_stands_in_log_and_error(tmp_path: Path, scene: Scene) -> None:
    with logging_to(tmp_path / "log") as client:
        error = detect_nothing(client, scene, "pick of 17")
        client.detect(scene.color, scene.depth, scene.intrinsics, request_id="place")
        frames = [scene.frame(id="f1"), scene.frame(id="f2", gravity=(0, 2, 0))]
        good, bad = client.stream(frames, every_frame=True, request_id="stream-1")
    assert good.detections
    assert bad.error and bad.error.request_id == "stream-1"
    assert error.request_id == "pick of 17"
    assert str(error).endswith(" (request pick of 17)")
    assert "request" not in error.message
    lines = (tmp_path / "log").read_text().splitlines()
    assert any('request="pick of 17"' in line and "INVALID_ARGUMENT" in line for line in lines)
    assert any('request="place"' in line and "code=OK" in line for line in lines)
    assert any('request="stream-1"' in line and 'frame="f1"' in line for line in lines)


def test_an_id_that_the_server_made_up_stands_in_the_error(tmp_path: Path, scene: Scene) -> None:
    with logging_to(tmp_path / "log") as client:
        error = detect_nothing(client, scene)
        (answer,) = client.stream([scene.frame(id="f1", gravity=(0, 2, 0))])
    assert error.request_id.isdecimal()
    assert str(error) == f"{error.code}: {error.message} (request {error.request_id})"
    log = (tmp_path / "log").read_text()
    assert f'request="{error.request_id}"' in log
    assert answer.error and answer.error.request_id != error.request_id
    assert f'request="{answer.error.request_id}" robot="ipv4:127.0.0.1" frame="f1"' in log


def test_the_callers_id_is_known_where_no_answer_comes(scene: Scene) -> None:
    with ServerProcess() as server, fovea.Client(server.address, timeout=PATIENCE) as client:
        client.check()
        server.freeze()
        with pytest.raises(fovea.DeadlineExceeded) as late:
            client.detect_frame(scene.frame(), timeout=0.1, request_id="late")
        stream = client.stream([scene.frame()], timeout=0.1, request_id="late stream")
        with pytest.raises(fovea.DeadlineExceeded) as late_stream:
            next(stream)
    assert late.value.request_id == "late"
    assert late_stream.value.request_id == "late stream"


def test_ids_that_cannot_travel_are_refused(client: fovea.Client, scene: Scene) -> None:
    for name, field in (("request_id", "fovea-request-id"), ("traceparent", "traceparent")):
        with pytest.raises(fovea.InvalidArgument) as caught:
            client.detect_frame(scene.frame(), **{name: "küche"})
        assert caught.value.field == f"metadata {field}"


def test_ids_that_the_server_would_refuse_are_not_sent(client: fovea.Client, scene: Scene) -> None:
    refused = (
        "INVALID_ARGUMENT: metadata fovea-request-id: request_id has 65 characters, more than 64"
    )
    with pytest.raises(fovea.InvalidArgument) as caught:
        client.detect_frame(scene.frame(), request_id="x" * 65)
    assert str(caught.value) == refused
    with pytest.raises(fovea.InvalidArgument) as caught:
        client.stream([scene.frame()], request_id="x" * 65)
    assert str(caught.value) == refused
    assert client.detect_frame(scene.frame(), request_id="x" * 64).objects
