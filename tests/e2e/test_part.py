"""The guided inspection in a real browser: the example part from the set-up to its record."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, FilePayload, expect
from typer.testing import CliRunner

from crenel.cli.main import cli
from tests.bench.faults.served import HALF, prepare
from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit
from tests.parts.known_calibration import add_covariance

pytestmark = [pytest.mark.device, pytest.mark.soak]

SIZES = {"desktop": (1280, 800), "tablet": (820, 1180)}


@pytest.fixture(scope="module")
def station(fork_server: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    """A simulated station whose calibration says how well sensor and arm are known."""
    data = tmp_path_factory.mktemp("part") / "data"
    prepare(data, HALF)
    for file in data.glob("sessions/*/calibration.json"):
        add_covariance(file)
    running = Demo(data)
    yield running
    running.end()


def look_at_both_sizes(visit: Visit, name: str) -> None:
    """Nothing is wider than the screen, on either."""
    for size, (width, height) in SIZES.items():
        visit.page.set_viewport_size({"width": width, "height": height})
        visit.look(f"part-{name}-{size}")
        assert visit.page.evaluate("document.documentElement.scrollWidth") <= width


def test_the_example_part_is_inspected(
    station: Demo, browser: Browser, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    visit = Visit(page, screenshots)
    page.goto(station.link)
    page.get_by_role("link", name="Part", exact=True).click()
    expect(page.get_by_role("heading", name="Is the part as its drawing wants it?")).to_be_visible()
    look_at_both_sizes(visit, "before")
    page.get_by_role("button", name="Start the inspection").click()
    expect(page.get_by_role("radio", name="Example plate")).to_be_checked()
    wrong = FilePayload(name="wrong.json", mimeType="application/json", buffer=b'{"format": 1}')
    page.locator("#program-file").set_input_files(wrong)
    expect(page.get_by_text("wrong.json").first).to_be_visible()
    page.get_by_label("Serial number of the part").fill("P-17")
    page.get_by_label("Operator", exact=True).fill("Ada")
    look_at_both_sizes(visit, "setup")
    page.get_by_role("button", name="The part is ready").click()
    page.get_by_role("heading", name="Datum A: plane").wait_for()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until("a datum", "/api/parts", lambda view: view["feature"] == "B")
    look_at_both_sizes(visit, "align")
    visit.wait_until(
        "features", "/api/parts", lambda view: view["step"] == "measure" and view["busy"] is None
    )
    expect(page.get_by_text("Part frame known to")).to_be_visible()
    page.get_by_role("button", name="sink").click()
    page.get_by_role("button", name="Skip this feature").click()
    page.get_by_label("Why is sink skipped?").fill("burr")
    page.get_by_role("button", name="Skip sink").click()
    expect(page.get_by_role("button", name="sink Skipped")).to_be_visible()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until(
        "a bore",
        "/api/parts",
        lambda view: view["feature"] == "H2" and len(view["dimensions"]) > 3,
    )
    expect(page.locator("li[data-dimension='d-H2']").get_by_text("Out")).to_be_visible()
    look_at_both_sizes(visit, "measure")
    page.emulate_media(color_scheme="dark")
    look_at_both_sizes(visit, "measure-dark")
    visit.wait_until("result", "/api/parts", lambda view: view["result"] is not None)
    look_at_both_sizes(visit, "review-dark")
    page.emulate_media(color_scheme="light")
    look_at_both_sizes(visit, "review")
    expect(page.get_by_text("At least one dimension fails")).to_be_visible()
    expect(page.locator("tr[data-dimension='d-H2']").get_by_text("Out")).to_be_visible()
    expect(page.get_by_text("Feature sink was skipped: burr")).to_be_visible()
    with page.expect_download() as saved:
        page.get_by_role("link", name="results.json").click()
    shown = Path(saved.value.path()).read_bytes()
    page.get_by_role("button", name="Finish the inspection").click()
    expect(page.get_by_role("heading", name="Inspections")).to_be_visible()
    look_at_both_sizes(visit, "list")
    page.get_by_role("button", name="Open").first.click()
    expect(page.get_by_text("P-17")).to_be_visible()
    look_at_both_sizes(visit, "record")
    page.get_by_role("link", name="Records").click()
    expect(page.get_by_role("region", name="Inspections").get_by_text("P-17")).to_be_visible()
    (folder,) = (station.data / "inspections").iterdir()
    by_command = folder / "again.json"
    CliRunner().invoke(cli, ["inspect", str(folder), "-o", str(by_command)])
    assert by_command.read_bytes() == shown
    assert not [fault for fault in visit.faults if "422" not in fault]
    page.close()
