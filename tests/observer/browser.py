"""Debian's Chromium, headless, with the page in it."""

from __future__ import annotations

import base64
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from processes import PATIENCE
from selenium import webdriver
from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.remote.webelement import WebElement
from selenium.webdriver.support.ui import WebDriverWait

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")

# As base64, since a list of numbers takes a second.
READ_CANVAS = """
const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
let text = "";
for (let i = 0; i < data.length; i += 8192) {
  text += String.fromCharCode(...data.subarray(i, i + 8192));
}
return [canvas.width, canvas.height, btoa(text)];
"""

# One in 3D cannot be read as it is.
COPY_CANVAS = """
const copy = document.createElement("canvas");
copy.width = canvas.width;
copy.height = canvas.height;
copy.getContext("2d").drawImage(canvas, 0, 0);
canvas = copy;
"""


class Browser:
    def __init__(self, *flags: str) -> None:
        options = webdriver.ChromeOptions()
        options.binary_location = CHROMIUM
        own = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--mute-audio"]
        own += ["--enable-unsafe-swiftshader", "--window-size=1300,1000"]
        for flag in (*own, *flags):
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.driver.set_page_load_timeout(PATIENCE)

    def close(self) -> None:
        self.driver.quit()

    def find(self, selector: str) -> WebElement:
        """Waits for it."""
        return self.until(lambda: (self.all(selector) or [None])[0])

    def all(self, selector: str) -> list[WebElement]:
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def texts(self, selector: str) -> list[str]:
        """Of all at once, as the page goes on meanwhile."""
        script = "return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)"
        return list(self.driver.execute_script(script, selector))

    def text(self, selector: str) -> str:
        """Of the first; nothing where there is none yet."""
        return (self.texts(selector) or [""])[0]

    def until(self, is_so: Callable[[], Any]) -> Any:
        """What the page replaces meanwhile is looked for again."""
        gone = (StaleElementReferenceException,)
        wait = WebDriverWait(self.driver, PATIENCE, 0.05, ignored_exceptions=gone)
        return wait.until(lambda _: is_so())

    def log_in(self, url: str, token: str) -> None:
        self.driver.delete_all_cookies()
        self.driver.get("about:blank")
        self.driver.get(url)
        self.find("#token").send_keys(token + Keys.ENTER)

    @contextmanager
    def tab(self) -> Iterator[None]:
        """Another one in front; it is closed at the end."""
        before = self.driver.current_window_handle
        self.driver.switch_to.new_window("tab")
        yield
        self.driver.close()
        self.driver.switch_to.window(before)

    def sees(self, is_seen: bool) -> None:
        """As if the page were behind another tab, or not; headless browsers show them all."""
        script = """Object.defineProperty(document, "hidden", { value: !arguments[0], configurable: true });
        document.dispatchEvent(new Event("visibilitychange"));"""
        self.driver.execute_script(script, is_seen)

    def press(self, label: str) -> None:
        """Waits for the button."""

        def pressed() -> bool:
            buttons = [button for button in self.all(".bar button") if button.text == label]
            for button in buttons:
                button.click()
            return bool(buttons)

        self.until(pressed)

    def pixels(self, canvas: WebElement, before: str = "") -> np.ndarray[Any, Any]:
        script = "let canvas = arguments[0];" + before + READ_CANVAS
        width, height, text = self.driver.execute_script(script, canvas)
        return np.frombuffer(base64.b64decode(text), np.uint8).reshape(height, width, 4)

    def drawn(self, canvas: WebElement) -> np.ndarray[Any, Any]:
        """The pixels of a canvas in 3D."""
        return self.pixels(canvas, COPY_CANVAS)

    def downloads_to(self, folder: Path) -> None:
        command = {"behavior": "allow", "downloadPath": str(folder)}
        self.driver.execute_cdp_cmd("Browser.setDownloadBehavior", command)

    def click(self, canvas: WebElement, x: float, y: float) -> None:
        """At this share of its width and height."""
        self.hover(canvas, x, y)
        ActionChains(self.driver).click().perform()

    def hover(self, canvas: WebElement, x: float, y: float) -> None:
        """At this share of its width and height."""
        self.driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
        size = canvas.size
        right = round((x - 0.5) * size["width"])
        down = round((y - 0.5) * size["height"])
        ActionChains(self.driver).move_to_element_with_offset(canvas, right, down).perform()

    def complaints(self) -> list[str]:
        """What the page had to say in its console."""
        # No session yet; a frame that has passed; options and picks that were refused.
        known = ("401", "404", "400", "409")
        return [
            entry["message"]
            for entry in self.driver.get_log("browser")
            if entry["level"] == "SEVERE" and not any(text in entry["message"] for text in known)
        ]


def label_last(browser: Browser, label: int) -> None:
    """Renames the last object of each answer that the page gets from now on, as if there were so many."""
    browser.driver.execute_script(
        """const [label] = arguments, asked = window.fetch;
        window.fetch = async (path, ...more) => {
          const response = await asked(path, ...more);
          const isAnswer = ["/api/answer?", "/api/history/answer?", "/api/try"].some((each) => path.startsWith(each));
          if (!isAnswer || !response.ok) return response;
          const answer = await response.json();
          (answer.frame ?? answer).detections.objects.at(-1).label = label;
          return Response.json(answer);
        };""",
        label,
    )
