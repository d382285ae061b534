"""A newcomer's path through the demo, in a real browser: a simulated calibration, then scanning."""

import re
from collections.abc import Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from playwright.sync_api import Browser, expect
from playwright.sync_api import TimeoutError as TooLateError

from crenel.formats.clouds.files import read_cloud
from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit, is_at, is_verifying, take_poses
from tests.present import present

pytestmark = pytest.mark.device

LARGEST_FIRST_PAGE = 400_000
"""Bytes that travel, compressed."""
STEPS = ("devices", "setup", "touch", "place", "capture", "solve")
REACHED = (*STEPS, "review")


def look_at_the_record(visit: Visit) -> None:
    """The accepted calibration as a page of its own, and its report in a tab of its own."""
    page = visit.page
    page.get_by_role("button", name="Calibrations").click()
    page.get_by_role("button", name="Open").first.click()
    expect(page.get_by_text("In use.")).to_be_visible()
    page.get_by_text("Poses", exact=True).click()
    expect(page.get_by_text("detected minus computed")).to_be_visible()
    visit.look("calibration-record")
    with page.expect_popup() as opened:
        page.get_by_role("link", name="Report", exact=True).click()
    report = opened.value
    expect(report.get_by_role("heading", name="Calibration report")).to_be_visible()
    expect(report.get_by_role("img", name="Error budget")).to_be_visible()
    report.close()
    page.get_by_role("button", name="All records").click()


@pytest.fixture
def demo(tmp_path: Path) -> Iterator[Demo]:
    """The demonstration with a simulated operator that is eight times as quick."""
    data = tmp_path / "data"
    running = Demo(data, ("tests.e2e.quick_station", str(data), "--width", "800"))
    yield running
    running.end()


def test_the_whole_path_from_the_first_page_to_a_saved_cloud(
    demo: Demo, browser: Browser, screenshots: Path | None, tmp_path: Path
) -> None:
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    visit = Visit(page, screenshots)
    page.goto(demo.link)
    page.get_by_role("button", name="Calibrate").click()
    page.get_by_role("button", name="Start calibration").click()
    calibrate(visit)
    verify(visit)
    scan(visit, tmp_path)
    page.get_by_role("link", name="Records").click()
    expect(page.get_by_text("active")).to_be_visible()
    visit.look("records")
    look_at_the_record(visit)
    page.get_by_role("button", name="Verifications").click()
    page.get_by_role("button", name="Open").first.click()
    expect(page.get_by_text("Passed").or_(page.get_by_text("Undecided")).first).to_be_visible()
    page.get_by_role("link", name="Home").click()
    visit.look("home")
    page.close()
    assert not visit.faults, "\n".join(visit.faults)
    assert demo.end() in (0, 130)
    assert not demo.complaints, "".join(demo.complaints)


