"""The page in a real browser: what it shows is what the server answers, where it is."""

from __future__ import annotations

import itertools
import json
import threading
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Recorded, Robots, Scene, recorder_is_ready
from picking import Picking
from processes import (
    OBSERVERS,
    ObserverProcess,
    ServerProcess,
    Visitor,
    history_flags,
    write_observers,
)

import fovea

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import CHROMIUM, DRIVER, Browser  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402

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


def test_the_cloud_is_turned_and_measured_by_keys(
    browser: Browser, picture: Any, scene: Scene
) -> None:
    browser.press("3D")
    cloud = browser.find("#cloud")
    browser.until(lambda: browser.drawn(cloud)[:, :, :3].max() > 0)
    stop(browser)
    point = browser.find("#point")
    cloud.send_keys(Keys.HOME)
    browser.until(lambda: point.get_attribute("value"))
    z = float(point.get_attribute("value").split()[2])
    middle = scene.depth[115:125, 155:165] / 1000  # metres around the middle of the picture
    assert middle.min() - 0.01 < z < middle.max() + 0.01
    seen = browser.drawn(cloud)
    for keys in (Keys.ARROW_LEFT, "+", Keys.SHIFT + Keys.ARROW_UP + Keys.NULL):
        cloud.send_keys(keys)
        browser.until(lambda: (browser.drawn(cloud) != seen).any())
        seen = browser.drawn(cloud)


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


@pytest.fixture
def past(browser: Browser, recorded: Recorded, scene: Scene) -> Iterator[Any]:
    """The canvas of a robot that sends, and of which there is a history from before."""
    frames = [scene.frame(id=f"before {number}") for number in range(4)]
    recorded.record("arm", *frames)
    browser.log_in(recorded.observer.url, OBSERVERS["ann"][0])
    with Sending(recorded.robots, "arm", scene.frame(id="now")):
        browser.find("[data-robot=arm] button").click()
        yield browser.find("#picture[data-id]")


def shown(browser: Browser) -> str:
    """The name of the frame that is shown."""
    return browser.texts("#facts")[0].split(" · ")[0].removeprefix("frame ")


def test_steps_back_into_the_history_and_on_again(browser: Browser, past: Any) -> None:
    browser.until(lambda: " recorded" in browser.texts("#moment")[0])
    stop(browser)
    body = browser.find("body")
    while shown(browser) == "now":
        at = past.get_attribute("data-id")
        body.send_keys(",")
        browser.until(lambda at=at: past.get_attribute("data-id") != at)
    assert shown(browser) == "before 3"
    assert past.get_attribute("data-past") == "true"
    assert "of the history" in browser.texts("#facts")[0]
    assert browser.all("#objects tbody tr")
    for name in ("before 2", "before 1"):
        body.send_keys(",")
        browser.until(lambda name=name: shown(browser) == name)
    for name in ("before 2", "before 3", "now"):
        body.send_keys(".")
        browser.until(lambda name=name: shown(browser) == name)
    body.send_keys(" ")
    browser.until(lambda: past.get_attribute("data-past") == "false")


def test_the_time_line_leads_to_moments(browser: Browser, past: Any) -> None:
    line = browser.find("#timeline")
    browser.until(lambda: " recorded" in browser.texts("#moment")[0])
    # Long before there was anything: the nearest is the first.
    browser.click(line, 0.01, 0.5)
    browser.until(lambda: past.get_attribute("data-past") == "true")
    assert shown(browser).startswith("before")
    first = shown(browser)
    line.send_keys(Keys.ARROW_RIGHT)
    browser.until(lambda: shown(browser) != first)
    line.send_keys(Keys.HOME)
    browser.until(lambda: shown(browser) == first)
    line.send_keys(Keys.END)
    browser.until(lambda: shown(browser) == "now")


def test_the_past_is_in_3d_too(browser: Browser, past: Any) -> None:
    browser.press("3D")
    browser.until(lambda: " recorded" in browser.texts("#moment")[0])
    browser.click(browser.find("#timeline"), 0.01, 0.5)
    browser.until(lambda: past.get_attribute("data-past") == "true")
    cloud = browser.find("#cloud")
    browser.until(lambda: browser.drawn(cloud)[:, :, :3].max() > 0)


def test_saves_a_frame_and_the_seconds_around(browser: Browser, past: Any, tmp_path: Path) -> None:
    browser.downloads_to(tmp_path)
    stop(browser)
    browser.find("body").send_keys("f")
    browser.until(lambda: list(tmp_path.glob("fovea_arm_*.zip")))
    browser.until(lambda: "saved fovea_arm_" in browser.texts("#saved")[0])
    with zipfile.ZipFile(next(tmp_path.glob("*.zip"))) as file:
        frames = json.loads(file.read("bundle.json"))["frames"]
        assert len(frames) == 1 and frames[0]["robot"] == "arm"
    for path in tmp_path.iterdir():
        path.unlink()
    around = browser.find("#around")
    around.clear()
    around.send_keys("1")
    browser.press("save")
    browser.until(lambda: list(tmp_path.glob("fovea_arm_*.zip")))
    with zipfile.ZipFile(next(tmp_path.glob("*.zip"))) as file:
        assert len(json.loads(file.read("bundle.json"))["frames"]) > 1


