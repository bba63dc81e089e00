"""Several servers: which one is asked, and what happens when it goes."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from threading import Event

import pytest
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea
from fovea.addresses import find_targets, parse_addresses
from fovea.better_server import BetterServer
from fovea.readiness import wait_until_connected
from fovea.server_choice import Ask, ServerChoice, ServerRound
from fovea.servers import Servers

NOW = 3600.0
ONCE = fovea.RetryOptions(max_attempts=1)


@pytest.fixture
def choice() -> ServerChoice:
    choice = ServerChoice(seed=1)
    choice.set_servers(["a", "b"])
    return choice


def other(name: str) -> str:
    return "b" if name == "a" else "a"


def test_all_are_asked_for_room_before_one_keeps_a_place(choice: ServerChoice) -> None:
    home = choice.home(NOW)
    way = ServerRound(choice, asks_others=True)
    assert way.next(NOW) == Ask(home, only_if_room=True)
    way.on_refused(0.1)
    assert way.next(NOW) == Ask(other(home), only_if_room=True)
    way.on_refused(0.1)
    assert way.wait is None
    assert way.next(NOW) == Ask(home)
    way.on_refused(0.11)
    assert way.next(NOW) is None
    assert (way.wait, choice.home(NOW)) == (0.11, home)


def test_every_second_call_that_gets_a_place_asks_all(choice: ServerChoice) -> None:
    for asks_all in (True, False, True, False):
        way = ServerRound(choice, asks_others=True)
        first = way.next(NOW)
        assert first and first.only_if_room == asks_all
        way.on_refused(0.1)
        while way.next(NOW):
            way.on_refused(0.1)
        assert way.wait is not None


def test_moves_to_where_it_is_sooner(choice: ServerChoice) -> None:
    home = choice.home(NOW)
    way = ServerRound(choice, asks_others=True)
    way.next(NOW)
    way.on_refused(0.1)
    way.next(NOW)
    way.on_refused(0.099)
    assert way.next(NOW) == Ask(other(home))  # for a place in line
    way.on_refused(0.105)
    assert way.next(NOW) is None
    assert (way.wait, choice.home(NOW)) == (0.105, other(home))


def test_who_waits_in_line_asks_only_there(choice: ServerChoice) -> None:
    way = ServerRound(choice, asks_others=False)
    assert way.next(NOW) == Ask(choice.home(NOW))
    way.on_refused(0.1)
    assert way.next(NOW) is None


def test_moves_to_whoever_answers_twice_in_a_row(choice: ServerChoice) -> None:
    home = choice.home(NOW)
    for _ in range(2):
        assert choice.home(NOW) == home
        way = ServerRound(choice, asks_others=True)
        way.next(NOW)
        way.on_refused(0.1)
        way.next(NOW)
        way.on_answered()
    assert choice.home(NOW) == other(home)


def test_leaves_who_is_away_for_longer_each_time(choice: ServerChoice) -> None:
    home = choice.home(NOW)
    way = ServerRound(choice, asks_others=True)
    way.next(NOW)
    way.on_away(NOW)
    assert way.next(NOW) == Ask(other(home))
    way.on_away(NOW)
    assert way.next(NOW) is None
    for seconds in (0.2, 0.4, 0.8, 1.6, 3.2, 5.0, 5.0):
        choice.on_away(home, NOW)
        assert choice.is_away(home, NOW + seconds - 0.01)
        assert not choice.is_away(home, NOW + seconds + 0.01)


def test_reads_addresses() -> None:
    def targets(text: str) -> list[str]:
        return [each.target for each in find_targets(parse_addresses(text))]

    assert targets("ipv4:10.0.0.1:5,10.0.0.2:6") == ["ipv4:10.0.0.1:5", "ipv4:10.0.0.2:6"]
    assert targets("[::1]:1,unix:/run/a") == ["ipv6:[::1]:1", "unix:/run/a"]
    assert "ipv4:127.0.0.1:7" in targets("dns:///localhost:7")
    for text in (
        "",
        "localhost",
        "a:1,",
        "a:0",
        "a:65536",
        "::1:5",
        "[x]:5",
        "http://a:1",
        "unix:",
        "localhost:５００５１",
        "127.0.0.1:٥",
    ):
        with pytest.raises(fovea.InvalidArgument, match="is not HOST:PORT"):
            fovea.Client(text)
    for value in (None, b"127.0.0.1:7", "unix:/run/\ud800"):
        with pytest.raises(fovea.InvalidArgument, match="^INVALID_ARGUMENT: address: .* is not "):
            fovea.Client(value)
    with pytest.raises(fovea.Unavailable, match="cannot look up no-such-host.invalid"):
        fovea.Client("no-such-host.invalid:7", retry=ONCE).get_server_info()


def test_names_a_path_longer_than_sockets_have() -> None:
    longest = "/" + "x" * 104 + "é"  # of 107 bytes
    assert find_targets(parse_addresses(f"unix:{longest}"))[0].target == f"unix:{longest}"
    for path in (longest + "x", "//" + longest + "x"):
        with pytest.raises(fovea.InvalidArgument, match="has 108 bytes, .* at most 107") as caught:
            fovea.Client(f"127.0.0.1:7,unix:{path}")
        assert caught.value.field == "address"


def test_calls_and_streams_go_on_elsewhere(scene: Scene) -> None:
    one, two = ServerProcess(), ServerProcess()
    address = f"{one.address},{two.address}"
    with fovea.Client(address, timeout=PATIENCE, retry=ONCE) as client:
        client.wait_until_ready()
        calls = client.detect_frame(scene.frame())
        one.kill()
        for _ in range(5):  # one attempt goes around all servers
            assert len(client.detect_frame(scene.frame()).objects) == len(calls.objects)
    one = ServerProcess(address=one.address)
    with fovea.Client(address, timeout=PATIENCE) as client:
        answers = client.stream((scene.frame() for _ in itertools.count()), every_frame=True)
        next(answers)
        with fovea.Client(one.address) as asking:
            (one if asking.get_statistics().streams else two).kill()
        assert next(answers).sequence == 1
        answers.close()
    one.kill()
    two.kill()


def test_one_frame_is_under_way_also_where_a_stream_went_to_another_server(
    scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    num_answered_before: list[int] = []
    answers: list[fovea.StreamAnswer] = []

    def recording() -> Iterator[fovea.Frame]:
        for number in range(6):
            num_answered_before.append(len(answers))
            yield scene.frame(id=str(number))

    with ServerProcess() as one, ServerProcess() as two:
        with fovea.Client(f"{one.address},{two.address}", timeout=PATIENCE) as client:
            both = client._servers.all(PATIENCE)
            found = iter([None, both[0], both[1]])
            monkeypatch.setattr(BetterServer, "find", lambda *_: next(found, None))
            for answer in client.stream(recording(), every_frame=True):
                answers.append(answer)
    assert num_answered_before == [0, 1, 2, 3, 4, 5]
    assert [answer.frame_id for answer in answers] == [str(number) for number in range(6)]
    assert [(answer.dropped, answer.lost) for answer in answers] == [(0, 0)] * 6


def test_streams_wait_for_whoever_is_connected_first() -> None:
    with ServerProcess() as gone:
        pass
    with ServerProcess() as server:
        servers = Servers(f"{gone.address},{server.address}", None, 1, [])
        for each, seconds in zip(servers.all(PATIENCE), (0.1, PATIENCE)):
            servers.on_away(each, seconds)
        assert servers.home(PATIENCE).name == "ipv4:" + gone.address  # by the times alone
        found = wait_until_connected(servers, Event(), 0, PATIENCE)
        assert found and found.name == "ipv4:" + server.address


def test_one_server_that_is_ready_is_enough() -> None:
    with ServerProcess() as gone:
        pass
    with ServerProcess() as server:
        for address in (f"{gone.address},{server.address}", f"{server.address},{gone.address}"):
            with fovea.Client(address) as client:
                client.wait_until_ready(PATIENCE)
                assert client.is_serving()
                assert client.check().version == fovea.__version__
