"""Deadlines, servers that are away, stop or have too much to do; many threads."""

from __future__ import annotations

import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from threading import Event
from typing import Any

import pytest
from comparison import assert_same
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea
import fovea.retry

ONCE = fovea.RetryOptions(max_attempts=1)
PERSISTENT = fovea.RetryOptions(max_attempts=100_000)


def test_says_what_the_server_is_and_has_done(client: fovea.Client, scene: Scene) -> None:
    info = client.check()
    assert info.version == fovea.__version__  # built from the same sources
    assert info.profiles == ["default", "paper"]
    assert info.max_pixels >= 640 * 480

    before = client.get_statistics()
    found = client.detect_frame(scene.frame())
    after = client.get_statistics()
    assert after.frames_answered["OK"] == before.frames_answered.get("OK", 0) + 1
    assert after.objects == before.objects + len(found.objects)
    assert after.stages["decode"].count == after.frames_answered["OK"]
    assert after.uptime_ms > before.uptime_ms
    assert (found.server_version, found.server_build) == (info.version, info.build)


def test_lists_the_options(client: fovea.Client) -> None:
    gamma = next(each for each in client.list_options() if each.name == "mrf.gamma_per_m2")
    assert (gamma.unit, gamma.minimum, gamma.maximum, gamma.integral) == ("1/m2", 0.1, 10000, False)
    assert gamma.defaults["paper"] == 180
    assert gamma.description.startswith("Eq. 5")


def test_says_which_options_the_operator_has_fixed() -> None:
    with ServerProcess("--option", "mrf.lambda=7") as server:
        with fovea.Client(server.address, timeout=PATIENCE) as client:
            fixed = [each.name for each in client.list_options() if each.fixed]
    assert fixed == ["mrf.lambda"]


def test_asks_for_health(server: ServerProcess) -> None:
    with fovea.Client(server.address) as client:
        client.wait_until_ready(PATIENCE)
        assert client.is_serving()


