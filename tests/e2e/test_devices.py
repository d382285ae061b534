"""From the demonstration's first page to a camera of one's own, in a real browser."""

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from unittest.mock import patch

import cv2
import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

from crenel.formats.datasheets.sensor import read_sensor
from crenel.settings.station_toml import read_settings
from tests.e2e.conftest import NEWCOMER, Demo
from tests.e2e.test_access_for_all import in_both_themes
from tests.e2e.visit import Visit
from tests.hardware.fake_cameras import AravisFake, port_for_this_test
from tests.hardware.test_registry import install

pytestmark = pytest.mark.device

MOST_CLICKS = 6
COUNT_CLICKS = """
window.clicks = 0;
document.addEventListener('click', () => { window.clicks += 1; }, true);
"""
FINDER = """
from crenel_hardware.discovery import FoundDevice
from crenel_hardware.errors import DeviceError

def find():
    return [
        FoundDevice("sensor", "folder", "Bench camera · AB-1", {{"path": {folder!r}}}),
        DeviceError("The library libbench is missing", "Run: sudo apt install libbench"),
    ]
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The pictures of the camera: no camera is connected to a machine that tests."""
    made = tmp_path_factory.mktemp("pictures")
    for index in range(20):
        image = np.full((600, 800), 40, np.uint8)
        cv2.circle(image, (100 + 30 * index, 300), 80, 220, -1)
        cv2.imwrite(str(made / f"{index}.png"), image)
    return made


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory, folder: Path) -> Iterator[Demo]:
    """A demonstration beside a package that finds a camera."""
    site = tmp_path_factory.mktemp("site")
    (site / "bench_finder.py").write_text(FINDER.format(folder=str(folder)))
    install(site, "bench-finder", "crenel.finders", "bench = bench_finder:find")
    paths = [str(site), *filter(None, [os.environ.get("PYTHONPATH")])]
    data = tmp_path_factory.mktemp("demo") / "data"
    with patch.dict(os.environ, PYTHONPATH=os.pathsep.join(paths)):
        running = Demo(data, (*NEWCOMER, "--port", "0", "--data", str(data)))
    yield running
    running.end()


def clicks(page: Page) -> int:
    return int(page.evaluate("window.clicks"))


def test_an_industrial_camera_is_in_use(station: Demo, browser: Browser, pictures: Path) -> None:
    with port_for_this_test():
        camera = AravisFake()
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        try:
            connect_the_industrial_camera(station, page, pictures)
        finally:
            page.close()
            camera.stop()


def connect_the_industrial_camera(station: Demo, page: Page, pictures: Path) -> None:
    """From the first page to the camera in use, and back to the simulated one."""
    page.add_init_script(COUNT_CLICKS)
    visit = Visit(page)
    page.goto(station.link)
    page.get_by_role("button", name="Connect your own devices").click()
    row = page.get_by_role("listitem").filter(has_text="127.0.0.1")
    row.get_by_role("button", name="Try").click()
    picture = page.get_by_role("img", name="Live picture of the camera")
    expect(picture).to_be_visible()
    expect(page.get_by_text("device clock", exact=True)).to_be_visible()
    page.get_by_text("More options").click()
    formats = page.get_by_label("Pixel format").get_by_role("option")
    expect(formats.filter(has_text="Mono16")).to_have_count(1)
    expect(page.get_by_text("at most 0, 0, 2048, 2048")).to_be_visible()
    page.screenshot(path=pictures / "devices-industrial.png")
    page.get_by_role("button", name="Use this camera").click()
    expect(page.get_by_role("heading", name="The camera is chosen")).to_be_visible()
    assert clicks(page) <= MOST_CLICKS
    visit.wait_until("used", "/api/devices", is_used("genicam"))
    assert read_settings(station.data / "station.toml").devices["sensor"].options == {
        "address": "127.0.0.1"
    }
    page.get_by_role("button", name="Use the simulated one again").click()
    visit.wait_until(
        "simulated again", "/api/devices", lambda now: bool(now["devices"][1]["simulated"])
    )
    assert not visit.faults


def is_used(driver: str) -> Callable[[dict[str, Any]], bool]:
    """Whether the station's camera is connected, and has this driver."""

    def look(view: dict[str, Any]) -> bool:
        camera = view["devices"][1]
        return bool(camera["state"]["state"] == "connected" and camera["driver"] == driver)

    return look


