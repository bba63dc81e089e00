"""The page in a real browser: what it shows is what the server answers, where it is."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Robots, Scene, Sending
from processes import OBSERVERS, ObserverProcess, ServerProcess, write_observers

import fovea

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import Browser  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402


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
    browser.press("stop")
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
    browser.press("stop")
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
    browser.press("stop")
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
    browser.press("stop")
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
    says = lambda text: browser.until(lambda: text in browser.text("#servers"))  # noqa: E731
    with ServerProcess(observers) as server, ObserverProcess(server.address) as observer:
        browser.log_in(observer.url, OBSERVERS["ann"][0])
        says(server.address)
        server.kill()
        says(f"{server.address} is away: ")
        with ServerProcess(observers, server.address) as again:
            browser.until(lambda: browser.text("#servers") == server.address)
            Robots(again.address).detect("attic", scene.frame())
            browser.find("[data-robot=attic] canvas[data-id]")
            observer.kill()
            says("the observer is away")
            with ObserverProcess(again.address, observer.address):
                browser.find("#token")  # it knows no browser any more
                assert "has started anew" in browser.text("#failure")


def test_without_a_history_its_flags_are_told(browser: Browser, picture: Any) -> None:
    assert not browser.find("#timeline").is_displayed()
    told = browser.find("#no-history").text
    assert "--history FOLDER" in told and "--history-token-file" in told


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
        browser.press("stop")
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
