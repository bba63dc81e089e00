"""The cloud of points of the page, in a real browser: where points are, their colours, keys."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from conftest import Robots, Scene, Sending
from processes import OBSERVERS, ObserverProcess

import fovea

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from browser import Browser  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402

if TYPE_CHECKING:
    from selenium.webdriver.remote.webelement import WebElement


def opened(browser: Browser, url: str, robots: Robots, robot: str, frame: fovea.Frame) -> None:
    with Sending(robots, robot, frame):
        browser.log_in(url, OBSERVERS["ann"][0])
        browser.find(f"[data-robot={robot}] button").click()
        browser.find("#picture[data-id]")


def cloud_of(browser: Browser, robots: Robots, robot: str, frame: fovea.Frame) -> WebElement:
    """Of frames sent one by one, as each takes a second to draw where there is no GPU."""
    browser.press("3D")
    cloud = browser.find("#cloud")

    def is_drawn() -> bool:
        robots.detect(robot, frame)
        return bool(browser.drawn(cloud)[:, :, :3].max() > 100)

    browser.until(is_drawn)
    return cloud


def test_points_in_3d_are_where_they_are(
    browser: Browser, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    opened(browser, observer.url, robots, "still", scene.frame())
    cloud = cloud_of(browser, robots, "still", scene.frame())
    point = browser.find("#point")
    browser.until(lambda: browser.hover(cloud, 0.5, 0.5) or point.get_attribute("value"))
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
    browser: Browser, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    opened(browser, observer.url, robots, "still", scene.frame())
    cloud = cloud_of(browser, robots, "still", scene.frame())
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


def test_a_cloud_that_is_left_is_so_for_the_browser(browser: Browser, picture: WebElement) -> None:
    """Of such contexts it has sixteen, and holds the memory of all of them."""
    browser.press("3D")
    script = "arguments[0].addEventListener('webglcontextlost', () => (window.lost = true))"
    browser.driver.execute_script(script, browser.find("#cloud"))
    browser.press("← all robots")
    browser.until(lambda: browser.driver.execute_script("return window.lost"))


def test_a_frame_that_came_without_its_depth_has_no_cloud(
    browser: Browser, observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    """As it was fetched before anybody asked for 3D; not that of another frame, and a reason."""
    opened(browser, observer.url, robots, "still", scene.frame())
    browser.press("stop")
    browser.press("3D")
    assert "older" in browser.find("#no-cloud").text
    browser.press("stop")
    browser.press("3D")
    cloud = cloud_of(browser, robots, "still", scene.frame())
    assert browser.text("#no-cloud") == ""
    browser.until(lambda: browser.press("◀") or browser.text("#no-cloud"))
    browser.until(lambda: browser.drawn(cloud)[:, :, :3].max() == 0)


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
    opened(browser, observer.url, robots, "wall", frame)
    drawn = browser.drawn(cloud_of(browser, robots, "wall", frame)).astype(int)
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


def test_a_browser_without_3d_is_told(observer: ObserverProcess, sending: Sending) -> None:
    browser = Browser("--disable-3d-apis")
    try:
        browser.log_in(observer.url, OBSERVERS["ann"][0])
        browser.find("[data-robot=kitchen-1] button").click()
        browser.find("#picture[data-id]")
        browser.press("3D")
        browser.until(lambda: "no WebGL 2" in browser.text("#picked.bad"))
        assert browser.find(".bar [title='key 3']").get_attribute("aria-pressed") == "false"
        assert not browser.all("#cloud")
    finally:
        browser.close()
