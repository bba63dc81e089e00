"""The history in a real browser, what is tried on its frames, and what is picked from them."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Recorded, Robots, Scene, Sending, recorder_is_ready
from picking import Picking
from processes import (
    OBSERVERS,
    ObserverProcess,
    ServerProcess,
    Visitor,
    held_address,
    history_flags,
    write_observers,
)

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import Browser  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402


def shown(browser: Browser) -> str:
    """The name of the frame that is shown."""
    return browser.text("#facts").split(" · ")[0].removeprefix("frame ")


def steps(browser: Browser, past: Any, key: str, name: str) -> None:
    """To the next frame of another name, which must be this one; some are there twice."""
    start = shown(browser)
    while shown(browser) == start:
        at = past.get_attribute("data-id")
        browser.find("body").send_keys(key)
        browser.until(lambda at=at: past.get_attribute("data-id") != at)
    assert shown(browser) == name


def test_steps_back_into_the_history_and_on_again(browser: Browser, past: Any) -> None:
    browser.until(lambda: " recorded" in browser.text("#moment"))
    browser.press("stop")
    steps(browser, past, ",", "before 3")
    assert past.get_attribute("data-past") == "true"
    assert "of the history" in browser.text("#facts")
    assert browser.all("#objects tbody tr")
    for name in ("before 2", "before 1"):
        steps(browser, past, ",", name)
    for name in ("before 2", "before 3", "now"):
        steps(browser, past, ".", name)
    browser.find("body").send_keys(" ")
    browser.until(lambda: past.get_attribute("data-past") == "false")


def test_the_time_line_leads_to_moments(browser: Browser, past: Any) -> None:
    line = browser.find("#timeline")
    browser.until(lambda: " recorded" in browser.text("#moment"))
    # Long before there was anything: the nearest is the first.
    browser.click(line, 0.01, 0.5)
    browser.until(lambda: past.get_attribute("data-past") == "true")
    assert shown(browser).startswith("before")
    first = past.get_attribute("data-id")
    line.send_keys(Keys.ARROW_RIGHT)
    browser.until(lambda: past.get_attribute("data-id") != first)
    line.send_keys(Keys.HOME)
    browser.until(lambda: past.get_attribute("data-id") == first)

    def ends_now() -> bool:  # once one of what is sent is recorded
        line.send_keys(Keys.END)
        return shown(browser) == "now"

    browser.until(ends_now)


def test_what_came_while_nobody_saw_the_page_can_be_reached(
    browser: Browser, recorded: Recorded, scene: Scene
) -> None:
    """Nothing of it is among the frames that came to the page."""
    recorded.record("left", scene.frame(id="before"))
    browser.log_in(recorded.observer.url, OBSERVERS["ann"][0])
    with Sending(recorded.robots, "left", scene.frame(id="open")):
        browser.find("[data-robot=left] button").click()
        picture = browser.find("#picture[data-id]")
        browser.until(lambda: shown(browser) == "open")
    browser.sees(False)
    first = last = recorded.record("left", scene.frame(id="meanwhile"))[-1]
    while last - first < 6_000_000:  # us, by what is recorded; some are as near as the same frame
        last = recorded.record("left", scene.frame(id="meanwhile"))[-1]
    browser.sees(True)
    browser.find("#timeline").send_keys(Keys.END)
    browser.until(lambda: shown(browser) == "meanwhile")
    browser.press("stop")
    with Sending(recorded.robots, "left", scene.frame(id="after")):
        browser.until(lambda: shown(browser) == "after")
    browser.press("stop")
    steps(browser, picture, ",", "meanwhile")
    browser.find("#timeline").send_keys(Keys.HOME)
    browser.until(lambda: shown(browser) == "before")


def test_the_past_is_in_3d_too(browser: Browser, past: Any) -> None:
    browser.press("3D")
    browser.until(lambda: " recorded" in browser.text("#moment"))
    browser.click(browser.find("#timeline"), 0.01, 0.5)
    browser.until(lambda: past.get_attribute("data-past") == "true")
    cloud = browser.find("#cloud")
    browser.until(lambda: browser.drawn(cloud)[:, :, :3].max() > 0)


def test_what_stands_still_is_in_3d_from_the_history(browser: Browser, past: Any) -> None:
    """It came without its depth, which nobody had asked for."""
    browser.press("stop")
    browser.press("3D")
    browser.until(lambda: past.get_attribute("data-past") == "true")
    cloud = browser.find("#cloud")
    browser.until(lambda: browser.drawn(cloud)[:, :, :3].max() > 0)


def test_saves_a_frame_and_the_seconds_around(browser: Browser, past: Any, tmp_path: Path) -> None:
    browser.downloads_to(tmp_path)
    browser.press("stop")
    browser.find("body").send_keys("f")
    browser.until(lambda: list(tmp_path.glob("fovea_arm_*.zip")))
    browser.until(lambda: "saved fovea_arm_" in browser.text("#saved"))
    with zipfile.ZipFile(next(tmp_path.glob("*.zip"))) as file:
        frames = json.loads(file.read("bundle.json"))["frames"]
        assert len(frames) == 1 and frames[0]["robot"] == "arm"
    for path in tmp_path.iterdir():
        path.unlink()
    around = browser.find("#around")
    around.clear()
    around.send_keys("10")
    browser.press("save")
    browser.until(lambda: list(tmp_path.glob("fovea_arm_*.zip")))
    with zipfile.ZipFile(next(tmp_path.glob("*.zip"))) as file:
        assert len(json.loads(file.read("bundle.json"))["frames"]) > 1


def test_a_day_of_frames_is_drawn(browser: Browser, past: Any) -> None:
    """As if the history had held them: two a second."""
    count = 24 * 60 * 60 * 2
    browser.driver.execute_script(
        """const [count] = arguments, fetched = window.fetch;
        const of = (value) => Array.from({ length: count }, (_, i) => value(i));
        const list = { minutes: 1440, problem: "", ids: of((i) => Date.now() * 1000 - 5e5 * (count - i)), objects: of(() => 3), problems: of(() => 0) };
        window.fetch = (path, ...more) => path.startsWith("/api/history?") ? Promise.resolve(Response.json(list)) : fetched(path, ...more);""",
        count,
    )
    browser.until(lambda: f"{count} frames recorded" in browser.text("#moment"))


def test_a_frame_that_is_not_recorded_is_saved_and_tried_by_the_nearest(
    browser: Browser, scene: Scene, tmp_path: Path
) -> None:
    """A robot that sends faster than the history is kept."""
    flags = history_flags(tmp_path, rate=0.1)
    with (
        ServerProcess(write_observers(tmp_path)) as server,
        ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer,
    ):
        visitor, robots = Visitor(observer.address), Robots(server.address)
        visitor.log_in(OBSERVERS["ann"][0])
        recorder_is_ready(visitor, robots)
        robots.detect("arm", scene.frame(id="recorded"))
        visitor.history("arm", 1)
        browser.log_in(observer.url, OBSERVERS["ann"][0])
        robots.detect("arm", scene.frame(id="between"))
        browser.find("[data-robot=arm] button").click()
        browser.until(lambda: shown(browser) == "between")
        browser.downloads_to(tmp_path)
        browser.find("body").send_keys("f")
        browser.until(lambda: browser.text("#saved").endswith("before it"))
        assert browser.text("#saved").startswith("saved fovea_arm_")
        browser.press("try")
        browser.until(lambda: shown(browser) == "recorded")
        browser.until(lambda: browser.text("#picked").endswith("before it"))
        assert browser.text("#picked").startswith("the history does not hold the frame")
        browser.until(lambda: browser.all("#options tbody tr"))


def is_gone(browser: Browser, robot: str, number: str) -> bool:
    script = """const [robot, id, done] = arguments;
        fetch(`/api/answer?robot=${robot}&id=${id}`).then((answer) => done(answer.status === 404))"""
    return bool(browser.driver.execute_async_script(script, robot, number))


def test_a_click_marks_an_object_for_the_robot(
    browser: Browser, recorded: Recorded, scene: Scene
) -> None:
    with Picking(recorded.robots.address, "hand", scene.frame(id="picked")) as robot:
        browser.log_in(recorded.observer.url, OBSERVERS["ann"][0])
        browser.find("[data-robot=hand] button").click()
        picture = browser.find("#picture[data-id]")
        assert robot.first is not None
        found = robot.first.objects[0]
        box = found.bounding_box
        width, height = scene.depth.shape[1], scene.depth.shape[0]
        labels = scene.labels[box.y : box.y + box.height, box.x : box.x + box.width]
        ys, xs = np.nonzero(labels)
        at = np.argmin((xs - xs.mean()) ** 2 + (ys - ys.mean()) ** 2)
        browser.click(picture, (box.x + xs[at] + 0.5) / width, (box.y + ys[at] + 0.5) / height)
        browser.until(lambda: "hand got object" in browser.text("#picked"))
        browser.until(lambda: robot.picks)
        assert robot.picks[0].label == found.label and robot.picks[0].observer == "ann"
        # Of a frame that has long been pushed out by others, too.
        browser.press("stop")
        browser.until(lambda: is_gone(browser, "hand", picture.get_attribute("data-id")))
        browser.click(picture, (box.x + xs[at] + 0.5) / width, (box.y + ys[at] + 0.5) / height)
        browser.until(lambda: len(robot.picks) == 2)
        assert robot.picks[1].label == found.label


def test_a_robot_that_takes_no_picks_is_said(
    browser: Browser, past: Any, recorded: Recorded
) -> None:
    row = browser.find("#objects tbody tr")
    browser.press("stop")
    row = browser.find("#objects tbody tr")
    browser.driver.execute_script("arguments[0].focus()", row)
    row.send_keys("\ue007")  # Enter
    browser.until(lambda: browser.texts("#picked.bad"))
    assert "arm takes no picks" in browser.text("#picked.bad")


def test_who_may_only_look_is_shown_no_more(
    browser: Browser, recorded: Recorded, scene: Scene
) -> None:
    recorded.record("kitchen-1", scene.frame())
    browser.log_in(recorded.observer.url, OBSERVERS["ben"][0])
    with Sending(recorded.robots, "kitchen-1", scene.frame()):
        browser.find("[data-robot=kitchen-1] button").click()
        browser.find("#picture[data-id]")
        browser.until(lambda: " recorded" in browser.text("#moment"))
        labels = browser.texts(".bar button")
        assert "stop" in labels and not {"save", "save frame", "try"} & set(labels)
        assert not browser.all(".picks")


def seek_first(browser: Browser, name: str) -> None:
    """A single click leads to the first frame of the history, of this name."""
    browser.click(browser.find("#timeline"), 0.01, 0.5)
    picture = browser.find("#picture")
    browser.until(lambda: picture.get_attribute("data-past") == "true" and shown(browser) == name)


def test_the_history_goes_on_after_both_were_killed(
    browser: Browser, scene: Scene, tmp_path: Path
) -> None:
    observers, flags = write_observers(tmp_path), history_flags(tmp_path)
    says = lambda text: browser.until(lambda: text in browser.text("#servers"))  # noqa: E731
    with (
        ServerProcess(observers) as server,
        ObserverProcess(server.address, held_address(), *flags) as observer,
    ):
        visitor = Visitor(observer.address)
        visitor.log_in(OBSERVERS["ann"][0])
        recorder_is_ready(visitor, Robots(server.address))
        Robots(server.address).detect("arm", scene.frame(id="before both"))
        visitor.history("arm", 1)
        browser.log_in(observer.url, OBSERVERS["ann"][0])
        with Sending(Robots(server.address), "arm", scene.frame(id="before both")):
            browser.find("[data-robot=arm] button").click()
            browser.find("#picture[data-id]")
            browser.until(lambda: " recorded" in browser.text("#moment"))
        place = browser.find("#timeline").rect
        server.kill()
        says("is away: ")
        assert (
            browser.find("#timeline").rect == place
        ), "what is said moves nothing that is clicked on"
        seek_first(browser, "before both")  # what is there can still be seen
        observer.kill()
        says("the observer is away")
        with (
            ServerProcess(observers, server.address) as again,
            ObserverProcess(server.address, observer.address, *flags),
        ):
            browser.find("#token").send_keys(OBSERVERS["ann"][0] + "\n")
            with Sending(Robots(again.address), "arm", scene.frame(id="after both")):
                browser.find("#picture[data-id]")
                browser.until(lambda: shown(browser) == "after both")
                seek_first(browser, "before both")