def test_tries_options_beside_the_answer(
    browser: Browser, past: Any, recorded: Recorded, scene: Scene
) -> None:
    browser.press("try")
    browser.until(lambda: browser.all("#options tbody tr"))
    before = browser.pixels(browser.find("#before"))
    assert browser.all("#options tbody tr .words")[0].text
    browser.find("#run").click()
    browser.until(lambda: "nothing changed" in browser.texts("#tried")[0])
    rows = browser.texts("#changes tbody tr td:last-child")
    assert rows and set(rows) == {"the same"}
    assert np.array_equal(browser.pixels(browser.find("#after")), before)
    find = browser.find("#find")
    find.send_keys("min_probability")
    assert 0 < len(browser.all("#options tbody tr")) < 5
    changes = {"objects.min_probability": 0.97}
    wanted = recorded.robots.detect("other", scene.frame(), parameters=changes).objects
    assert 0 < len(wanted) < len(rows)
    set_option(browser, *changes.popitem())
    browser.until(lambda: browser.texts("#command")[0].endswith("objects.min_probability=0.97"))
    browser.find("#run").click()
    browser.until(lambda: "gone" in browser.texts("#changes tbody tr td:last-child"))
    assert "changed" in browser.texts("#tried")[0]
    tried = browser.texts("#changes tbody tr td:nth-child(2)")
    assert {text for text in tried if text != "–"} == {str(found.label) for found in wanted}
    set_option(browser, "objects.min_probability", 7)
    browser.find("#run").click()
    browser.until(lambda: browser.texts("#tried.bad"))
    assert "objects.min_probability" in browser.texts("#tried.bad")[0]


