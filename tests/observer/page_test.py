"""The page in a real browser: what it shows is what the server answers, where it is."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Robots, Scene
from processes import OBSERVERS, ObserverProcess, ServerProcess, write_observers

import fovea

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import CHROMIUM, DRIVER, Browser  # noqa: E402

pytestmark = pytest.mark.skipif(
    not (CHROMIUM and DRIVER), reason="chromium and chromium-driver are not installed"
)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    opened = Browser()
    yield opened
    opened.close()


class Sending:
    """A robot that sends the same frame again and again, until the end of a test."""

    def __init__(self, robots: Robots, robot: str, frame: fovea.Frame) -> None:
        self.answer = robots.detect(robot, frame, return_masks=True)
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(robots, robot, frame))

    def _run(self, robots: Robots, robot: str, frame: fovea.Frame) -> None:
        while not self._stop.wait(0.05):
            robots.detect(robot, frame)

    def __enter__(self) -> Sending:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join()


@pytest.fixture
def sending(robots: Robots, scene: Scene) -> Iterator[Sending]:
    with Sending(robots, "kitchen-1", scene.frame()) as robot:
        yield robot


@pytest.fixture
def picture(browser: Browser, observer: ObserverProcess, sending: Sending) -> Any:
    """The canvas of the robot that sends, in large, with a frame in it."""
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    browser.find("[data-robot=kitchen-1] button").click()
    return browser.find("#picture[data-id]")


def stop(browser: Browser) -> None:
    """What is shown stays."""
    browser.press("stop")


def masks_of(answer: fovea.Detections, shape: tuple[int, ...]) -> Any:
    labels = np.zeros(shape[:2], int)
    for found in answer.objects:
        labels[found.mask] = found.label
    return labels


def test_a_wrong_token_is_told(browser: Browser, observer: ObserverProcess) -> None:
    browser.log_in(observer.url, "wrong")
    browser.until(lambda: browser.find("#failure").text == "no server knows this token")
    assert not browser.all(".tiles")


def test_a_token_in_the_address_logs_in_and_goes(
    browser: Browser, observer: ObserverProcess
) -> None:
    browser.driver.delete_all_cookies()
    browser.driver.get("about:blank")
    browser.driver.get(f"{observer.url}#token={OBSERVERS['ben'][0]}")
    browser.until(lambda: browser.find("#who").text.startswith("ben"))
    assert "token" not in browser.driver.current_url


def test_robots_are_tiles_with_problems_first(
    browser: Browser, observer: ObserverProcess, robots: Robots, sending: Sending, scene: Scene
) -> None:
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    browser.find("[data-robot=kitchen-1]")
    with Sending(
        robots,
        "zoo",
        scene.frame(color=np.zeros_like(scene.color), depth=np.zeros_like(scene.depth)),
    ) as empty:
        assert not empty.answer.objects
        browser.find("[data-robot=zoo] .problem")
        browser.until(lambda: browser.all(".tiles li")[0].get_attribute("data-robot") == "zoo")
        assert browser.find("[data-robot=zoo] .reason").text
        facts = browser.find("[data-robot=kitchen-1]").text
        assert f"{len(sending.answer.objects)} objects" in facts
        browser.find("[data-robot=kitchen-1] canvas[data-id]")


def test_shows_objects_at_their_pixels(
    browser: Browser, picture: Any, sending: Sending, scene: Scene
) -> None:
    stop(browser)
    for name in ("boxes", "labels"):
        browser.press(name)
    with_masks = browser.pixels(picture)
    browser.press("masks")
    plain = browser.pixels(picture)
    # The picture is the robot's, but for what JPEG does to it.
    assert np.abs(plain[:, :, :3].astype(int) - scene.color).mean() < 6
    shown = (with_masks != plain).any(axis=2)
    wanted = masks_of(sending.answer, shown.shape) > 0
    assert wanted.sum() > 1000
    # A mask's colour may be that of the pixel already.
    assert not (shown & ~wanted).any()
    assert (shown & wanted).sum() > 0.99 * wanted.sum()
    # And these are the things that were put into the scene.
    truth = scene.labels > 0
    assert (shown & truth).sum() > 0.8 * (shown | truth).sum()


def test_hovering_links_table_and_picture(browser: Browser, picture: Any, sending: Sending) -> None:
    stop(browser)
    rows = browser.all("#objects tbody tr")
    assert len(rows) == len(sending.answer.objects)
    labels = masks_of(sending.answer, browser.pixels(picture).shape)
    for found in sending.answer.objects:
        ys, xs = np.nonzero(labels == found.label)
        middle = np.argmin((xs - xs.mean()) ** 2 + (ys - ys.mean()) ** 2)
        height, width = labels.shape
        browser.hover(picture, (xs[middle] + 0.5) / width, (ys[middle] + 0.5) / height)
        chosen = browser.find("#objects tr.chosen")
        assert chosen.get_attribute("data-label") == str(found.label)
    before = browser.pixels(picture)
    browser.driver.execute_script("arguments[0].focus()", rows[0])
    browser.find(f"#objects tr.chosen[data-label='{sending.answer.objects[0].label}']")
    after = browser.pixels(picture)
    changed = (before != after).any(axis=2)
    box = sending.answer.objects[0].bounding_box
    # Its box is drawn thicker, so a pixel farther inwards.
    assert changed[box.y + 2, box.x + 2 : box.x + box.width - 2].mean() > 0.5


def test_points_in_3d_are_where_they_are(
    browser: Browser, picture: Any, sending: Sending, scene: Scene
) -> None:
    browser.press("3D")
    cloud = browser.find("#cloud")
    point = browser.find("#point")
    browser.until(lambda: browser.hover(cloud, 0.5, 0.5) or point.get_attribute("value"))
    stop(browser)
    height, width = scene.depth.shape
    intrinsics = scene.intrinsics
    tried = 0
    # The eye stands where the camera does: a place of the canvas is a pixel of the frame, but the
    # principal point is in the middle.
    for u, v in itertools.product((0.2, 0.35, 0.5, 0.65, 0.8), (0.4, 0.5, 0.6, 0.7, 0.8, 0.9)):
        x = (u - 0.5) * width + intrinsics.cx
        y = (v - 0.5) * height + intrinsics.cy
        near = scene.depth[int(y) - 4 : int(y) + 5, int(x) - 4 : int(x) + 5]
        if near.min() == 0 or near.max() - near.min() > 60:
            continue  # at an edge both sides are right
        z = scene.depth[round(y), round(x)] / 1000
        wanted = [
            (x - intrinsics.cx) / intrinsics.fx * z,
            (y - intrinsics.cy) / intrinsics.fy * z,
            z,
        ]
        browser.hover(cloud, u, v)
        shown = [float(number) for number in point.get_attribute("value").split()[:3]]
        assert np.linalg.norm(np.subtract(shown, wanted)) < 0.01, (shown, wanted)
        tried += 1
    assert tried >= 5


def test_stops_and_steps_by_key(browser: Browser, picture: Any) -> None:
    body = browser.find("body")
    first = int(picture.get_attribute("data-id"))
    browser.until(lambda: int(picture.get_attribute("data-id")) > first)
    body.send_keys(",")  # one back, and stay
    at = int(picture.get_attribute("data-id"))
    body.send_keys(",")
    browser.until(lambda: int(picture.get_attribute("data-id")) <= at)
    back = int(picture.get_attribute("data-id"))
    body.send_keys(".")
    assert int(picture.get_attribute("data-id")) >= back
    body.send_keys(" ")
    browser.until(lambda: int(picture.get_attribute("data-id")) > at)
    body.send_keys("\ue00c")  # Escape
    browser.find(".tiles")


def test_says_in_words_why_little_was_found(
    browser: Browser, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    with Sending(robots, "blind", scene.frame(depth=np.zeros_like(scene.depth))) as blind:
        browser.find("[data-robot=blind] button").click()
        browser.find("#reasons li")
        told = browser.texts("#reasons li")
        assert told == list(blind.answer.diagnostics.messages)


def test_says_what_is_away_and_goes_on(browser: Browser, scene: Scene, tmp_path: Path) -> None:
    observers = write_observers(tmp_path)
    says = lambda text: browser.until(lambda: text in browser.texts("#servers")[0])  # noqa: E731
    with ServerProcess(observers) as server, ObserverProcess(server.address) as observer:
        browser.log_in(observer.url, OBSERVERS["ann"][0])
        says(server.address)
        server.kill()
        says(f"{server.address} is away: ")
        with ServerProcess(observers, server.address) as again:
            browser.until(lambda: browser.texts("#servers")[0] == server.address)
            Robots(again.address).detect("attic", scene.frame())
            browser.find("[data-robot=attic] canvas[data-id]")
            observer.kill()
            says("the observer is away")
            with ObserverProcess(again.address, observer.address):
                browser.find("#token")  # it knows no browser any more
                assert "has started anew" in browser.texts("#failure")[0]


def test_the_page_complains_of_nothing(browser: Browser, picture: Any) -> None:
    browser.press("3D")
    browser.find("#cloud")
    assert browser.complaints() == []
