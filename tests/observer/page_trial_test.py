"""Other options on frames of the history, in a real browser."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from conftest import Recorded, Scene

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import Browser, label_last  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402


def set_option(browser: Browser, name: str, value: float) -> None:
    script = "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('change'))"
    field = browser.find(f"[data-option='{name}']")
    browser.driver.execute_script(script, field, str(value))


def test_tries_options_beside_the_answer(
    browser: Browser, past: Any, recorded: Recorded, scene: Scene
) -> None:
    browser.press("try")
    browser.until(lambda: browser.all("#options tbody tr"))
    before = browser.pixels(browser.find("#before"))
    assert browser.all("#options tbody tr .words")[0].text
    browser.find("#run").click()
    browser.until(lambda: "nothing changed" in browser.text("#tried"))
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
    browser.until(lambda: browser.text("#command").endswith("objects.min_probability=0.97"))
    browser.find("#run").click()
    browser.until(lambda: "gone" in browser.texts("#changes tbody tr td:last-child"))
    assert "changed" in browser.text("#tried")
    tried = browser.texts("#changes tbody tr td:nth-child(2)")
    assert {text for text in tried if text != "–"} == {str(found.label) for found in wanted}
    set_option(browser, "objects.min_probability", 7)
    browser.find("#run").click()
    browser.until(lambda: browser.texts("#tried.bad"))
    assert "objects.min_probability" in browser.text("#tried.bad")


def test_options_are_tried_while_other_frames_are_shown(browser: Browser, past: Any) -> None:
    browser.press("try")
    browser.until(lambda: browser.all("#options tbody tr"))
    browser.find("body").send_keys(" ")
    browser.until(lambda: past.get_attribute("data-past") == "false")
    at = int(past.get_attribute("data-id"))
    browser.until(lambda: int(past.get_attribute("data-id")) > at)
    browser.find("#run").click()
    browser.until(lambda: "nothing changed" in browser.text("#tried"))


def test_one_option_is_set_after_the_other(browser: Browser, past: Any) -> None:
    """Each field keeps what is typed into it, and leaves the focus where it is put."""
    browser.press("try")
    browser.until(lambda: browser.all("#options tbody tr"))
    values = {"max_depth_m": "2", "region.x_px": "3", "region.y_px": "4"}
    for name, value in values.items():
        field = browser.find(f"[data-option='{name}']")
        field.click()
        keys = browser.driver.switch_to.active_element
        keys.send_keys(Keys.CONTROL + "a" + Keys.NULL + value)
    browser.driver.switch_to.active_element.send_keys(Keys.TAB)
    wanted = "".join(f" --set {name}={value}" for name, value in values.items())
    browser.until(lambda: browser.text("#command").endswith(wanted))
    focused = browser.driver.switch_to.active_element.get_attribute("data-option")
    assert focused == "region.width_px"


def test_options_that_could_not_be_had_are_asked_for_again(browser: Browser, past: Any) -> None:
    browser.driver.execute_script(
        """const asked = window.fetch;
        window.fetch = (path, ...more) => path.startsWith("/api/options?") ? Promise.reject(new Error("away")) : asked(path, ...more);
        window.mend = () => (window.fetch = asked);"""
    )
    browser.press("try")
    browser.until(lambda: browser.text("#tried.bad") == "the observer cannot be reached")
    browser.driver.execute_script("window.mend()")
    browser.find("body").send_keys("tt")
    browser.until(lambda: browser.all("#options tbody tr"))


def test_more_objects_than_a_byte_counts_are_compared(browser: Browser, past: Any) -> None:
    label_last(browser, 257)
    browser.press("try")
    browser.until(lambda: browser.all("#options tbody tr"))
    browser.find("#run").click()
    browser.until(lambda: "257" in browser.texts("#changes tbody tr td:nth-child(2)"))
    assert set(browser.texts("#changes tbody tr td:last-child")) == {"the same"}
