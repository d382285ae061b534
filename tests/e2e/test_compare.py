"""A newcomer compares a finished scan with a dropped STL in a browser, in six clicks at most."""

import base64
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from crenel.store.store import Store
from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit
from tests.parts.plate_scans import add_plate_scan, write_plate

pytestmark = [pytest.mark.device, pytest.mark.soak]
MOST_CLICKS = 6
SHOWN_MS = 1000
"""An answer is on the screen by then."""
DROP = """(target, [name, content]) => {
  const bytes = Uint8Array.from(atob(content), one => one.charCodeAt(0));
  const files = new DataTransfer();
  files.items.add(new File([bytes], name));
  for (const kind of ["dragover", "drop"])
    target.dispatchEvent(new DragEvent(kind, { bubbles: true, dataTransfer: files }));
}"""


@pytest.fixture(scope="module")
def station(fork_server: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    """A station with a finished scan."""
    data = tmp_path_factory.mktemp("station") / "data"
    store = Store(data)
    add_plate_scan(store, "plate")
    store.close()
    running = Demo(data)
    yield running
    running.end()


class Hand:
    """Counts clicks."""

    def __init__(self) -> None:
        self.clicks = 0

    def click(self, what: Locator) -> None:
        what.click()
        self.clicks += 1


def open_scan_page(visit: Visit, station: Demo) -> None:
    page = visit.page
    page.goto(station.link)
    page.get_by_role("link", name="Scan", exact=True).click()
    if not visit.ask("/api/view")["scans"]:
        page.get_by_role("button", name="Scans", exact=True).click()
        page.get_by_role("switch", name="Plate 1").click()
    loaded = [1.0]
    visit.wait_until(
        "the cloud", "/api/view", lambda view: [one["loaded"] for one in view["scans"]] == loaded
    )


def drop(page: Page, path: Path) -> None:
    content = base64.b64encode(path.read_bytes()).decode()
    target = page.get_by_text("Drop the file of the part here")
    target.evaluate(DROP, [path.name, content])


def tap_the_part(page: Page) -> Locator:
    """Taps the picture from its middle downwards until a cell is met; what the panel says of it."""
    picture = page.locator("iframe").bounding_box()
    assert picture is not None
    place = page.get_by_role("article", name="Tapped place")
    for down in (0.62, 0.55, 0.58, 0.66, 0.5):
        with page.expect_response("**/deviation/place"):
            page.mouse.click(
                picture["x"] + 0.5 * picture["width"], picture["y"] + down * picture["height"]
            )
        page.wait_for_timeout(SHOWN_MS)
        if place.get_by_text("U = ").is_visible():
            return place
    raise AssertionError("no place of the picture is a cell")


def test_a_newcomer_sees_the_map_in_six_clicks(
    browser: Browser, station: Demo, tmp_path: Path, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800}, locale="en-US")
    visit = Visit(page, screenshots)
    open_scan_page(visit, station)
    hand = Hand()
    hand.click(page.get_by_role("button", name="Compare", exact=True))
    visit.look("compare-empty")
    drop(page, write_plate(tmp_path / "plate.stl"))
    hand.clicks += 1
    expect(page.get_by_text("The file states no unit")).to_be_visible(timeout=60_000)
    compare = page.locator("[data-panel]").get_by_role("button", name="Compare", exact=True)
    expect(compare).to_be_disabled()
    expect(page.get_by_text("The scan:")).to_be_visible()
    visit.look("compare-unit")
    hand.click(page.get_by_role("radio", name="mm 120"))
    page.get_by_label("Lower", exact=True).fill("-0.04")
    page.get_by_label("Upper", exact=True).fill("0.04")
    hand.click(compare)
    expect(page.get_by_role("button", name="Cancel")).to_be_visible()
    visit.look("compare-running")
    expect(page.get_by_text("Out of tolerance")).to_be_visible()
    assert hand.clicks <= MOST_CLICKS
    expect(page.locator("[data-map-legend]")).to_contain_text("undecided")
    visit.look("compare-significance")
    page.locator("[data-panel]").get_by_text("Deviation", exact=True).click()
    expect(page.locator("[data-map-legend]")).to_contain_text("80")
    visit.look("compare-deviation")

    place = tap_the_part(page)
    expect(place).to_contain_text("U = ")
    expect(place).to_contain_text("would help most")
    visit.look("compare-place")

    page.locator("[data-panel]").get_by_text("Cloud", exact=True).click()
    visit.wait_until("the cloud", "/api/view", lambda view: view["surface_of"] == "")
    page.reload()
    page.get_by_role("button", name="Compare", exact=True).click()
    expect(page.get_by_text("Out of tolerance")).to_be_visible()
    with page.expect_download() as saved:
        page.get_by_role("link", name="Map (PLY)").click()
    assert saved.value.path().read_bytes().startswith(b"ply\n")
    assert not visit.faults
