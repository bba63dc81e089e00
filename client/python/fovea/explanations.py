"""What a person should read where no call gets through: gRPC's own text names no remedy."""

from __future__ import annotations

from fovea.errors import DeadlineExceeded, FoveaError
from fovea.options import TlsOptions

_CLOSES = "{} closes the connection; does the server want {}?"
_CERTIFICATE = "a certificate (certificate_chain and private_key of tls)"
_NO_FOVEA_SERVER = "what answers at {} is no fovea-server"
_KEY = "private_key of tls is not the key, in PEM, of its certificate_chain? {} was not called"


def why_unavailable(problem: str, address: str, tls: TlsOptions | None) -> str:
    """With gRPC's own words behind it. These are those of gRPC 1.51 and OpenSSL 3; others get the
    last answer."""
    return f"{_why(problem, address, tls)}: {problem}"


def of_server(error: FoveaError, address: str, seconds: float) -> FoveaError:
    """A deadline that passed, of which gRPC says neither who did not answer nor for how long; other
    errors as they are."""
    if not isinstance(error, DeadlineExceeded) or error.message != "Deadline Exceeded":
        return error
    named = DeadlineExceeded("DEADLINE_EXCEEDED", f"no answer from {address} within {seconds:g} s")
    named.request_id = error.request_id
    return named


def _why(problem: str, address: str, tls: TlsOptions | None) -> str:
    if "Socket closed" in problem and tls is None:
        return _CLOSES.format(address, "TLS (tls=fovea.TlsOptions(…))")
    if "Socket closed" in problem and tls is not None and not tls.certificate_chain:
        return _CLOSES.format(address, _CERTIFICATE)
    if "wrong version number" in problem:
        return f"{address} does not speak TLS; leave tls out?"
    if "Failed parsing HTTP/2" in problem or "missing selected ALPN" in problem:
        return _NO_FOVEA_SERVER.format(address)
    if "certificate verify failed" in problem:
        return f"root_certificates of tls do not certify the server at {address}"
    if "is not in peer certificate" in problem:
        return (
            f"the certificate of the server at {address} is for other names; call it by one of them"
        )
    if "empty address list" in problem and tls is not None and tls.private_key:
        return _KEY.format(address)
    return f"no server answers at {address}"
