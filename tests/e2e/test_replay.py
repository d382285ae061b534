"""A recording shown again in a real browser, from the link that the command prints."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.cli.test_replay import scan
from tests.datasheets import write_arm
from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit
from tests.forked import COMMAND_LINE
from tests.formats.builders import ARM
from tests.formats.test_documents import calibration_file

pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_a_replay_comes_first(browser: Browser, screenshots: Path | None, tmp_path: Path) -> None:
    calibration_file().write(tmp_path / "calibration.json")
    write_arm(tmp_path / "arm.json", ARM)
    recording = str(scan(tmp_path / "scan.mcap", images=True))
    demo = Demo(tmp_path, (COMMAND_LINE, "replay", recording, "--no-open", "--port", "0"))
    try:
        visit = Visit(browser.new_page(viewport={"width": 1024, "height": 768}), screenshots)
        visit.page.goto(demo.link)
        expect(visit.page.get_by_role("heading", name="The replay has ended")).to_be_visible()
        visit.look("replay")
        visit.page.close()
    finally:
        demo.end()
    assert not visit.faults, "\n".join(visit.faults)
