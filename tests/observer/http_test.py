"""What HTTP asks of a server, whatever is served."""

from __future__ import annotations

import http.client
from collections.abc import Iterator

import pytest
from processes import OBSERVERS, PATIENCE, Visitor


@pytest.fixture
def connection(visitor: Visitor) -> Iterator[http.client.HTTPConnection]:
    """One that is kept alive."""
    visitor.log_in(OBSERVERS["ann"][0])
    opened = http.client.HTTPConnection(visitor.address, timeout=PATIENCE)
    yield opened
    opened.close()


@pytest.mark.parametrize("path", ["/", "/page.js", "/nothing", "/%zz", "/api/session"])
def test_head_is_get_without_the_body(
    visitor: Visitor, connection: http.client.HTTPConnection, path: str
) -> None:
    answers = []
    for method in ("HEAD", "GET", "HEAD", "GET"):  # each where the one before has ended
        connection.request(method, path, headers=visitor.headers)
        response = connection.getresponse()
        body = response.read()
        assert len(body) == (0 if method == "HEAD" else int(response.headers["Content-Length"]))
        answers.append((response.status, response.headers.items()))
    assert all(answer == answers[0] for answer in answers)


def test_head_of_events_ends(visitor: Visitor, connection: http.client.HTTPConnection) -> None:
    connection.request("HEAD", "/api/events", headers=visitor.headers)
    response = connection.getresponse()
    assert response.read() == b"" and response.headers["Content-Type"] == "text/event-stream"
    connection.request("GET", "/api/session", headers=visitor.headers)
    assert connection.getresponse().status == 200


def test_other_methods_are_told_which_there_are(visitor: Visitor) -> None:
    answer = visitor.ask("PUT", "/", "text")
    assert answer.status == 405 and answer.headers["Allow"] == "GET, HEAD, POST"


@pytest.mark.parametrize("path", ["", "/", "/?a=b", "?a=b", "/index.html"])
@pytest.mark.parametrize("scheme", ["http", "HTTP", "https"])
def test_targets_may_say_the_host(visitor: Visitor, scheme: str, path: str) -> None:
    assert visitor.get(f"{scheme}://{visitor.address}{path}").status == 200


def test_the_host_of_the_target_counts(visitor: Visitor) -> None:
    own = f"http://{visitor.address}/"
    assert visitor.get(own, Host="evil.example").status == 200
    assert visitor.get("http://evil.example/", Host=visitor.address).status == 421
    for target in ("http://", "http:///", "http://localhost:1@evil.example/", "ftp://localhost/"):
        assert visitor.get(target, Host=visitor.address).status == 400
