"""What the views of the page say of robots that are slow, or gone, in a real browser."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Recorded, Robots, Scene, Sending
from processes import OBSERVERS, ObserverProcess

import fovea

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import Browser, label_last  # noqa: E402

AN_HOUR = 3600 * 1000  # ms
SET_ON = "const real = Date.now; Date.now = () => real() + "


@contextmanager
def clock_set_on(browser: Browser, ms: int) -> Iterator[None]:
    command = {"source": f"{SET_ON}{ms};"}
    added = browser.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", command)
    yield
    browser.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)


def test_a_robot_that_has_gone_is_quiet(
    browser: Browser, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    browser.driver.get(f"{observer.url}#robot=leaves")
    browser.until(lambda: browser.text("#facts") == "no frame has come since this page was opened")
    robots.detect("leaves", scene.frame())
    browser.until(lambda: "how often is not known yet" in browser.text("#facts"))
    robots.detect("leaves", scene.frame())
    browser.until(lambda: "a second" in browser.text("#facts"))

    def is_quiet_in_an_hour() -> bool:
        """Each event of the observer sets the page's clock right, so that it may take another."""
        browser.driver.execute_script(SET_ON + str(AN_HOUR))
        return re.search(r"quiet for \d+ (min|h)", browser.text("#facts")) is not None

    browser.until(is_quiet_in_an_hour)


@pytest.mark.parametrize("ms", [-AN_HOUR, AN_HOUR])
def test_the_clock_of_the_browser_may_be_wrong(
    browser: Browser, recorded: Recorded, scene: Scene, tmp_path: Path, ms: int
) -> None:
    """It is the observer's that says what is quiet, where in the history, and there to be saved."""
    with clock_set_on(browser, ms):
        browser.log_in(recorded.observer.url, OBSERVERS["ann"][0])
        recorded.record("arm", scene.frame(), scene.frame())
        browser.until(lambda: "a second" in browser.text("[data-robot=arm] .soft"))
        browser.find("[data-robot=arm] button").click()
        recorded.record("arm", scene.frame())
        line = browser.find("#timeline")
        browser.until(lambda: " recorded" in browser.text("#moment"))
        newest = int(line.get_attribute("aria-valuemax"))
        assert abs(newest - time.time()) < AN_HOUR / 1000 / 2
        browser.find("#picture[data-id]")
        browser.downloads_to(tmp_path)
        browser.find("body").send_keys("f")
        browser.until(lambda: browser.text("#saved").startswith("saved fovea_arm_"))


