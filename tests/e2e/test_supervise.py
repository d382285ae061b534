"""A kiosk, several stations by a real broker, the Health page, and the station's end."""

import asyncio
import json
import signal
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import aiomqtt
import pytest
from jsonschema import Draft202012Validator
from playwright.sync_api import Browser, Page, expect

from crenel.formats.recording.decoders import StripeRecord
from crenel.formats.recording.reader import open_recording
from crenel.store.store import Store
from crenel.supervision.messages import schema
from tests.bench.faults.broker.mosquitto import Mosquitto
from tests.e2e.conftest import PATIENCE_S, ROOT, Demo, wait_in_page
from tests.supervision.conftest import broker

__all__ = ["broker"]
pytestmark = [pytest.mark.device, pytest.mark.soak]

COLLECT_NOTIFICATIONS = """
const Plain = Notification;
window.notifications = [];
window.Notification = class extends Plain {
  constructor(title, options) {
    super(title, options);
    window.notifications.push(`${title}. ${options.body}`);
  }
};
"""


@pytest.fixture(scope="module")
def station(broker: Mosquitto, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    """It is ended by the last test of this module."""
    data = tmp_path_factory.mktemp("station") / "data"
    words = (str(data), str(broker.port))
    running = Demo(data, ("tests.e2e.watched_station", *words))
    yield running
    running.end()


@pytest.fixture(scope="module")
def admin(browser: Browser, station: Demo) -> Iterator[Page]:
    page = page_of(browser, 1440, 900)
    page.context.grant_permissions(["notifications"])
    page.add_init_script(COLLECT_NOTIFICATIONS)
    page.goto(station.link)
    yield page
    page.context.close()


@pytest.fixture(scope="module")
def kiosk(browser: Browser, admin: Page) -> Iterator[Page]:
    admin.get_by_role("link", name="People").click()
    admin.get_by_label("New link").fill("Hall 3")
    admin.get_by_role("button", name="Create link").click()
    page = page_of(browser, 1920, 1080)
    # without a graphics card the 3D view slows the page down: it is opened last
    page.add_init_script("localStorage.setItem('crenel-supervise', 'all')")
    page.goto(admin.locator("code").inner_text())
    yield page
    page.context.close()


def page_of(browser: Browser, width: int, height: int) -> Page:
    return browser.new_context(viewport={"width": width, "height": height}).new_page()


def test_a_kiosk_shows_every_station_and_which_is_lost(
    broker: Mosquitto, request: pytest.FixtureRequest, pictures: Path
) -> None:
    words = [sys.executable, "-m", "tests.supervision.publishing", str(broker.port), "hall-3"]
    with subprocess.Popen(words, cwd=ROOT, stdout=subprocess.DEVNULL) as other:
        try:
            kiosk: Page = request.getfixturevalue("kiosk")
            expect(kiosk.get_by_role("heading", name="All stations")).to_be_visible()
            expect(kiosk.get_by_role("heading", name="Demonstration")).to_be_visible()
            card = kiosk.get_by_role("listitem").filter(has_text="Hall-3")
            expect(card.get_by_text("live", exact=True)).to_be_visible()
            sensor = card.locator("div").filter(has=kiosk.get_by_text("right", exact=True)).last
            expect(sensor).to_contain_text("30 fps")
            expect(sensor).to_contain_text("12 lost, 0 corrupt · stamps: ")
            other.send_signal(signal.SIGSTOP)
            expect(card.get_by_text("lost for")).to_be_visible()
            kiosk.screenshot(path=pictures / "supervise-1-lost.png")
            assert kiosk.evaluate("fetch('/api/logs').then(a => a.status)") == 403
        finally:
            other.kill()


def test_the_health_page(admin: Page, pictures: Path) -> None:
    admin.get_by_role("link", name="Health").click()
    expect(admin.get_by_text("It is intact")).to_be_visible()
    admin.get_by_role("button", name="Back up now").click()
    expect(admin.get_by_text("It is on the same disk as the data.")).to_be_visible()
    admin.screenshot(path=pictures / "health-1.png")
    with admin.expect_download() as started:
        admin.get_by_role("link", name="Save the support bundle").click()
    with zipfile.ZipFile(started.value.path()) as archive:
        assert "logs/station.jsonl" in archive.namelist()
    admin.get_by_label("Search text").fill("backup")
    expect(admin.get_by_text("The backup is in").first).to_be_visible()
    admin.get_by_label("New token").fill("Prometheus")
    admin.get_by_role("button", name="Create token").click()
    expect(admin.get_by_text("It appears only once")).to_be_visible()
    admin.screenshot(path=pictures / "health-2.png")


def retained(broker: Mosquitto, kind: str) -> dict[str, object]:
    """What the broker keeps of the station; asked for on a thread of its own, without a browser."""

    async def ask() -> dict[str, object]:
        async with aiomqtt.Client("127.0.0.1", broker.port) as client:
            await client.subscribe(f"crenel/demonstration/{kind}")
            message = await anext(aiter(client.messages))
            return dict(json.loads(bytes(message.payload)))

    with ThreadPoolExecutor(1) as thread:
        return thread.submit(lambda: asyncio.run(asyncio.wait_for(ask(), PATIENCE_S))).result()


def test_what_the_station_publishes_is_as_the_schema_says(broker: Mosquitto, admin: Page) -> None:
    document = json.loads(json.dumps(schema()))
    for kind, shape in (("report", "StationReport"), ("presence", "Presence")):
        payload = retained(broker, kind)
        Draft202012Validator({**document, "$ref": f"#/$defs/{shape}"}).validate(payload)
        assert payload["name"] == "Demonstration"
    assert payload["state"] == "online"


def test_a_browser_notifies_once_it_is_turned_on(admin: Page) -> None:
    press = admin.get_by_role("button", name="Turn on notifications here")
    expect(press).to_be_visible()
    assert admin.evaluate("notifications.length") == 0
    press.click()
    expect(admin.get_by_role("button", name="Turn off notifications here")).to_be_visible()
    assert ask(admin, "scan/start") == 200
    assert ask(admin, "scan/stop") == 200
    wait_in_page(admin, "() => notifications.length > 0")
    (words,) = admin.evaluate("notifications")
    assert words.startswith("Demonstration: done. ")
    assert words.endswith("points saved")


def ask(page: Page, path: str, body: str = "{}") -> int:
    """The status of a request that this page makes."""
    headers = "{'Content-Type': 'application/json'}"
    asked = f"{{method: 'POST', headers: {headers}, body: '{body}'}}"
    return int(page.evaluate(f"fetch('/api/{path}', {asked}).then(a => a.status)"))


def test_it_ends_in_order_while_it_scans_and_is_watched(
    station: Demo, broker: Mosquitto, admin: Page, kiosk: Page, pictures: Path
) -> None:
    """Asked to end, with live sockets and a 3D view open, a scan running and recording."""
    kiosk.set_viewport_size({"width": 1120, "height": 630})  # it is drawn without a graphics card
    kiosk.get_by_role("button", name="This station").click()
    assert ask(admin, "scan/start") == 200
    assert ask(admin, "scan/simulation", '{"on": true}') == 200
    expect(kiosk.get_by_text("points/s")).to_be_visible()
    expect(kiosk.get_by_text("laser is on")).to_be_visible()
    kiosk.wait_for_timeout(1500)
    kiosk.screenshot(path=pictures / "supervise-2-scanning.png")
    station.process.send_signal(signal.SIGTERM)
    assert station.process.wait(PATIENCE_S) in (0, 128 + signal.SIGTERM, -signal.SIGTERM)
    assert retained(broker, "presence")["state"] == "off"
    expect(kiosk.get_by_text("no contact for")).to_be_visible()
    kiosk.screenshot(path=pictures / "supervise-3-ended.png")
    store = Store(station.data)
    scan, *_ = store.scans.all()
    recording = open_recording(scan.folder / "scan.mcap")
    stripes = sum(isinstance(record, StripeRecord) for record in recording.records())
    assert recording.cut == ""
    assert stripes == scan.frames > 0
    assert (scan.folder / "cloud.ply").is_file()
    assert store.check() == ""
    store.close()
