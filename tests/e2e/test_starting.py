"""The page that is there from the first second, becomes the client, and awaits the sign-in."""

import threading
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from crenel.errors import OperationError
from tests.api.test_starting import Station, served, starting_with
from tests.e2e.conftest import NEWCOMER, Demo
from tests.e2e.visit import Visit

pytestmark = pytest.mark.device

SLOW_SIGN_IN = """
    const send = window.fetch;
    window.fetch = async (path, init) => {
        if (String(path).endsWith("/session/code")) await new Promise((go) => setTimeout(go, 3000));
        return send(path, init);
    };
"""


def test_it_becomes_the_client(browser: Browser, pictures: Path, tmp_path: Path) -> None:
    data = str(tmp_path / "data")
    demo = Demo(tmp_path, (*NEWCOMER, "--port", "0", "--data", data), patient=False)
    try:
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        faults: list[str] = []
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda line: faults.append(line.text) if line.type == "error" else None)
        page.goto(demo.link)
        expect(page.get_by_role("heading", name="Starting the station")).to_be_visible()
        expect(page.get_by_role("listitem").filter(has_text="Data folder")).to_be_visible()
        page.screenshot(path=pictures / "starting.png")
        # nobody reloads: the link's code lets the guest in once the station is ready
        calibrate = page.get_by_role("button", name="Calibrate")
        expect(calibrate).to_be_visible()
        assert not faults, "\n".join(faults)
        page.close()
        assert demo.end() in (0, 130)
        assert not demo.complaints, "".join(demo.complaints)
    finally:
        demo.end()


def test_it_says_that_the_station_did_not_start(browser: Browser) -> None:
    gate = threading.Event()

    def refuse() -> None:
        gate.wait()
        raise OperationError("file-is-no-folder", "data/arms is no folder")

    with served(starting_with(refuse, Station())) as (http, _):
        page = browser.new_page()
        page.goto(str(http.base_url))
        expect(page.get_by_role("heading", name="Starting the station")).to_be_visible()
        gate.set()
        alert = page.get_by_role("alert")
        expect(alert.get_by_role("heading", name="The station did not start")).to_be_visible()
        page.close()


def test_it_waits_for_the_sign_in(browser: Browser, demo: Demo) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    visit = Visit(page)
    page.add_init_script(SLOW_SIGN_IN)
    page.goto(demo.link)
    page.get_by_role("link", name="Performance").click()
    page.get_by_role("button", name="Contact tests", exact=True).click()
    page.get_by_role("button", name="Start the test").click()
    expect(page.get_by_role("radio", name="Without a sphere")).to_be_visible()
    assert not visit.faults, "\n".join(visit.faults)
    page.close()