def test_a_camera_is_in_use(station: Demo, browser: Browser, pictures: Path, folder: Path) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.add_init_script(COUNT_CLICKS)
    visit = Visit(page)
    page.goto(station.link)
    page.get_by_role("button", name="Connect your own devices").click()

    expect(page.get_by_text("sudo apt install libbench")).to_be_visible()
    camera = page.get_by_role("listitem").filter(has_text="Bench camera")
    camera.get_by_role("button", name="Try").click()
    picture = page.get_by_role("img", name="Live picture of the camera")
    expect(picture).to_be_visible()
    first = picture.get_attribute("src")
    expect(picture).not_to_have_attribute("src", first or "")
    expect(page.get_by_text("800 × 600")).to_be_visible()
    expect(page.get_by_text("arrival", exact=True)).to_be_visible()

    page.get_by_role("button", name="Use this camera").click()
    expect(page.get_by_role("heading", name="The camera is chosen")).to_be_visible()
    page.get_by_role("button", name="Left to right").click()
    expect(page.get_by_role("button", name="Left to right")).to_be_hidden()
    (datasheet,) = (station.data / "sensors").glob("*800x600.json")
    assert read_sensor(datasheet).stripe_axis == "u"
    assert clicks(page) <= MOST_CLICKS
    print(f"connected in {clicks(page)} clicks")

    visit.wait_until(
        "used",
        "/api/devices",
        lambda now: (
            now["devices"][1]["state"]["state"] == "connected"
            and now["devices"][1]["driver"] == "folder"
        ),
    )
    chosen = read_settings(station.data / "station.toml").devices
    assert chosen["sensor"].options == {"path": str(folder)}
    assert "arm" not in chosen
    expect(camera.get_by_text("In use")).to_be_visible()
    page.screenshot(path=pictures / "devices.png")

    camera.get_by_role("button", name="Show").click()
    expect(page.get_by_text("The station uses this device already.")).to_be_visible()
    expect(page.get_by_role("button", name="Save changes")).to_be_disabled()
    page.get_by_label("Name", exact=True).fill("Left camera")
    page.get_by_text("More options").click()
    page.get_by_label("Rate (Hz)").fill("10")
    page.get_by_role("button", name="Save changes").click()
    expect(page.get_by_text("Left camera · ")).to_be_visible()
    changed = read_settings(station.data / "station.toml").devices["sensor"]
    assert (changed.label, changed.options["rate_hz"]) == ("Left camera", 10)

    page.get_by_role("button", name="Use the simulated one again").click()
    visit.wait_until(
        "simulated again", "/api/devices", lambda now: bool(now["devices"][1]["simulated"])
    )
    assert read_settings(station.data / "station.toml").devices == {}
    assert not visit.faults
    page.close()


def test_a_wrong_address_can_be_corrected(station: Demo, browser: Browser, folder: Path) -> None:
    page = browser.new_page(viewport={"width": 820, "height": 1180})
    page.goto(station.link)
    page.get_by_role("button", name="Connect your own devices").click()
    page.get_by_role("button", name="My camera is not listed").click()
    page.get_by_label("Connection").select_option("folder")
    expect(page.get_by_text("Fill in the address first")).to_be_visible()
    page.get_by_label("Folder", exact=True).fill(str(folder / "nowhere"))
    expect(page.get_by_text("Fill in the address first")).to_be_hidden()
    page.get_by_role("button", name="Try this device").click()
    alert = page.get_by_role("alert").filter(has_text="nowhere")
    expect(alert).to_be_visible()
    expect(page.get_by_role("button", name="Use this camera")).to_be_disabled()
    page.get_by_label("Folder", exact=True).fill(str(folder))
    page.get_by_role("button", name="Try again").click()
    picture = page.get_by_role("img", name="Live picture of the camera")
    expect(picture).to_be_visible()
    expect(page.get_by_role("button", name="Use this camera")).to_be_enabled()
    page.close()


def test_a_trial_ends_with_its_page(station: Demo, browser: Browser) -> None:
    page = browser.new_page()
    page.goto(station.link)
    page.get_by_role("button", name="Connect your own devices").click()
    camera = page.get_by_role("listitem").filter(has_text="Bench camera")
    camera.get_by_role("button", name="Try").click()
    expect(page.get_by_role("img", name="Live picture of the camera")).to_be_visible()
    page.get_by_role("link", name="Home").click()
    ended = """async () => {
      const end = Date.now() + 240000;
      while (await (await fetch("/api/devices/trial")).json() !== null) {
        if (Date.now() > end) return false;
      }
      return true;
    }"""
    assert page.evaluate(ended)
    page.close()


def test_the_page_is_for_everyone(station: Demo, browser: Browser) -> None:
    page = browser.new_page(viewport={"width": 1180, "height": 820})
    page.goto(station.link)
    page.get_by_role("button", name="Connect your own devices").click()
    camera = page.get_by_role("listitem").filter(has_text="Bench camera")
    camera.wait_for()
    found = in_both_themes(page, "devices, found")
    page.get_by_role("button", name="My arm is not listed").press("Enter")
    page.get_by_text("More options").press("Enter")
    found += in_both_themes(page, "devices, by hand")
    page.get_by_role("button", name="Back to the list").press("Enter")
    camera.get_by_role("button", name="Try").press("Enter")
    page.get_by_role("img", name="Live picture of the camera").wait_for()
    found += in_both_themes(page, "devices, trial")
    assert not found, "\n".join(found)
    page.close()
