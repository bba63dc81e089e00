"""Who is logged in, in several pages of one real browser, and what hidden ones cost."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Any

import pytest
from conftest import Recorded, Scene
from processes import OBSERVERS, ObserverProcess, ServerProcess

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import Browser  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402


def is_of(browser: Browser, name: str) -> None:
    browser.until(lambda: browser.text("#who").startswith(name))


def test_all_pages_of_a_browser_are_of_who_logged_in_last(
    browser: Browser, observer: ObserverProcess
) -> None:
    """As they have one cookie: a page of another could do nothing, not even log out."""
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    is_of(browser, "ann")
    with browser.tab():
        browser.driver.get(f"{observer.url}#token={OBSERVERS['ben'][0]}")
        is_of(browser, "ben")
    is_of(browser, "ben")
    browser.find("#who button").click()
    browser.find("#token")
    browser.driver.refresh()
    browser.find("#token")


def test_logging_out_logs_out_all_pages(browser: Browser, observer: ObserverProcess) -> None:
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    with browser.tab():
        browser.driver.get(observer.url)
        browser.find("#who button").click()
        browser.find("#token")
    browser.find("#token")
    assert browser.text("#failure").startswith("Logged out elsewhere")


def test_who_cannot_be_logged_out_is_told(browser: Browser, server: ServerProcess) -> None:
    with ObserverProcess(server.address) as observer:
        browser.log_in(observer.url, OBSERVERS["ann"][0])
        is_of(browser, "ann")
        observer.kill()
        browser.find("#who button").click()
        browser.until(lambda: "ann is still logged in" in browser.text("#servers"))


def test_an_observer_that_is_away_is_told_to_who_logs_in(
    browser: Browser, server: ServerProcess
) -> None:
    with ObserverProcess(server.address) as observer:
        browser.driver.delete_all_cookies()
        browser.driver.get(observer.url)
        field = browser.find("#token")
        observer.kill()
        field.send_keys(OBSERVERS["ann"][0] + Keys.ENTER)
        browser.until(lambda: browser.text("#failure") == "the observer cannot be reached")


def test_a_token_put_into_the_address_of_an_open_page_logs_in(
    browser: Browser, observer: ObserverProcess
) -> None:
    """The page is not loaded again for it."""
    browser.log_in(observer.url, "wrong")
    browser.until(lambda: browser.text("#failure"))
    for name in ("ann", "ben"):
        browser.driver.get(f"{observer.url}#token={OBSERVERS[name][0]}")
        is_of(browser, name)
        assert "token" not in browser.driver.current_url


def test_an_address_that_is_written_by_hand_is_shown(
    browser: Browser, observer: ObserverProcess
) -> None:
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    is_of(browser, "ann")
    browser.driver.get(f"{observer.url}#robot=50%")
    browser.until(lambda: browser.text("h2") == "50%")
    browser.driver.refresh()
    browser.until(lambda: browser.text("h2") == "50%")


def test_tabs_that_nobody_sees_hold_no_connections(
    browser: Browser, observer: ObserverProcess, picture: Any
) -> None:
    """Of which a browser has six for a host."""
    with ExitStack() as tabs:
        for _ in range(7):
            browser.sees(False)
            tabs.enter_context(browser.tab())
            browser.driver.get(f"{observer.url}#robot=kitchen-1")
            browser.find("#picture[data-id]")
        browser.sees(False)
    at = picture.get_attribute("data-id")
    browser.sees(True)
    browser.until(lambda: picture.get_attribute("data-id") != at)


def test_a_tab_that_nobody_sees_asks_for_no_history(
    browser: Browser, recorded: Recorded, scene: Scene
) -> None:
    """What the page does each five seconds is done by hand here."""
    recorded.record("arm", scene.frame())
    browser.log_in(recorded.observer.url, OBSERVERS["ann"][0])
    browser.find("#who button")
    browser.driver.execute_script(
        """const asked = window.fetch, repeat = window.setInterval;
        window.lists = 0;
        window.setInterval = (call, ms) => (ms === 5000 ? (window.look = call, 0) : repeat(call, ms));
        window.fetch = (path, ...more) => (path.startsWith("/api/history?") && ++window.lists, asked(path, ...more));
        location.hash = "robot=arm";"""
    )

    def lists(script: str) -> int:
        """How many the page has asked for once that has run."""
        return int(browser.driver.execute_script(f"{script}; return window.lists"))

    browser.until(lambda: " recorded" in browser.text("#moment"))
    assert lists("window.look()") == 2
    browser.sees(False)
    assert lists("window.look()") == 2
    browser.until(lambda: browser.sees(True) or lists("") == 3)


def test_observers_at_other_ports_log_nobody_out(
    browser: Browser, observer: ObserverProcess, server: ServerProcess
) -> None:
    """Cookies know hosts, but no ports."""
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    is_of(browser, "ann")
    with ObserverProcess(server.address) as other, browser.tab():
        browser.driver.get(f"{other.url}#token={OBSERVERS['ben'][0]}")
        is_of(browser, "ben")
        browser.driver.get(observer.url)
        is_of(browser, "ann")
        browser.driver.get(other.url)
        is_of(browser, "ben")


def test_a_page_whose_session_is_lost_asks_for_a_token(browser: Browser, picture: Any) -> None:
    """Its events go on, but nothing of them can be fetched."""
    browser.driver.delete_all_cookies()
    browser.find("#token")
    assert browser.text("#failure").startswith("Logged out elsewhere")
