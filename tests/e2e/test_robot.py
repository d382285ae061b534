"""A robot station in a real browser: board calibration, scan and verification, by RTDE."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit, is_at, is_verifying, take_poses

pytestmark = pytest.mark.device


@pytest.fixture
def robot(tmp_path: Path) -> Iterator[Demo]:
    """The demonstration with a robot, eight times as quick."""
    data = tmp_path / "data"
    running = Demo(data, ("tests.e2e.quick_station", str(data), "--width", "800", "--robot"))
    yield running
    running.end()


@pytest.mark.soak
def test_a_whole_robot_station(robot: Demo, browser: Browser, screenshots: Path | None) -> None:
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    visit = Visit(page, screenshots)
    page.goto(robot.link)
    page.get_by_role("button", name="Calibrate").click()
    expect(page.get_by_text("Hold the sensor over a flat chessboard")).to_be_visible()
    visit.look("calibrate")
    page.get_by_role("button", name="Start calibration").click()
    for step in ("devices", "setup", "place", "capture"):
        visit.wait_until(f"step {step}", "/api/flow", partial(is_at, step))
        visit.look(step)
        page.get_by_role("button", name="Let the simulated operator do it").click()
        page.wait_for_timeout(500)
    take_poses(visit)
    visit.look("review")
    result = visit.ask("/api/flow")["picture"]["result"]
    assert result["verdict"] == "good", visit.ask("/api/flow")["picture"]["findings"]
    assert 0 < result["total_um"] < 50
    page.get_by_role("button", name="Accept this calibration").click()
    page.get_by_role("button", name="Verify", exact=True).click()
    expect(page.get_by_text("Scan a gauge plate or sphere a few times.")).to_be_visible()
    visit.look("verify")
    page.get_by_role("button", name="Start verification").click()
    for step in ("gauge", "scan"):
        visit.wait_until(f"verifying: {step}", "/api/verify", partial(is_verifying, step))
        visit.look(f"verify-{step}")
        page.get_by_role("button", name="Let the simulated operator do it").click()
        page.wait_for_timeout(1000)
    visit.wait_until(
        "the verdict", "/api/verify", lambda view: view["step"] == "review" and view["busy"] is None
    )
    visit.look("verified")
    assert visit.ask("/api/verify")["picture"]["verdict"]["result"] != "fail"
    page.get_by_role("button", name="Accept this verification").click()
    expect(page.get_by_role("button", name="Scan the part")).to_be_visible()
    page.get_by_role("button", name="Scan the part").click()
    start = page.get_by_role("button", name="Start scan")
    expect(start).to_be_enabled()
    start.click()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until("scanning", "/api/scan", lambda scan: scan["points"] > 10_000)
    visit.look("scanning")
    page.get_by_role("button", name="Stop the scan").click()
    visit.wait_until("stopping", "/api/scan", lambda scan: scan["state"] == "idle")
    page.close()
    assert not visit.faults, "\n".join(visit.faults)
    assert robot.end() in (0, 130)
    assert not robot.complaints, "".join(robot.complaints)
