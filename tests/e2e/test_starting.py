"""The page that is there from the first second, and becomes the client by itself."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.conftest import NEWCOMER, PATIENCE_S, Demo

pytestmark = pytest.mark.device


def test_the_starting_page_becomes_the_client(
    browser: Browser, pictures: Path, tmp_path: Path
) -> None:
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


def test_the_starting_page_says_that_the_station_did_not_start(
    browser: Browser, tmp_path: Path
) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "arms").write_text("not a folder")
    demo = Demo(tmp_path / "data", patient=False)
    page = browser.new_page()
    page.goto(demo.link)
    heading = page.get_by_role("alert").get_by_role("heading", name="The station did not start")
    expect(heading).to_be_visible()
    page.close()
    # it ends by itself; a signal on its way out would be its exit status
    assert demo.process.wait(PATIENCE_S) == 1
    demo.end()
    assert len(demo.errors) == 1, demo.errors