def test_a_frame_that_is_not_recorded_is_tried_by_the_nearest(
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
        browser.press("try")
        browser.until(lambda: shown(browser) == "recorded")
        told = browser.texts("#picked")[0]
        assert told.startswith("the history does not hold the frame") and told.endswith("before it")
        browser.until(lambda: browser.all("#options tbody tr"))


def set_option(browser: Browser, name: str, value: float) -> None:
    script = "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('change'))"
    field = browser.find(f"[data-option='{name}']")
    browser.driver.execute_script(script, field, str(value))


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
        browser.until(lambda: "hand got object" in browser.texts("#picked")[0])
        browser.until(lambda: robot.picks)
        assert robot.picks[0].label == found.label and robot.picks[0].observer == "ann"
        # Of a frame that has long been pushed out by others, too.
        stop(browser)
        browser.until(lambda: is_gone(browser, "hand", picture.get_attribute("data-id")))
        browser.click(picture, (box.x + xs[at] + 0.5) / width, (box.y + ys[at] + 0.5) / height)
        browser.until(lambda: len(robot.picks) == 2)
        assert robot.picks[1].label == found.label


def test_a_robot_that_takes_no_picks_is_said(
    browser: Browser, past: Any, recorded: Recorded
) -> None:
    row = browser.find("#objects tbody tr")
    stop(browser)
    row = browser.find("#objects tbody tr")
    browser.driver.execute_script("arguments[0].focus()", row)
    row.send_keys("\ue007")  # Enter
    browser.until(lambda: browser.texts("#picked.bad"))
    assert "arm takes no picks" in browser.texts("#picked.bad")[0]


def test_who_may_only_look_is_shown_no_more(
    browser: Browser, recorded: Recorded, scene: Scene
) -> None:
    recorded.record("kitchen-1", scene.frame())
    browser.log_in(recorded.observer.url, OBSERVERS["ben"][0])
    with Sending(recorded.robots, "kitchen-1", scene.frame()):
        browser.find("[data-robot=kitchen-1] button").click()
        browser.find("#picture[data-id]")
        browser.until(lambda: " recorded" in browser.texts("#moment")[0])
        labels = browser.texts(".bar button")
        assert "stop" in labels and not {"save", "save frame", "try"} & set(labels)
        assert not browser.all(".picks")


def test_without_a_history_its_flags_are_told(browser: Browser, picture: Any) -> None:
    assert not browser.find("#timeline").is_displayed()
    told = browser.find("#no-history").text
    assert "--history FOLDER" in told and "--history-token-file" in told


def seek_first(browser: Browser, name: str) -> None:
    """A single click leads to the first frame of the history, of this name."""
    browser.click(browser.find("#timeline"), 0.01, 0.5)
    picture = browser.find("#picture")
    browser.until(lambda: picture.get_attribute("data-past") == "true" and shown(browser) == name)


def test_the_history_goes_on_after_both_were_killed(
    browser: Browser, scene: Scene, tmp_path: Path
) -> None:
    observers, flags = write_observers(tmp_path), history_flags(tmp_path)
    says = lambda text: browser.until(lambda: text in browser.texts("#servers")[0])  # noqa: E731
    with (
        ServerProcess(observers) as server,
        ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer,
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
            browser.until(lambda: " recorded" in browser.texts("#moment")[0])
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


@pytest.mark.parametrize(
    "lens",
    [
        fovea.LensDistortion("plumb_bob", [-0.3, 0.1, 0.002, -0.003, 0.0]),
        fovea.LensDistortion("equidistant", [-0.05, 0.02, 0.0, 0.0]),
    ],
)
def test_points_have_the_colours_of_their_pixels_with_any_lens(
    browser: Browser, observer: ObserverProcess, robots: Robots, lens: fovea.LensDistortion
) -> None:
    """A wall whose colour says which pixel of the picture it is in."""
    width, height, focal = 320, 240, 200.0
    us, vs = np.meshgrid(np.arange(width), np.arange(height))
    color = np.stack([us * 255 // width, vs * 255 // height, np.full_like(us, 128)], 2)
    camera = fovea.CameraIntrinsics(focal, focal, 159.5, 119.5, lens)
    frame = fovea.Frame(color.astype(np.uint8), np.full((height, width), 1000, np.uint16), camera)
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    with Sending(robots, "wall", frame):
        browser.find("[data-robot=wall] button").click()
        browser.find("#picture[data-id]")
        browser.press("3D")
        cloud = browser.find("#cloud")
        browser.until(lambda: browser.drawn(cloud)[:, :, 2].max() > 100)
        stop(browser)
        drawn = browser.drawn(cloud).astype(int)
    rows, columns = drawn.shape[:2]
    tried = 0
    for x, y in itertools.product((0.08, 0.2, 0.5, 0.8, 0.92), (0.08, 0.2, 0.8, 0.92)):
        # The eye stands in the camera, and looks through no lens.
        ray = ((x - 0.5) * width / focal, (y - 0.5) * height / focal)
        u, v = bent(lens, ray, focal, (159.5, 119.5))
        red, green, blue = drawn[int(y * rows), int(x * columns), :3]
        if abs(blue - 128) > 8:
            continue  # a line of the grid on what it takes for a support
        assert abs(red - u * 255 / width) < 8 and abs(green - v * 255 / height) < 8, (x, y)
        tried += 1
    assert tried >= 5


def bent(
    lens: fovea.LensDistortion, ray: tuple[float, float], focal: float, middle: tuple[float, float]
) -> tuple[float, float]:
    """The pixel of the picture that was sent."""
    x, y = ray
    r2 = x * x + y * y
    k = list(lens.coefficients)
    if lens.model == "equidistant":
        theta = np.arctan(np.sqrt(r2))
        bend = theta * (1 + sum(k[i] * theta ** (2 * i + 2) for i in range(4)))
        scale = bend / np.sqrt(r2) if r2 > 0 else 1.0
        x, y = x * scale, y * scale
    else:
        radial = 1 + k[0] * r2 + k[1] * r2**2 + k[4] * r2**3
        x, y = (
            x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x),
            y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y,
        )
    return focal * x + middle[0], focal * y + middle[1]


def luminance(color: str) -> float:
    """Of #rrggbb, as WCAG 2 has it."""
    shares = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in shares]
    return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_texts_stand_out(browser: Browser, observer: ObserverProcess, scheme: str) -> None:
    """At least as WCAG 2 asks for it at level AA."""
    feature = {"name": "prefers-color-scheme", "value": scheme}
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})
    browser.driver.get(observer.url)
    script = """const style = getComputedStyle(document.documentElement);
    return arguments[0].map(name => style.getPropertyValue("--" + name).trim());"""
    names = ["back", "card", "bad-back", "text", "soft", "bad", "accent"]
    colors = dict(zip(names, browser.driver.execute_script(script, names), strict=True))
    light = {name: luminance(color) for name, color in colors.items()}
    assert (light["back"] > light["text"]) == (scheme == "light")
    pairs = list(itertools.product(("text", "soft", "bad"), ("back", "card")))
    for one, other in [*pairs, ("text", "bad-back"), ("accent", "back"), ("accent", "card")]:
        dark, bright = sorted((light[one], light[other]))
        assert (bright + 0.05) / (dark + 0.05) >= 4.5, (one, other)


def test_the_page_complains_of_nothing(browser: Browser, picture: Any) -> None:
    browser.press("3D")
    browser.find("#cloud")
    assert browser.complaints() == []