def test_one_click_goes_from_the_first_page_to_a_cloud(
    demo: Demo, browser: Browser, screenshots: Path | None
) -> None:
    """The first page is small; the demonstration pauses with a count-down where a person decides,
    and the page follows."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    visit = Visit(page, screenshots)
    network = page.context.new_cdp_session(page)
    network.send("Network.enable")
    arrived: list[int] = []
    network.on("Network.loadingFinished", lambda one: arrived.append(one["encodedDataLength"]))
    page.goto(demo.link)
    everything = page.get_by_role("button", name="Let the simulated operator do everything")
    expect(everything).to_be_enabled()
    assert 50_000 < sum(arrived) < LARGEST_FIRST_PAGE
    everything.click()
    for step in REACHED:
        visit.wait_until(f"step {step}", "/api/flow", partial(has_reached, step))
    expect(page.get_by_text("The simulated operator accepts this calibration.")).to_be_visible()
    expect(page.get_by_role("timer")).to_be_visible()
    expect(page.get_by_role("button", name="Stop the demonstration")).to_be_visible()
    visit.look("count-down")
    expect(page.get_by_role("heading", name="The scan is saved")).to_be_visible()
    expect(page.get_by_role("button", name="Stop the demonstration")).to_be_hidden()
    assert visit.ask("/api/scan")["points"] > 10000
    visit.look("demonstration-ended")
    page.close()
    assert not visit.faults, "\n".join(visit.faults)


def has_reached(step: str, view: dict[str, Any]) -> bool:
    return view["step"] in REACHED[REACHED.index(step) :]


def calibrate(visit: Visit) -> None:
    page = visit.page
    for step in STEPS:
        visit.wait_until(f"step {step}", "/api/flow", partial(is_at, step))
        visit.look(step)
        if step == "touch":
            page.get_by_role("button", name="Help").click()
            expect(page.get_by_text("The arm's main button takes a point.")).to_be_visible()
        page.get_by_role("button", name="Let the simulated operator do it").click()
        visit.look(f"{step}-by-the-operator")
    take_poses(visit)
    visit.look("review")
    for tab in ("Poses", "Map", "Error budget", "Numbers"):
        page.get_by_role("tab", name=tab).or_(page.get_by_text(tab, exact=True)).first.click()
        visit.look(f"review-{tab.lower().replace(' ', '-')}")
    set_aside_and_back(visit)
    result = visit.ask("/api/flow")["picture"]["result"]
    assert result["verdict"] == "good", visit.ask("/api/flow")["picture"]["findings"]
    assert 0 < result["total_um"] < 50
    page.get_by_role("button", name="Accept this calibration").click()
    page.wait_for_timeout(500)
    assert visit.ask("/api/home")["calibration"]["active"]


def verify(visit: Visit) -> None:
    """The calibration leads on to the gauge, which the simulated operator touches and scans."""
    page = visit.page
    page.get_by_role("button", name="Verify", exact=True).click()
    visit.look("verify")
    page.get_by_role("button", name="Start verification").click()
    for step in ("gauge", "touch", "scan"):
        visit.wait_until(f"verifying: {step}", "/api/verify", partial(is_verifying, step))
        visit.look(f"verify-{step}")
        page.get_by_role("button", name="Let the simulated operator do it").click()
        visit.look(f"verify-{step}-by-the-operator")
    visit.wait_until(
        "the verdict", "/api/verify", lambda view: view["step"] == "review" and view["busy"] is None
    )
    for tab in ("Map", "Clouds", "Numbers"):
        page.get_by_text(tab, exact=True).first.click()
        visit.look(f"verify-{tab.lower()}")
        if tab == "Map":
            page.get_by_role("button", name="the highest point of all").click()
            expect(page.get_by_text("mm of the arm; frame")).to_be_visible()
            visit.look("verify-map-highest-point")
    found = visit.ask("/api/verify")["picture"]
    assert found["verdict"]["result"] != "fail", found["figures"]
    assert len(found["clouds"]) >= 3
    page.get_by_role("button", name="Accept this verification").click()
    expect(page.get_by_role("button", name="Scan the part")).to_be_visible()
    page.get_by_text("Calibrations", exact=True).first.click()
    page.get_by_role("button", name="Rebuild with").click()
    expect(page.get_by_role("img", name="Angle between the normals")).to_be_visible()
    visit.look("verify-calibrations")
    page.get_by_role("button", name="Scan the part").click()


def set_aside_and_back(visit: Visit) -> None:
    """In the table of poses: the result is of before until it is solved again, or undone."""
    page = visit.page
    page.get_by_role("button", name="Exclude").first.click()
    expect(page.get_by_role("button", name="Compute again")).to_be_visible()
    visit.look("set-aside")
    assert visit.ask("/api/flow")["picture"]["stale"]
    page.get_by_role("button", name="Compute again").click()
    visit.wait_until("solving again", "/api/flow", lambda view: not view["picture"]["stale"])
    visit.wait_until("the review", "/api/flow", lambda view: view["busy"] is None)
    states = [pose["state"] for pose in visit.ask("/api/flow")["picture"]["poses"]]
    assert states[0] == "aside"
    page.get_by_role("button", name="Include").click()
    page.wait_for_timeout(500)
    page.get_by_role("button", name="Compute again").click()
    visit.wait_until("solving again", "/api/flow", lambda view: not view["picture"]["stale"])
    page.get_by_role("button", name="Show pose").first.click()
    expect(page.get_by_role("group", name="Poses")).to_be_visible()
    visit.look("a-pose-that-a-finding-names")


def scan(visit: Visit, folder: Path) -> None:
    page = visit.page
    page.get_by_role("link", name="Scan").click()
    start = page.get_by_role("button", name="Start scan")
    expect(start).to_be_enabled()
    visit.look("scan-ready")
    start.click()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until("scanning", "/api/scan", lambda scan: scan["points"] > 10000)
    visit.look("scanning")
    # on a busy machine the operator comes to the end before he is stopped
    with suppress(TooLateError):
        page.get_by_role("button", name="Stop the simulated operator").click(timeout=10_000)
    # or else he presses the arm's button after the scan was stopped, and begins another one
    visit.wait_until("the operator's end", "/api/scan", lambda scan: not scan["simulation_running"])
    with suppress(TooLateError):
        page.get_by_role("button", name="Stop the scan").click(timeout=10_000)
    visit.wait_until("stopping", "/api/scan", lambda scan: scan["state"] == "idle")
    visit.look("scanned")
    look_closer(visit, folder)
    page.get_by_role("link", name="Records").click()
    page.get_by_role("link", name="First part").click()
    visit.look("scan-record")
    with page.expect_download() as download:
        page.get_by_role("link", name="Save the cloud").click()
    saved = folder / "cloud.ply"
    download.value.save_as(saved)
    points = read_cloud(saved).points_mm
    assert len(points) > 10000
    assert np.isfinite(points).all()


def look_closer(visit: Visit, folder: Path) -> None:
    """Other colours, a plane fitted to what is drawn around, its deviations, a picture saved;
    points cut away, of the saved cloud too, and brought back."""
    page = visit.page
    page.get_by_role("button", name="Display").click()
    page.get_by_role("radio", name="Uncertainty").click()
    expect(page.get_by_role("figure")).to_contain_text("Uncertainty of a point")
    visit.look("uncertainty")
    page.get_by_role("button", name="Measure").click()
    page.get_by_role("button", name="Plane", exact=True).click()
    area = present(page.locator("iframe").bounding_box())
    page.mouse.move(area["x"] + 0.02 * area["width"], area["y"] + 0.3 * area["height"])
    page.mouse.down()
    page.mouse.move(area["x"] + 0.98 * area["width"], area["y"] + 0.98 * area["height"], steps=5)
    visit.look("drawing-a-rectangle")
    page.mouse.up()
    visit.wait_until("a plane", "/api/view", lambda view: bool(view["fits"]))
    fitted = visit.ask("/api/view")["fits"][0]
    assert fitted["every"]
    assert fitted["points"] > 1000
    page.get_by_role("button", name="Colour by deviation").click()
    expect(page.get_by_role("figure")).to_contain_text("Deviation from the shape")
    visit.look("deviation")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save picture").click()
    saved = folder / "view.png"
    download.value.save_as(saved)
    picture = present(cv2.imread(str(saved)))
    assert picture.shape[0] > 500
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 300
    cut_and_save(visit, folder / "cut.xyz")
    rename_and_hide(visit)


def cut_and_save(visit: Visit, saved: Path) -> None:
    page = visit.page
    points = visit.ask("/api/scan")["points"]
    page.get_by_role("button", name="Cut", exact=True).click()
    page.get_by_role("button", name="Cut what is inside").click()
    area = present(page.locator("iframe").bounding_box())
    page.mouse.move(area["x"] + 0.5 * area["width"], area["y"] + 0.3 * area["height"])
    page.mouse.down()
    page.mouse.move(area["x"] + 0.98 * area["width"], area["y"] + 0.98 * area["height"], steps=5)
    page.mouse.up()
    visit.wait_until("a cut", "/api/view", lambda view: view["cuts"] == 1)
    visit.look("cut")
    page.get_by_label("File format").select_option("XYZ")
    with page.expect_download() as download:
        page.get_by_role("link", name="Save the cloud").click()
    download.value.save_as(saved)
    assert 0 < len(read_cloud(saved).points_mm) < points
    page.get_by_role("button", name="Undo the last cut").click()
    visit.wait_until("undone", "/api/view", lambda view: view["content"]["points_cut"] == 0)


def rename_and_hide(visit: Visit) -> None:
    page = visit.page
    page.get_by_role("button", name="Scans", exact=True).click()
    page.get_by_role("button", name="Rename").click()
    page.get_by_role("textbox").fill("First part")
    page.get_by_role("button", name="Save", exact=True).click()
    shown = page.get_by_role("switch", name=re.compile("First part"))
    expect(shown).to_be_checked()
    shown.click()
    expect(shown).not_to_be_checked()
    assert not visit.ask("/api/view")["scans"]
    shown.click()
    visit.wait_until(
        "the scan shown again",
        "/api/view",
        lambda view: any(scan["loaded"] == 1 for scan in view["scans"]),
    )
    page.get_by_role("button", name="Delete").click()
    visit.look("really-delete")
    page.get_by_role("button", name="No, keep it").click()
