"""How the performance tests begin in a real browser, at a station whose sensor is calibrated."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, FilePayload, Page, expect

from tests.bench.faults.served import HALF, prepare
from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit
from tests.gauges.exchange.certificates import DIAMETER, certificate

SIZES = {"desktop": (1280, 800), "tablet": (820, 1180)}


@pytest.fixture(scope="module")
def station(fork_server: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    """A simulated station whose sensor is calibrated, with a step gauge of a single length, too."""
    data = tmp_path_factory.mktemp("performance") / "data"
    prepare(data, HALF)
    gauge = json.loads((data / "gauges" / "step-gauge.json").read_text())
    short = {**gauge, "name": "Short gauge", "lengths": gauge["lengths"][-1:]}
    (data / "gauges" / "short.json").write_text(json.dumps(short))
    running = Demo(data)
    yield running
    running.end()


def look_at_both_sizes(visit: Visit, name: str) -> None:
    """Nothing is wider than the screen, on either."""
    for size, (width, height) in SIZES.items():
        visit.page.set_viewport_size({"width": width, "height": height})
        visit.look(f"performance-{name}-{size}")
        assert visit.page.evaluate("document.documentElement.scrollWidth") <= width


def visit_station(station: Demo, browser: Browser, screenshots: Path | None) -> Visit:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    visit = Visit(page, screenshots)
    page.goto(station.link)
    page.get_by_role("link", name="Performance").click()
    return visit


def begin_sphere_test(visit: Visit) -> None:
    """With the sphere of a certificate that is uploaded, and a limit that is typed in."""
    page = visit.page
    look_at_both_sizes(visit, "before")
    content = certificate(DIAMETER).encode()
    sphere = FilePayload(name="K-17.xml", mimeType="text/xml", buffer=content)
    page.locator("#certificate-file").set_input_files(sphere)
    expect(page.get_by_text("This sphere can be chosen")).to_be_visible()
    page.get_by_role("button", name="Start the test").click()
    expect(page.get_by_role("radio", name="Ceramic sphere")).to_be_visible()
    field = page.get_by_label("form of the touched sphere")
    expect(field).to_be_visible()
    field.fill("300")
    page.get_by_role("button", name="Set", exact=True).click()
    expect(page.get_by_role("button", name="Set", exact=True)).to_have_count(0)
    look_at_both_sizes(visit, "artefact")
    page.get_by_role("button", name="Let the simulated operator do everything").click()


def begin_length_test(visit: Visit) -> None:
    """Of a standard with one length, with limits and temperatures."""
    page = visit.page
    page.get_by_role("button", name="Lengths", exact=True).click()
    look_at_both_sizes(visit, "lengths-before")
    page.get_by_role("button", name="Start the test").click()
    page.get_by_role("radio", name="Simulated ball bar").click()
    page.get_by_role("button", name="By touch and by scan").click()
    expect(page.get_by_role("form", name="error of length by scan")).to_be_visible()
    look_at_both_sizes(visit, "lengths-by-scan")
    page.get_by_role("radio", name="Short gauge").click()
    expect(page.get_by_text("Only the spheres of a ball bar are measured by scan")).to_be_visible()
    for letter, value in (("A", "200"), ("K", "10"), ("B", "400")):
        page.get_by_label(letter, exact=True).fill(value)
    page.get_by_role("button", name="Set", exact=True).click()
    expect(page.get_by_role("button", name="Set", exact=True)).to_have_count(0)
    expect(page.get_by_text("The standard has only one length")).to_be_visible()
    set_temperatures(page, artefact=20.4, arm=21.0)
    look_at_both_sizes(visit, "lengths-artefact")
    page.get_by_role("button", name="The standard is ready").click()
    expect(page.get_by_role("button", name="Take the point")).to_be_visible()
    page.get_by_role("button", name="Let the simulated operator do it").click()


def begin_contact_test(visit: Visit) -> None:
    """Without a sphere."""
    page = visit.page
    page.get_by_role("button", name="Contact tests", exact=True).click()
    page.get_by_role("button", name="Start the test").click()
    page.get_by_role("radio", name="Without a sphere").click()
    expect(page.get_by_label("effective diameter")).to_have_count(0)
    expect(page.get_by_label("volumetric length, largest")).to_be_visible()
    look_at_both_sizes(visit, "contact-artefact")
    page.get_by_role("button", name="The artefacts are ready").click()
    expect(page.get_by_text("Clamp the seat near the shoulder")).to_be_visible()
    page.get_by_role("button", name="Let the simulated operator do it").click()


def set_temperatures(page: Page, artefact: float, arm: float) -> None:
    """Types both, and sets them."""
    page.get_by_label("Temperature of the artefact").fill(f"{artefact:g}")
    page.get_by_label("Temperature of the arm").fill(f"{arm:g}")
    page.get_by_role("button", name="Set", exact=True).click()
    expect(page.get_by_role("button", name="Set", exact=True)).to_have_count(0)


def wait_for_result(visit: Visit) -> None:
    visit.wait_until(
        "result",
        "/api/performance",
        lambda view: view["step"] == "review" and view["picture"]["result"] is not None,
    )