def test_goes_on_where_frames_could_not_be_fetched(
    browser: Browser, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    """With pauses, as many tiles would ask for nothing else."""
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    browser.find("#who button")
    browser.driver.execute_script(
        """const asked = fetch, wait = setTimeout;
        window.pauses = [];
        window.setTimeout = (call, ms) => (window.pauses.push(ms), wait(call, ms));
        window.fetch = () => Promise.reject(new TypeError("away"));
        window.mend = () => (window.fetch = asked, window.setTimeout = wait);"""
    )
    robots.detect("unlucky", scene.frame())
    pauses = "return window.pauses"
    browser.until(lambda: len(browser.driver.execute_script(pauses)) > 4)
    assert min(browser.driver.execute_script(pauses)) >= 1000
    browser.find("[data-robot=unlucky] button").click()
    browser.find("#picture:not([data-id])")
    with Sending(robots, "unlucky", scene.frame()):
        browser.driver.execute_script("window.mend()")
        browser.find("#picture[data-id]")


@pytest.fixture
def phone(browser: Browser) -> Iterator[int]:
    """The width of one."""
    size = {"width": 400, "height": 850, "deviceScaleFactor": 1, "mobile": True}
    browser.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    yield size["width"]
    browser.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def test_long_names_are_whole_on_a_phone(
    browser: Browser, phone: int, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    name = 64 * "n"
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    browser.find("#who button")
    robots.detect(name, scene.frame())
    right = "return document.querySelector(arguments[0]).getBoundingClientRect().right"
    tile = f"[data-robot={name}]"
    browser.find(tile)
    assert browser.driver.execute_script(right, f"{tile} strong") < phone
    browser.find(f"{tile} button").click()
    browser.until(lambda: browser.text("h2") == name)
    width = "return document.documentElement.scrollWidth"
    assert browser.driver.execute_script(width) <= phone


def test_each_page_has_the_name_of_its_robot(browser: Browser, picture: Any) -> None:
    """Tabs are told apart by it."""
    assert browser.driver.title.startswith("kitchen-1 – ")
    browser.press("← all robots")
    browser.until(lambda: browser.driver.title.startswith("Fovea"))


def test_buttons_of_signs_have_names(browser: Browser, picture: Any) -> None:
    names = {"key ,": "the frame before", "key .": "the next frame"}
    for title, name in names.items():
        assert browser.find(f".bar [title='{title}']").accessible_name == name


def test_what_the_robot_did_not_ask_for_is_told(browser: Browser, picture: Any) -> None:
    for name in ("seeds", "saliency"):
        browser.press(name)
        assert browser.text("#picked").startswith(f"kitchen-1 did not ask for {name}")
        browser.press(name)
        assert not browser.text("#picked")
    browser.press("rejected")
    assert not browser.text("#picked")


def test_a_key_that_is_held_steps_and_does_no_more(browser: Browser, picture: Any) -> None:
    first = int(picture.get_attribute("data-id"))
    browser.until(lambda: int(picture.get_attribute("data-id")) > first)  # so that one is before
    browser.press("stop")
    hold = """const [key] = arguments;
        document.body.dispatchEvent(new KeyboardEvent("keydown", { key, repeat: true, bubbles: true }))"""
    browser.driver.execute_script(hold, "m")
    assert browser.find(".bar [title='key m']").get_attribute("aria-pressed") == "true"
    browser.driver.execute_script(hold, " ")
    assert browser.find(".bar [title='key space']").get_attribute("aria-pressed") == "true"
    at = int(picture.get_attribute("data-id"))
    browser.driver.execute_script(hold, ",")
    browser.until(lambda: int(picture.get_attribute("data-id")) < at)


@pytest.mark.parametrize("seconds", ["0", "601", "1.5", ""])
def test_seconds_that_cannot_be_saved_are_told(browser: Browser, past: Any, seconds: str) -> None:
    browser.driver.execute_script(
        "arguments[0].value = arguments[1]", browser.find("#around"), seconds
    )
    browser.press("save")
    assert "from 1 to 600" in browser.text("#saved.bad")


def test_more_objects_than_a_byte_counts_are_told_apart(
    browser: Browser, observer: ObserverProcess, sending: Sending
) -> None:
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    tile = browser.find("[data-robot=kitchen-1] button")
    first, last = sending.answer.objects[0].label, sending.answer.objects[-1]
    label_last(browser, first + 256)
    tile.click()
    picture = browser.find("#picture[data-id]")
    browser.press("stop")
    height, width = last.mask.shape
    ys, xs = np.nonzero(last.mask)
    middle = np.argmin((xs - xs.mean()) ** 2 + (ys - ys.mean()) ** 2)
    browser.hover(picture, (xs[middle] + 0.5) / width, (ys[middle] + 0.5) / height)
    assert browser.find("#objects tr.chosen").get_attribute("data-label") == str(first + 256)


def test_rows_of_the_table_keep_the_focus(browser: Browser, picture: Any) -> None:
    """While other frames are shown."""
    script = """const row = document.querySelector("#objects tbody tr:last-child");
    row.focus();
    return row.dataset.label;"""
    label = browser.driver.execute_script(script)
    at = int(picture.get_attribute("data-id"))
    browser.until(lambda: int(picture.get_attribute("data-id")) > at)
    assert browser.driver.switch_to.active_element.get_attribute("data-label") == label
    assert browser.find("#objects tr.chosen").get_attribute("data-label") == label


def test_a_finger_on_the_picture_scrolls_the_page(
    browser: Browser, phone: int, picture: Any
) -> None:
    script = """const box = arguments[0].getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2];"""
    x, y = browser.driver.execute_script(script, picture)
    for kind, points in (
        ("touchStart", [{"x": x, "y": y}]),
        *(("touchMove", [{"x": x, "y": y - up}]) for up in range(20, 201, 20)),
        ("touchEnd", []),
    ):
        touch = {"type": kind, "touchPoints": points}
        browser.driver.execute_cdp_cmd("Input.dispatchTouchEvent", touch)
    browser.until(lambda: browser.driver.execute_script("return scrollY") > 0)


def test_a_slow_connection_shows_a_robot_in_large(
    browser: Browser, observer: ObserverProcess, sending: Sending
) -> None:
    """Which asks for frames when others have come since."""
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    tile = browser.find("[data-robot=kitchen-1] button")
    browser.driver.execute_script(
        """const asked = window.fetch;
        window.fetch = (...all) => new Promise((go) => setTimeout(go, 1000)).then(() => asked(...all));"""
    )
    tile.click()
    picture = browser.find("#picture[data-id]")
    at = picture.get_attribute("data-id")
    browser.until(lambda: picture.get_attribute("data-id") != at)


def test_tiles_hold_no_more_pixels_than_they_show(
    browser: Browser, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    """And none while they are scrolled away."""
    wide = fovea.Frame(
        scene.color.repeat(3, 0).repeat(3, 1),
        scene.depth.repeat(3, 0).repeat(3, 1),
        fovea.CameraIntrinsics(787.5, 787.5, 479.5, 359.5),
    )
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    browser.find("#who button")
    answer = robots.detect("wide", wide, return_masks=True)
    canvas = browser.find("[data-robot=wide] canvas[data-id]")
    pixels = browser.pixels(canvas)
    assert pixels.shape == (360, 480, 4)
    # What is drawn is where it is: the left side of the first object's box, in the first colour.
    box = answer.objects[0].bounding_box
    side = pixels[box.y // 2 + 4 : (box.y + box.height) // 2 - 4, box.x // 2, :3].astype(int)
    assert (np.abs(side - (230, 159, 0)).max(axis=1) < 60).mean() > 0.5
    shown = "return document.querySelector('[data-robot=wide] canvas').width"
    down = "document.querySelector('.tiles').style.marginTop = arguments[0]"
    browser.driver.execute_script(down, "5000px")
    browser.until(lambda: browser.driver.execute_script(shown) == 0)
    browser.driver.execute_script(down, "0")
    browser.until(lambda: browser.driver.execute_script(shown) == 480)
