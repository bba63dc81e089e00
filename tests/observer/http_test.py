"""What HTTP asks of a server, whatever is served, and what is no HTTP."""

from __future__ import annotations

import http.client
import os
import random
import socket
from collections.abc import Iterator

import pytest
from processes import OBSERVERS, PATIENCE, ObserverProcess, Visitor


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


@pytest.mark.parametrize(
    "text",
    [
        "GET /%zz HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "GET /%00 HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "GET /../../etc/passwd HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "GET /api/answer?robot=%ff&id=99999999999999999999 HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "POST /api/login HTTP/1.1\r\nHost: localhost\r\nOrigin: http://localhost\r\nContent-Length: 4\r\n\r\n[[[[",
        "POST /api/login HTTP/1.1\r\nHost: localhost\r\nContent-Length: 99999999999\r\n\r\n",
        "GET / HTTP/1.1\r\nHost: localhost\r\nX: " + 20000 * "x" + "\r\n\r\n",
        "BREW / HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "\x16\x03\x01 no HTTP at all\r\n\r\n",
    ],
)
def test_hostile_requests_end_nothing(observer: ObserverProcess, text: str) -> None:
    host, port = observer.address.split(":")
    received = b""
    with socket.create_connection((host, int(port)), timeout=PATIENCE) as connection:
        try:
            connection.sendall(text.encode("latin-1"))
            connection.shutdown(socket.SHUT_WR)
            while chunk := connection.recv(4096):
                received += chunk
        except OSError:
            pass  # it has closed the connection in the midst
    assert received == b"" or received.startswith(b"HTTP/1.1 4"), received[:100]
    assert Visitor(observer.address).get("/").status == 200


def requests_to_spoil(visitor: Visitor) -> list[bytes]:
    lines = f"Host: {visitor.address}\r\nCookie: {visitor.headers['Cookie']}\r\n"
    own = f"{lines}Origin: http://{visitor.address}\r\n"
    targets = ["/", "/page.js", "/api/session", "/api/answer?robot=a%20b&id=1", "/api/depth?id=2"]
    gets = [f"GET {target} HTTP/1.1\r\n{lines}\r\n" for target in targets]
    body = '{"token": "none"}'
    login = f"POST /api/login HTTP/1.1\r\n{own}Content-Length: {len(body)}\r\n\r\n{body}"
    chunked = (
        f"POST /api/logout HTTP/1.1\r\n{own}Transfer-Encoding: chunked\r\n\r\n1\r\na\r\n0\r\n\r\n"
    )
    return [text.encode() for text in (*gets, login, chunked)]


def test_spoiled_requests_end_nothing(visitor: Visitor) -> None:
    visitor.log_in(OBSERVERS["ann"][0])
    host, port = visitor.address.split(":")
    good = requests_to_spoil(visitor)
    seed = int(os.environ.get("FOVEA_SEED", "1"))  # another one: other requests
    print("seed", seed)
    chance = random.Random(seed)
    for _ in range(400):
        text = bytearray(chance.choice(good))
        for _ in range(chance.randint(1, 8)):
            at = chance.randrange(len(text))
            spoil = chance.randrange(3)
            if spoil == 0:
                text[at] = chance.randrange(256)
            elif spoil == 1:
                del text[at : at + chance.randint(1, 20)]
            else:
                text[at:at] = bytes(
                    chance.choices(b"%&=?/;:\r\n\0 aZ9\xff", k=chance.randint(1, 20))
                )
            text = text or bytearray(b" ")
        with socket.create_connection((host, int(port)), timeout=PATIENCE) as connection:
            try:
                connection.sendall(text)
                connection.shutdown(socket.SHUT_WR)
                start = connection.recv(12)
            except OSError:  # it has closed the connection in the midst
                start = b""
        assert start == b"" or start.startswith(b"HTTP/1."), start
        assert not start.endswith(b" 500"), bytes(text)
    assert visitor.get("/api/session").status == 200
