"""Where servers are."""

from __future__ import annotations

import ipaddress
import re
import socket
from dataclasses import dataclass

from fovea import checks
from fovea.errors import InvalidArgument, Unavailable

_HOST_AND_PORT = re.compile(r"(?:\[(?P<v6>[^\[\]]+)\]|(?P<host>[^:/\s\[\]]+)):(?P<port>[0-9]{1,5})")
_LONGEST_PATH = 107  # bytes that the address of a UNIX socket holds


@dataclass(frozen=True)
class Target:
    """What gRPC connects to."""

    target: str  # "ipv4:10.0.0.1:50051", "ipv6:[::1]:50051", "unix:/run/fovea.sock"
    authority: str  # whom its certificate must name, "detector:50051"; "" = the target


@dataclass(frozen=True)
class Address:
    """Of one server, or of as many as its name stands for."""

    host: str  # a name or a number; "" = a UNIX socket
    port: str
    path: str  # of the socket

    @property
    def is_name(self) -> bool:
        return bool(self.host) and _family(self.host) == ""

    def targets(self) -> list[Target]:
        """Takes as long as the system's resolver. Raises OSError where it finds nothing."""
        if self.path:
            return [Target("unix:" + self.path, "localhost")]
        if not self.is_name:
            return [self._target(self.host, "")]
        found = socket.getaddrinfo(self.host, None, type=socket.SOCK_STREAM)
        return [self._target(str(each[4][0]), f"{self.host}:{self.port}") for each in found]

    def _target(self, number: str, authority: str) -> Target:
        host = f"[{number}]" if _family(number) == "ipv6" else number
        return Target(f"{_family(number)}:{host}:{self.port}", authority)


def parse_addresses(text: str) -> list[Address]:
    """Of HOST:PORT (IPv6 in brackets), unix:/PATH, or several of these with commas between them.
    "ipv4:", "ipv6:" and "dns:///" in front, as gRPC has them, are left out.

    Raises InvalidArgument for anything else.
    """
    return [_parse(each) for each in checks.text(text, "address").split(",")]


def find_targets(addresses: list[Address]) -> list[Target]:
    """All that these stand for, each once. Raises Unavailable where nothing is found."""
    targets: dict[str, Target] = {}
    problem = ""
    for address in addresses:
        try:
            for target in address.targets():
                targets.setdefault(target.target, target)
        except OSError as error:
            problem = f"cannot look up {address.host}: {error.strerror or error}"
    if not targets:
        raise Unavailable("UNAVAILABLE", problem)
    return list(targets.values())


def _parse(text: str) -> Address:
    if text.startswith("unix:") and len(text) > len("unix:"):
        return Address("", "", _checked_path(re.sub("^///", "/", text[len("unix:") :])))
    rest = text
    for scheme in ("dns:///", "dns:", "ipv4:", "ipv6:"):
        if text.startswith(scheme):
            rest = text[len(scheme) :]
            break
    found = _HOST_AND_PORT.fullmatch(rest)
    if found and 1 <= int(found["port"]) <= 65535:
        if not found["v6"] or _family(found["v6"]) == "ipv6":
            return Address(found["v6"] or found["host"], found["port"], "")
    raise InvalidArgument(
        "address",
        f'"{text}" is not HOST:PORT with a port of 1 to 65535, for example 127.0.0.1:50051 or '
        "[::1]:50051, and not unix:/PATH",
    )


def _checked_path(path: str) -> str:
    size = len(path.encode())
    if size > _LONGEST_PATH:
        problem = f'the path "{path}" has {size} bytes, a UNIX socket\'s at most {_LONGEST_PATH}'
        raise InvalidArgument("address", problem)
    return path


def _family(host: str) -> str:
    """ "ipv4" or "ipv6"; "" of a name."""
    try:
        return f"ipv{ipaddress.ip_address(host).version}"
    except ValueError:
        return ""
