#!/usr/bin/env python3
"""What watching costs, and how soon pictures are there. Not a test: other programs of the machine
count as well.

usage: measure.py BUILD_FOLDER [pixels] [cost] [stalled] [many]
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

BUILD = Path(sys.argv[1]).resolve()
os.environ["FOVEA_SERVER"] = str(BUILD / "server/fovea-server")
os.environ["FOVEA_OBSERVER"] = str(BUILD / "client/observer/fovea-observer")
sys.path.insert(0, str(BUILD / "client/python/package"))

import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from processes import (  # noqa: E402
    OBSERVERS,
    PATIENCE,
    Events,
    ObserverProcess,
    ServerProcess,
    Visitor,
    write_observers,
)

import fovea  # noqa: E402

TOKEN = OBSERVERS["ann"][0]


def make_frame(folder: Path, size: str = "640x480", focal: float = 525) -> fovea.Frame:
    tool = str(BUILD / "tests/support/fovea-scenes")
    command = [tool, "--output", str(folder), "--kind", "household", "--size", size]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    color, depth = (
        np.array(Image.open(folder / f"household_1_{n}.png")) for n in ("color", "depth")
    )
    height, width = depth.shape
    camera = fovea.CameraIntrinsics(focal, focal, (width - 1) / 2, (height - 1) / 2)
    return fovea.Frame(color=color, depth=depth.astype(np.uint16), intrinsics=camera)


class Sender:
    """Robots that send a frame, wait for the answer and some time."""

    def __init__(self, address: str, names: list[str], frame: fovea.Frame, pause: float) -> None:
        self.stop = threading.Event()
        self.threads = [
            threading.Thread(target=self.run, args=(address, name, frame, pause)) for name in names
        ]
        for thread in self.threads:
            thread.start()

    def run(self, address: str, name: str, frame: fovea.Frame, pause: float) -> None:
        with fovea.Client(address, robot=name, timeout=PATIENCE) as client:
            while not self.stop.wait(pause):
                try:
                    client.detect_frame(frame)
                except fovea.FoveaError:
                    pass  # too many at once

    def __enter__(self) -> Sender:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop.set()
        for thread in self.threads:
            thread.join()


def memory_mib(pid: int) -> float:
    lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM")) / 1024


def lists(url: str, stop: threading.Event, waits: list[float] | None = None) -> None:
    """A page of all robots: what is new, and the pictures of that."""
    visitor = Visitor(url.split("/")[2])
    visitor.log_in(TOKEN)
    with Events(visitor) as events:
        while not stop.is_set():
            for robot in events.next()["robots"]:
                begun = time.monotonic()
                visitor.get(f"/api/preview?robot={robot['robot']}&id={robot['id']}")
                if waits is not None:
                    waits.append(time.monotonic() - begun)


def pixels(server: ServerProcess, frame: fovea.Frame) -> None:
    from browser import Browser

    script = """
    window.waits = [];
    const canvas = document.querySelector("#picture");
    new MutationObserver(() => {
      const answered = Number(canvas.dataset.answeredAt);
      requestAnimationFrame(() => requestAnimationFrame(() => window.waits.push(Date.now() - answered)));
    }).observe(canvas, {attributes: true, attributeFilter: ["data-answered-at"]});
    """
    with ObserverProcess(server.address) as observer, Sender(server.address, ["arm"], frame, 0.3):
        browser = Browser()
        browser.driver.get(observer.url)
        begun = time.monotonic()
        browser.find("#token").send_keys(TOKEN + "\n")
        browser.find("[data-robot=arm] canvas[data-id]")
        print(
            f"first picture {time.monotonic() - begun:.2f} s after the token, a frame each 0.3 s + answer"
        )
        browser.find("[data-robot=arm] button").click()
        browser.find("#picture[data-id]")
        browser.driver.execute_script(script)
        time.sleep(40)
        waits = browser.driver.execute_script("return window.waits")
        browser.close()
    shares = np.percentile(waits, [50, 95])
    print(
        f"answer to pixel: median {shares[0]:.0f} ms, p95 {shares[1]:.0f} ms, of {len(waits)} frames"
    )


def cost(server: ServerProcess, frame: fovea.Frame) -> None:
    times: dict[str, list[float]] = {"without": [], "with 10": []}
    with ObserverProcess(server.address) as observer:
        os.setpriority(os.PRIO_PROCESS, observer.pid, 10)
        with fovea.Client(server.address, robot="arm", timeout=PATIENCE) as client:
            for _ in range(10):
                for kind, took in times.items():
                    stop = threading.Event()
                    count = 10 if kind == "with 10" else 0
                    readers = [
                        subprocess.Popen(
                            [sys.executable, __file__, str(BUILD), "--read", observer.url]
                        )
                        for _ in range(count)
                    ]
                    time.sleep(
                        3 if count else 6
                    )  # until they have begun; until the others have gone
                    for _ in range(30):
                        begun = time.monotonic()
                        client.detect_frame(frame)
                        took.append(time.monotonic() - begun)
                    stop.set()
                    for reader in readers:
                        reader.kill()
                        reader.wait()
    for kind, took in times.items():
        shares = 1000 * np.percentile(took, [50, 90, 99])
        print(
            f"{kind}: median {shares[0]:.1f}, p90 {shares[1]:.1f}, p99 {shares[2]:.1f} ms of {len(took)}"
        )


def stalled(server: ServerProcess, frame: fovea.Frame) -> None:
    with ObserverProcess(server.address) as observer:
        visitor = Visitor(observer.address)
        visitor.log_in(TOKEN)
        host, port = observer.address.split(":")
        with Sender(server.address, ["arm"], frame, 0.2):
            for count in (0, 50):
                sockets = []
                for _ in range(count):  # each asks for much and reads nothing
                    opened = socket.create_connection((host, int(port)))
                    opened.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
                    for path in 20 * ["/page.js"] + ["/api/events?close=arm&depth=1"]:
                        text = f"GET {path} HTTP/1.1\r\nHost: {observer.address}\r\n"
                        opened.sendall(
                            (text + f"Cookie: {visitor.headers['Cookie']}\r\n\r\n").encode()
                        )
                    sockets.append(opened)
                waits: list[float] = []
                stop = threading.Event()
                reader = threading.Thread(target=lists, args=(observer.url, stop, waits))
                reader.start()
                time.sleep(15)
                stop.set()
                reader.join()
                for opened in sockets:
                    opened.close()
                print(
                    f"{count} stalled: a healthy one waits {1000 * max(waits):.1f} ms at most, of {len(waits)} previews"
                )


def many(server: ServerProcess, folder: Path) -> None:
    frame = make_frame(folder, "320x240", 262.5)
    names = [f"robot-{i:03}" for i in range(500)]
    with fovea.Client(server.address, robot="first", timeout=PATIENCE) as client:
        for _ in range(20):
            client.detect_frame(frame)
    round_of(server, frame, names)
    round_of(server, frame, names)
    before = memory_mib(server.pid)
    with ObserverProcess(server.address) as observer:
        stop = threading.Event()
        reader = threading.Thread(target=lists, args=(observer.url, stop))
        reader.start()
        begun = time.monotonic()
        for _ in range(3):
            round_of(server, frame, names)
        seconds = time.monotonic() - begun
        after, page = memory_mib(server.pid), memory_mib(observer.pid)
        stop.set()
        round_of(server, frame, names[:1])
        reader.join()
    print(
        f"500 robots: server {before:.0f} MiB without, {after:.0f} MiB with an observer, which had"
        f" {page:.0f} MiB; 1500 frames in {seconds:.0f} s"
    )


def round_of(server: ServerProcess, frame: fovea.Frame, names: list[str]) -> None:
    """A frame of each robot: as many at once as there are processors. One after the other took
    longer than anybody waited, since each opens a connection of its own."""

    def detect(name: str) -> None:
        with fovea.Client(server.address, robot=name, timeout=PATIENCE) as client:
            client.detect_frame(frame)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(detect, names))


def main() -> None:
    if "--read" in sys.argv:
        os.nice(19)
        lists(sys.argv[-1], threading.Event())
        return
    what = sys.argv[2:] or ["pixels", "cost", "stalled", "many"]
    folder = Path(tempfile.mkdtemp())
    frame = make_frame(folder)
    jobs: dict[str, Any] = {"pixels": pixels, "cost": cost, "stalled": stalled}
    for name in what:
        with ServerProcess(write_observers(folder)) as server:
            many(server, folder) if name == "many" else jobs[name](server, frame)


if __name__ == "__main__":
    main()
