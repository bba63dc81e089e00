"""The page in a real browser: what it shows is what the server answers, where it is."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Robots, Scene, Sending
from processes import OBSERVERS, ObserverProcess, ServerProcess, held_address, write_observers

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
    browser.until(lambda: browser.find("#failure").text.startswith("no server knows this token ("))
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
    with (
        ServerProcess(observers) as server,
        ObserverProcess(server.address, held_address()) as observer,
    ):
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


def luminance(color: str) -> float:
    """Of #rrggbb, as WCAG 2 has it."""
    shares = [int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in shares]
    return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))


def test_pages_that_were_left_hold_no_connections(
    browser: Browser, observer: ObserverProcess, picture: Any
) -> None:
    """Of which a browser has six for a host, while it keeps pages to go back to."""
    addresses = [f"{observer.url}?{number}" for number in range(7)]
    for address in addresses:
        browser.driver.get(address)
        browser.find("[data-robot=kitchen-1]")
    browser.driver.back()
    assert browser.driver.current_url == addresses[-2]
    browser.find("[data-robot=kitchen-1] canvas[data-id]")
    opened = "return performance.getEntriesByType('navigation')[0].type"
    assert browser.driver.execute_script(opened) != "navigate"  # it is not as it was left


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
