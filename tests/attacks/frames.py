"""Frames that cost much, and frames that are worth little."""

from __future__ import annotations

from functools import cache
from itertools import cycle

from http2 import DETECT, call, is_end, message
from protobuf import noisy_request, option, profile
from target import PATIENCE, Tally, Target, attack, rounds

# The most that the stages of each profile can be asked for.
EXTREMES = {
    "default": {
        "depth_fill.passes": 10,
        "seeds.disk_radius_px": 0,
        "support.max_surfaces": 16,
        "support.min_area_m2": 0,
        "voxels.size_m": 0.003,
        "cover.spacing_m": 0.001,
        "mrf.gamma_per_m2": 0.1,
        "mrf.max_sweeps": 100,
        "mrf.cluster_voxels": 1,
    },
    "paper": {
        "color_saliency.num_scales": 8,
        "depth_saliency.line_step_px": 1,
        "depth_saliency.line_length": 1,
        "normals.window_radius_px": 15,
        "gravity.window_radius_px": 15,
        "gravity.step_px": 1,
        "gravity.num_starts": 9,
        "depth_fill.passes": 10,
        "voxels.size_m": 0.003,
        "mrf.max_sweeps": 100,
    },
}


CHUNK = 1 << 17
TEXTS = {  # of refusals, by what they are counted as
    "cut off": b"--max-compute-ms",
    "not allowed": b"lets no request set it",
    "no room": b"retry-after-ms",
}


@cache
def extreme_bodies() -> list[bytes]:
    frame = noisy_request()
    return [
        message(frame + profile(name) + b"".join(option(*each) for each in options.items()))
        for name, options in EXTREMES.items()
    ]


@attack("bytes", setups=("open",))
def extreme_options(target: Target) -> Tally:
    """Frames of 1920x1080 with options that are valid and cost the most, one after the other"""
    tally: Tally = Tally()
    for survived, body in zip(rounds(target, tally), cycle(extreme_bodies())):
        with survived, target.connect() as connection:
            stream, sent, ended = connection.next_stream(), 0, False
            connection.send(call(DETECT, stream))
            while not ended and target.goes_on():
                part = body[sent : sent + CHUNK]
                some = connection.send_data(stream, part, end=sent + len(part) == len(body))
                sent += some
                tally["bytes"] += some
                for kind, flags, of, payload in connection.receive(0.01):
                    for what, text in TEXTS.items():
                        tally[what] += text in payload
                    ended |= of == stream and is_end(kind, flags)
    return tally


@attack("answered", setups=("open",))
def log_flood(target: Target) -> Tally:
    """Frames of 16x40, each of which makes a line in the log, by a name that is long"""
    tally: Tally = Tally()
    body = message(noisy_request(16, 40))
    for survived in rounds(target, tally):
        with survived, target.connect() as connection:
            said = connection.ask(DETECT, body, PATIENCE, ("fovea-robot", "talkative" * 7))
            tally["answered"] += b"grpc-status" in said
    return tally
