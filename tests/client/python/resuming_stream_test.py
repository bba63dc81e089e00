"""Streams whose server is killed in the middle, and comes back or does not."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from threading import Event

import pytest
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea

PERSISTENT = fovea.RetryOptions(max_attempts=1000, backoff=0.001, max_backoff=0.02)


def numbered(scene: Scene) -> Iterator[fovea.Frame]:
    return (scene.frame(id=str(number)) for number in itertools.count())


def test_outlives_its_server_and_counts_what_was_lost(scene: Scene) -> None:
    no_masks = fovea.DetectOptions(return_masks=False)
    server = ServerProcess()
    with fovea.Client(server.address, timeout=PATIENCE, retry=PERSISTENT) as client:
        answers = client.stream(numbered(scene), no_masks)
        last = next(answers)
        for _ in range(3):
            server.kill()
            server = ServerProcess(address=server.address)
            num_lost = 0
            while num_lost == 0:  # some answers had come before
                answer = next(answers)
                num_lost += answer.lost
                # Each frame is answered, dropped or lost.
                assert answer.sequence == last.sequence + answer.dropped + answer.lost + 1
                assert answer.frame_id == str(answer.sequence)
                assert answer.detections.objects[0].mask is None  # the options hold
                last = answer
        answers.close()
    server.kill()


def test_nothing_of_a_recording_is_lost(scene: Scene) -> None:
    restarted: list[Future[ServerProcess]] = []

    def recording() -> Iterator[fovea.Frame]:
        for number in range(6):
            if number == 2:  # sent before the stream is seen to be broken, or after
                server.kill()
                restarted.append(threads.submit(ServerProcess, address=server.address))
            if number == 4:  # under way when its server dies
                restarted[0].result().freeze()
                restarted.append(threads.submit(restart_once_more))
            yield scene.frame(id=str(number))

    def restart_once_more() -> ServerProcess:
        restarted[0].result().kill()
        return ServerProcess(address=server.address)

    server = ServerProcess()
    with (
        ThreadPoolExecutor() as threads,
        fovea.Client(server.address, timeout=PATIENCE, retry=PERSISTENT) as client,
    ):
        answers = list(client.stream(recording(), every_frame=True))
        restarted[1].result().kill()
    for number, answer in enumerate(answers):
        assert (answer.frame_id, answer.sequence, answer.lost) == (str(number), number, 0)
        assert answer.detections
    assert len(answers) == 6


def test_a_frame_that_comes_late_goes_to_the_new_server(scene: Scene) -> None:
    go_on = Event()

    def camera() -> Iterator[fovea.Frame]:
        yield scene.frame(id="early")
        go_on.wait(PATIENCE)
        yield scene.frame(id="late")

    server = ServerProcess()
    with (
        fovea.Client(server.address, timeout=PATIENCE, retry=PERSISTENT) as client,
        ThreadPoolExecutor() as threads,
    ):
        answers = client.stream(camera())
        assert next(answers).frame_id == "early"
        server.kill()
        server = ServerProcess(address=server.address)
        late = threads.submit(next, answers)
        while client.get_statistics().streams == 0:
            pass
        go_on.set()
        assert (late.result().frame_id, late.result().sequence, late.result().lost) == (
            "late",
            1,
            0,
        )
        assert list(answers) == []
    server.kill()


def test_gives_up_in_the_end(scene: Scene) -> None:
    with ServerProcess() as server, fovea.Client(server.address, retry=PERSISTENT) as client:
        client.wait_until_ready(PATIENCE)
        answers = client.stream(numbered(scene), every_frame=True, timeout=PATIENCE)
        next(answers)
        server.kill()
        impatient = client.stream(numbered(scene), timeout=0.2)
        with pytest.raises(fovea.Unavailable):
            next(impatient)
        answers.close()


def test_is_not_opened_again_where_nothing_is_to_be_repeated(scene: Scene) -> None:
    once = fovea.RetryOptions(max_attempts=1)
    with ServerProcess() as server, fovea.Client(server.address, retry=once) as client:
        answers = client.stream(numbered(scene), timeout=PATIENCE)
        next(answers)
        server.kill()
        with pytest.raises(fovea.Unavailable):
            for _ in answers:
                pass


def test_says_so_where_the_last_frames_are_lost(scene: Scene) -> None:
    answered = Event()
    # Is on its way as a whole although nobody reads it, so that the camera is asked for the next.
    small = scene.frame(color=scene.color[:60, :80], depth=scene.depth[:60, :80])

    def camera() -> Iterator[fovea.Frame]:
        yield scene.frame()
        answered.wait(PATIENCE)
        server.freeze()
        yield small
        server.kill()

    with ServerProcess() as server, fovea.Client(server.address, retry=PERSISTENT) as client:
        answers = client.stream(camera(), timeout=PATIENCE)
        next(answers)
        answered.set()
        with pytest.raises(fovea.Unavailable):
            next(answers)


def test_closing_the_client_ends_the_wait_for_a_server(scene: Scene) -> None:
    forever = fovea.RetryOptions(backoff=PATIENCE, max_backoff=PATIENCE)
    server = ServerProcess()
    client = fovea.Client(server.address, timeout=10 * PATIENCE, retry=forever)
    with ThreadPoolExecutor() as threads:
        answers = client.stream(numbered(scene))
        next(answers)
        server.kill()
        rest = threads.submit(list, answers)
        client.close()
        with pytest.raises(fovea.Cancelled):
            rest.result(PATIENCE / 4)
