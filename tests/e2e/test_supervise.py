"""The wall screen, several stations by a real broker, and the Health page."""

import os
import signal
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.e2e.conftest import ROOT, Demo
from tests.supervise.mosquitto import BINARY, Mosquitto

STATION = """
import socket, sys
from dataclasses import replace
from pathlib import Path
from app.demonstration import simulated_parts
from app.main import _listen, _run
from app.supervise.broker import BrokerSettings

listening = _listen("127.0.0.1", 0, 1)
with simulated_parts(Path(sys.argv[1]), ("127.0.0.1",)) as parts:
    broker = BrokerSettings("127.0.0.1", int(sys.argv[2]))
    watching = replace(parts.watching, mqtt=broker)
    _run(replace(parts, watching=watching), listening, "127.0.0.1", False)
"""


@pytest.fixture(scope="module")
def broker(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Mosquitto]:
    if BINARY is None:
        if os.environ.get("CI"):
            pytest.fail("mosquitto is not installed, and CI must run these tests")
        pytest.skip("mosquitto is not installed")
    with Mosquitto(tmp_path_factory.mktemp("broker")) as running:
        yield running


def page_of(browser: Browser, width: int, height: int) -> Page:
    return browser.new_context(
        viewport={"width": width, "height": height}, accept_downloads=True
    ).new_page()


def test_a_wall_shows_every_station_and_which_is_lost(
    browser: Browser, broker: Mosquitto, tmp_path: Path, pictures: Path
) -> None:
    demo = Demo(
        tmp_path / "data", [sys.executable, "-c", STATION, str(tmp_path / "data"), str(broker.port)]
    )
    other = [sys.executable, "-m", "tests.supervise.publishing", str(broker.port), "hall-3"]
    with subprocess.Popen(other, cwd=ROOT, stdout=subprocess.DEVNULL) as publishing:
        try:
            admin = page_of(browser, 1440, 900)
            admin.goto(demo.link)
            admin.get_by_role("link", name="Scan").click()
            admin.get_by_role("link", name="People").click()
            admin.get_by_label("New link").fill("Hall 3")
            admin.get_by_role("button", name="Make a link").click()
            wall = page_of(browser, 1920, 1080)
            wall.goto(admin.locator("code").inner_text())
            expect(wall.get_by_role("heading", name="Demonstration")).to_be_visible()
            expect(wall.get_by_text("Nothing runs")).to_be_visible()
            expect(wall.get_by_text("°C")).to_be_visible()
            wall.screenshot(path=pictures / "supervise-1-wall.png")
            wall.get_by_role("button", name="All 2").click()
            card = wall.get_by_role("listitem").filter(has_text="Hall-3")
            expect(card.get_by_text("live", exact=True)).to_be_visible()
            publishing.send_signal(signal.SIGSTOP)
            expect(card.get_by_text("lost for")).to_be_visible(timeout=5000)
            wall.screenshot(path=pictures / "supervise-2-lost.png")
            assert wall.evaluate("fetch('/api/logs').then(a => a.status)") == 403
        finally:
            publishing.kill()
            demo.end()


def test_the_health_page(browser: Browser, demo: Demo, pictures: Path) -> None:
    page = page_of(browser, 1440, 900)
    page.goto(demo.link)
    page.get_by_role("link", name="Health").click()
    expect(page.get_by_role("heading", name="Database")).to_have_count(0)
    expect(page.get_by_text("It is whole")).to_be_visible()
    page.get_by_role("button", name="Make a backup now").click()
    expect(page.get_by_text("It is on the same disk as the data.")).to_be_visible(timeout=20_000)
    page.screenshot(path=pictures / "health-1.png")
    with page.expect_download() as started:
        page.get_by_role("link", name="Save the support bundle").click()
    with zipfile.ZipFile(started.value.path()) as archive:
        assert "logs/station.jsonl" in archive.namelist()
    page.get_by_label("Words in it").fill("backup")
    expect(page.get_by_text("The backup is in").first).to_be_visible()
    page.get_by_label("New token").fill("Prometheus")
    page.get_by_role("button", name="Make a token").click()
    expect(page.locator("code").last).to_be_visible()
    page.screenshot(path=pictures / "health-2.png")
    page.context.close()
