"""From a finished scan to a bore's diameter with U, in a real browser."""

from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from tests.bench.faults.served import HALF, HALF_SIZE, prepare
from tests.e2e.conftest import Demo
from tests.e2e.fits import misfits
from tests.e2e.visit import Visit
from tests.parts.draws import Setting, first_setting
from tests.parts.picks import scan_bracket
from tests.present import present

pytestmark = [pytest.mark.device, pytest.mark.soak]

MOST_CLICKS = 4


def add_bracket(data: Path, setting: Setting) -> None:
    """A finished scan of a bracket on another arm, with its calibration."""
    with closing(Store(data)) as store:
        folder, calibration = data / "scans" / "bracket", data / "sessions" / "bracket"
        folder.mkdir(parents=True)
        calibration.mkdir(parents=True)
        scan_bracket(folder, setting, 5)
        for name in ("calibration.json", "arm.json"):
            (folder / name).rename(calibration / name)
        figures = {"total_um": 30.0, "verdict": "good", "object_serial": "", "sensor_serial": ""}
        store.journal.begin_session("bracket", "calibration")
        file = calibration / "calibration.json"
        store.calibrations.accept(
            "bracket", "Seven axes", file, figures | {"arm_serial": "P-7"}, None
        )
        store.scans.add(
            ScanRecord(
                "bracket", "Bracket", folder, "2026-11-21T10:00:00", 100_000, 900, 9.0, "bracket"
            )
        )


@pytest.fixture(scope="module")
def station(fork_server: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    data = tmp_path_factory.mktemp("measure") / "data"
    data.mkdir()
    add_bracket(data, first_setting())
    prepare(data, HALF)
    running = Demo(data, ("tests.bench.faults.served", str(data), *HALF_SIZE))
    yield running
    running.end()


@dataclass
class Operator:
    """Counts what a person presses and draws."""

    page: Page
    clicks: int = 0

    def press(self, button: Locator) -> None:
        """Presses a button."""
        button.click()
        self.clicks += 1

    def draw(self, left: float, top: float, right: float, bottom: float) -> None:
        """Draws a rectangle over the picture, in shares of it."""
        area = present(self.page.locator("iframe").bounding_box())
        x, y, w, h = area["x"], area["y"], area["width"], area["height"]
        self.page.mouse.move(x + left * w, y + top * h)
        self.page.mouse.down()
        self.page.mouse.move(x + right * w, y + bottom * h, steps=5)
        self.page.mouse.up()
        self.clicks += 1


def show_bracket(visit: Visit, link: str) -> None:
    """The Scan page with the finished scan, seen from above."""
    page = visit.page
    page.goto(link)
    page.get_by_role("link", name="Scan", exact=True).click()
    page.get_by_role("button", name="Scans", exact=True).click()
    shown = page.get_by_role("switch", name="Bracket")
    if not shown.is_checked():
        shown.click()
    visit.wait_until(
        "the scan shown", "/api/view", lambda view: [one["loaded"] for one in view["scans"]] == [1]
    )
    page.get_by_role("button", name="Scans", exact=True).click()
    page.get_by_role("button", name="Above", exact=True).click()
    page.get_by_role("button", name="Whole", exact=True).click()
    page.wait_for_timeout(1000)


BORE = (0.278, 0.485)
"""Where it is in the picture from above, in shares of it."""
UPRIGHT_BORE, UPRIGHT_BALL = (0.311, 0.486), (0.61, 0.348)
"""In an upright window."""


def draw_around(operator: Operator, at: tuple[float, float], half: float) -> None:
    """A rectangle about a place in the picture."""
    x, y = at
    operator.draw(x - half, y - half, x + half, y + half)


def wait_for_cards(visit: Visit, name: str, count: int) -> list[dict[str, Any]]:
    """The elements or relations, once there are so many and nothing is being fitted."""
    visit.wait_until(name, "/api/view", lambda view: len(view[name]) == count and not view["busy"])
    return list(visit.ask("/api/view")[name])


def test_a_newcomer_gets_a_diameter_with_u_in_few_clicks(
    station: Demo, browser: Browser, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    visit = Visit(page, screenshots)
    show_bracket(visit, station.link)
    operator = Operator(page)
    operator.press(page.get_by_role("button", name="Measure", exact=True))
    visit.look("measure-panel")
    operator.press(page.get_by_role("button", name="Cylinder", exact=True))
    draw_around(operator, BORE, 0.055)
    (bore,) = wait_for_cards(visit, "fits", 1)
    card = page.get_by_role("article")
    expect(card.get_by_text("Diameter").first).to_be_visible()
    expect(card.get_by_text("k = 2").first).to_be_visible()
    assert operator.clicks <= MOST_CLICKS
    diameter = bore["figures"][0]
    true_mm = first_setting().true.bores[2].diameter_mm
    assert 0.005 < diameter["expanded"] < 0.06
    assert abs(diameter["value"] - true_mm) < 2 * diameter["expanded"]
    whole = sum(share["expanded"] ** 2 for share in diameter["shares"])
    assert whole == pytest.approx(diameter["expanded"] ** 2, rel=0.01)
    visit.look("measure-bore")
    page.get_by_text("What U is made of").click()
    expect(page.get_by_text("Calibration of the sensor")).to_be_visible()
    visit.look("measure-budget")
    assert not misfits(page)
    page.close()
    assert not visit.faults, "\n".join(visit.faults)


def test_dimensions_between_shapes_are_measured_removed_and_brought_back(
    station: Demo, browser: Browser, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 820, "height": 1180}, color_scheme="dark")
    visit = Visit(page, screenshots)
    show_bracket(visit, station.link)
    page.get_by_role("button", name="Measure", exact=True).click()
    while visit.ask("/api/view")["fits"]:  # of other tests
        page.get_by_role("button", name="Remove").first.click()
        page.wait_for_timeout(300)
    operator = Operator(page)
    picks = (("Cylinder", UPRIGHT_BORE), ("Sphere", UPRIGHT_BALL))
    for count, (shape, at) in enumerate(picks, 1):
        operator.press(page.get_by_role("button", name=shape, exact=True))
        draw_around(operator, at, 0.05)
        found = wait_for_cards(visit, "fits", count)
    assert [one["shape"] for one in found] == ["cylinder", "sphere"]
    page.get_by_role("button", name="Measure between").click()
    (relation,) = wait_for_cards(visit, "relations", 1)
    true = first_setting().true
    bore, ball = true.bores[2], true.ball
    distance = relation["figures"][0]
    away = float(np.hypot(bore.x_mm - ball[0], bore.y_mm - ball[1]))
    assert abs(distance["value"] - away) < 2 * distance["expanded"]
    visit.look("measure-between")
    page.get_by_role("button", name="Remove Cylinder").first.click()
    wait_for_cards(visit, "relations", 0)
    page.get_by_role("button", name="Undo").click()
    wait_for_cards(visit, "relations", 1)
    assert len(visit.ask("/api/view")["fits"]) == 2
    page.close()
    assert not visit.faults, "\n".join(visit.faults)