def test_asks_no_proxy(server: ServerProcess, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("http_proxy", "http://127.0.0.1:1")
    monkeypatch.setenv("no_proxy", "")
    with fovea.Client(server.address) as client:
        assert client.is_serving()


def test_refuses_another_version(client: fovea.Client, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fovea.server_info.require_same_version, "__defaults__", ("9.0.0",))
    with pytest.raises(fovea.VersionMismatch, match="this library is 9.0.0"):
        client.check()


def test_check_says_soon_that_no_server_is_there() -> None:
    with ServerProcess() as gone:
        address = gone.address
    with fovea.Client(address, timeout=PATIENCE) as client:
        with pytest.raises(fovea.Unavailable, match=f"no server answers at {address}"):
            client.check()
    with pytest.raises(fovea.InvalidArgument, match='address: "localhost" is not HOST:PORT'):
        fovea.Client("localhost")


def test_says_that_no_server_is_there(scene: Scene) -> None:
    with ServerProcess() as gone:
        address = gone.address
    with fovea.Client(address, retry=ONCE) as client:
        for call in (client.is_serving, client.get_statistics):
            with pytest.raises(fovea.Unavailable):
                call()
        with pytest.raises(fovea.Unavailable):
            client.detect_frame(scene.frame())
        with pytest.raises(fovea.Unavailable):
            list(client.stream([scene.frame()]))
        with pytest.raises(fovea.DeadlineExceeded):
            client.check(timeout=0.05)


def test_every_call_has_a_deadline(scene: Scene) -> None:
    with ServerProcess() as server, fovea.Client(server.address, timeout=0.05) as client:
        client.wait_until_ready(PATIENCE)
        server.freeze()
        for call in (
            client.is_serving,
            client.get_server_info,
            lambda: client.detect_frame(scene.frame()),
            lambda: client.detect_frame(scene.frame(), timeout=0.01),
            lambda: client.wait_until_ready(),
            lambda: list(client.stream([scene.frame()])),
        ):
            with pytest.raises(fovea.DeadlineExceeded) as caught:
                call()
            assert isinstance(caught.value, TimeoutError)
            assert server.address in caught.value.message
            assert re.search(r" (within|for) 0\.0[51] s", caught.value.message)
        server.thaw()
        client.detect_frame(scene.frame(), timeout=PATIENCE)


@pytest.mark.parametrize("timeout", [None, 0, -1, float("nan"), float("inf"), "5"])
def test_names_a_timeout_that_is_none(timeout: Any) -> None:
    with pytest.raises(
        fovea.InvalidArgument, match="^INVALID_ARGUMENT: timeout: .* is not a number"
    ):
        fovea.Client("127.0.0.1:1", timeout=timeout)


def test_names_the_timeout_of_a_call(client: fovea.Client, scene: Scene) -> None:
    for timeout in (float("nan"), float("inf"), "5"):
        with pytest.raises(fovea.InvalidArgument, match="^INVALID_ARGUMENT: timeout: "):
            client.detect_frame(scene.frame(), timeout=timeout)
    # As of a budget that others have used up.
    for call in (
        lambda: client.detect_frame(scene.frame(), timeout=0),
        lambda: client.check(timeout=-0.5),
        lambda: client.stream([scene.frame()], timeout=0),
    ):
        with pytest.raises(fovea.DeadlineExceeded, match="timeout=.*: no time is left"):
            call()
    for timeout in (1e15, 10**400):  # longer than gRPC has numbers, and longer than a float
        assert client.detect_frame(scene.frame(), timeout=timeout).objects


def test_calls_are_made_again_until_the_server_is_back(
    scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    with ServerProcess() as server:
        address = server.address
    failed = Event()
    backoff_after = fovea.retry.backoff_after

    def observed(*arguments: Any) -> float:
        failed.set()
        return backoff_after(*arguments)

    monkeypatch.setattr(fovea.retry, "backoff_after", observed)
    with fovea.Client(address, retry=PERSISTENT, timeout=PATIENCE) as client:
        with ThreadPoolExecutor() as threads:
            answer = threads.submit(client.detect_frame, scene.frame())
            assert failed.wait(PATIENCE)
            with ServerProcess(address=address):
                assert answer.result().objects


def test_a_client_outlives_its_server(scene: Scene) -> None:
    with ServerProcess() as server:
        client = fovea.Client(server.address, retry=PERSISTENT, timeout=PATIENCE)
        expected = client.detect_frame(scene.frame())
    with client, ServerProcess(address=server.address):
        assert_same(client.detect_frame(scene.frame()), expected)


def test_what_is_wrong_is_not_sent_again(server: ServerProcess, scene: Scene) -> None:
    with fovea.Client(server.address, retry=PERSISTENT, timeout=PATIENCE) as client:
        before = client.get_statistics().frames_answered.get("INVALID_ARGUMENT", 0)
        with pytest.raises(fovea.InvalidArgument):
            client.detect_frame(scene.frame(gravity=[0, 2, 0]))
        assert client.get_statistics().frames_answered["INVALID_ARGUMENT"] == before + 1


def test_a_server_with_too_much_to_do_says_when_to_come_back(scene: Scene) -> None:
    flags = ("--compute-threads", "1", "--max-waiting", "0")
    with ServerProcess(*flags) as server, ThreadPoolExecutor(8) as threads:
        with fovea.Client(server.address, retry=ONCE, timeout=PATIENCE) as impatient:
            error: BaseException | None = None
            while error is None:  # until two meet, which is all but certain at once
                calls = [threads.submit(impatient.detect_frame, scene.frame()) for _ in range(8)]
                error = next(filter(None, [call.exception() for call in calls]), None)
            assert isinstance(error, fovea.Overloaded)
            assert error.retry_after > 0
        with fovea.Client(server.address, retry=PERSISTENT, timeout=PATIENCE) as patient:
            calls = [threads.submit(patient.detect_frame, scene.frame()) for _ in range(8)]
            assert all(call.result().objects for call in calls)


def test_who_is_told_when_to_come_back_goes_on_until_its_timeout(server: ServerProcess) -> None:
    servers = fovea.servers.Servers(server.address, None, 64, [])
    waits: list[float] = []

    def call(refusals: int, retry: fovea.RetryOptions, timeout: float = PATIENCE) -> int:
        waits.clear()

        def refused_at_first(*_: Any) -> int:
            if len(waits) < refusals:
                raise fovea.Overloaded("full", retry_after=0.5)
            return 7

        def wait(_: Any, seconds: float) -> None:
            waits.append(seconds)

        return fovea.retry.call_with_retries(servers, refused_at_first, timeout, retry, wait)

    assert call(20, fovea.RetryOptions()) == 7
    assert waits == [0.5] * 20
    for retry, timeout in ((ONCE, PATIENCE), (fovea.RetryOptions(), 0.4)):
        with pytest.raises(fovea.Overloaded):
            call(20, retry, timeout)
        assert not waits


def test_waits_double_within_their_bounds() -> None:
    options = fovea.RetryOptions(backoff=0.1, max_backoff=1)
    for attempt, most in [(1, 0.1), (2, 0.2), (3, 0.4), (5, 1), (10_000, 1)]:
        for _ in range(20):
            assert most / 2 <= fovea.retry.backoff_after(attempt, options, None) <= most
    assert fovea.retry.backoff_after(9, options, 7) == 7


def test_one_client_serves_many_threads(scene: Scene) -> None:
    with ServerProcess() as server, ThreadPoolExecutor(6) as threads:
        with fovea.Client(server.address, retry=PERSISTENT, timeout=PATIENCE) as client:
            expected = client.detect_frame(scene.frame())
            calls = [threads.submit(client.detect_frame, scene.frame()) for _ in range(12)]
            streams = [
                threads.submit(list, client.stream([scene.frame()] * 2, every_frame=True))
                for _ in range(2)
            ]
            for call in calls:
                assert_same(call.result(), expected)
            for stream in streams:
                for answer in stream.result():
                    assert_same(answer.detections, expected)


def test_a_closed_client_makes_no_calls(server: ServerProcess, scene: Scene) -> None:
    with fovea.Client(server.address) as client:
        client.get_server_info()
    for call in (
        client.is_serving,
        client.wait_until_ready,
        client.get_server_info,
        lambda: client.detect_frame(scene.frame()),
        lambda: list(client.stream([scene.frame()])),
    ):
        with pytest.raises(fovea.Cancelled):
            call()


def test_closing_ends_waits_between_attempts() -> None:
    with ServerProcess() as gone:
        address = gone.address
    forever = fovea.RetryOptions(max_attempts=100_000, backoff=PATIENCE, max_backoff=PATIENCE)
    client = fovea.Client(address, timeout=10 * PATIENCE, retry=forever)
    with ThreadPoolExecutor() as threads:
        call = threads.submit(client.get_server_info)
        client.close()
        with pytest.raises(fovea.Cancelled):
            call.result(PATIENCE / 4)


def test_closing_ends_calls_of_other_threads(scene: Scene) -> None:
    with ServerProcess() as server, ThreadPoolExecutor() as threads:
        client = fovea.Client(server.address, timeout=PATIENCE, retry=PERSISTENT)
        client.wait_until_ready()
        server.freeze()
        call = threads.submit(client.detect_frame, scene.frame())
        client.close()
        with pytest.raises(fovea.Cancelled):
            call.result()


def test_a_program_that_closes_no_client_ends() -> None:
    program = """
import fovea
client = fovea.Client("127.0.0.1:1")
try:
    client.get_server_info()
except fovea.Unavailable:
    print("nobody there")
"""
    command = [sys.executable, "-c", program]
    ended = subprocess.run(command, check=True, capture_output=True, text=True, timeout=PATIENCE)
    assert ended.stdout == "nobody there\n"
