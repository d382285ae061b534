"""The performance tests in a real browser: from their start to their figures and their record.

Limits of what is scanned are wide: a busy machine stamps the readings of a moving arm late.
"""

import json
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import APIResponse, Browser, FilePayload, Page, expect

from app.bench.faults.served import HALF, HALF_SIZE, prepare
from app.formats.performance.plan import read_plan
from app.formats.performance.results import read_performance
from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit
from tests.formats.certificates import DIAMETER, certificate

pytestmark = pytest.mark.device

SIZES = {"desktop": (1280, 800), "tablet": (820, 1180)}
STEPS = ("pattern", "location", "scan", "end", "review")
CONTACT = ("diameter", "seats", "temperatures")
WAIT_MS = 30_000
FIGURES = 11
LENGTHS = 7 * 3
"""Of a standard with a single length."""


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    """A simulated station whose sensor is calibrated, with a step gauge of a single length, too."""
    data = tmp_path_factory.mktemp("performance") / "data"
    prepare(data, HALF)
    gauge = json.loads((data / "gauges" / "step-gauge.json").read_text())
    short = {**gauge, "name": "Short gauge", "lengths": gauge["lengths"][-1:]}
    (data / "gauges" / "short.json").write_text(json.dumps(short))
    running = Demo(data, (sys.executable, "-m", "app.bench.faults.served", str(data), *HALF_SIZE))
    yield running
    running.end()


def look_at_both_sizes(visit: Visit, name: str) -> None:
    """Nothing is wider than the screen, on either."""
    for size, (width, height) in SIZES.items():
        visit.page.set_viewport_size({"width": width, "height": height})
        visit.look(f"performance-{name}-{size}")
        assert visit.page.evaluate("document.documentElement.scrollWidth") <= width


def check_record(station: Demo, page: Page) -> None:
    """What the finished test left: its folder, its list, Home, its history and its report."""

    def get(path: str) -> APIResponse:
        return page.request.get(f"{station.address.rstrip('/')}/api/{path}")

    (newest,) = get("performances").json()
    folder = station.data / "performance" / newest["id"]
    plan, found = read_plan(folder), read_performance(folder)
    values = {figure.quantity: figure.value or 0.0 for figure in found.figures}
    assert plan.simulated
    assert {limit.quantity: limit.a_um for limit in plan.limits} == {"form-touch": 300.0}
    assert not [str(figure.problem) for figure in found.figures if figure.problem]
    assert not [note for note in found.notes if "articulation" in str(note)]
    assert 0 < values["form-touch"] < 200
    assert 0 < values["location-scan"] < 2000
    assert abs(values["size-all-scan"]) < 2000
    assert {entry.file for entry in found.inputs} >= {
        "plan.json", "arm.json", "calibration.json", "touches.csv", "p1-a5/scan.mcap",
    }  # fmt: skip
    served = get(f"performances/{newest['id']}").json()
    assert served == json.loads((folder / "performance.json").read_text())
    checks = {one["id"]: one for one in get("home").json()["checks"]}
    assert checks["performance"]["at"] == newest["ended_at"]
    history = get("performance-history").json()
    drawn = {one["quantity"]: (one["value"], one["limit"]) for one in history[-1]["symbols"]}
    assert drawn["form-touch"] == (values["form-touch"], 300.0)
    assert "P_Form.Sph.1x25" in get(f"performances/{newest['id']}/report.html").text()
    refused = get(f"performances/{newest['id']}/export.dcc?country=Germany")
    assert "two capital letters" in refused.json()["detail"]


def set_temperatures(page: Page, artefact: float, arm: float) -> None:
    """Types both, and sets them."""
    page.get_by_label("Temperature of the artefact").fill(f"{artefact:g}")
    page.get_by_label("Temperature of the arm").fill(f"{arm:g}")
    page.get_by_role("button", name="Set", exact=True).click()
    expect(page.get_by_role("button", name="Set", exact=True)).to_have_count(0)


def export_from(visit: Visit) -> None:
    """Every file of a result; who issues the certificate is asked once."""
    page = visit.page
    for label, ending in (("CSV", ".zip"), ("XLSX", ".xlsx"), ("QIF", ".qif")):
        with page.expect_download() as saved:
            page.get_by_role("button", name=label).click()
        assert saved.value.suggested_filename.endswith(ending)
    page.get_by_role("button", name="DCC").click()
    page.get_by_label("Laboratory").fill("Halle 3")
    page.get_by_label("Country").fill("de")
    look_at_both_sizes(visit, "certificate")
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save the certificate").click()
    text = Path(saved.value.path()).read_text()
    assert "Halle 3" in text
    assert "<dcc:countryCodeISO3166_1>DE<" in text
    page.reload()
    page.get_by_role("button", name="DCC").click()
    expect(page.get_by_label("Country")).to_have_value("DE")


def test_the_one_sphere_test_from_start_to_figures(
    station: Demo, browser: Browser, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.set_default_timeout(WAIT_MS)
    visit = Visit(page, screenshots)
    page.goto(station.link)
    page.get_by_role("link", name="Performance").click()
    look_at_both_sizes(visit, "before")
    content = certificate(DIAMETER).encode()
    sphere = FilePayload(name="K-17.xml", mimeType="text/xml", buffer=content)
    page.locator("[data-certificate]").set_input_files(sphere)
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
    for step in STEPS:
        visit.wait_until(
            step,
            "/api/performance",
            lambda view, step=step: (  # type: ignore[misc]
                view["step"] == step
                and (step == "review" or view["progress"]["done"] > 0)
                and (step != "review" or view["picture"]["result"] is not None)
            ),
        )
        look_at_both_sizes(visit, step)
    rows = page.locator("tr[data-quantity]")
    expect(rows).to_have_count(FIGURES)
    expect(rows.filter(has_text="P_Form.Sph.1x25::Tact").get_by_text("300")).to_be_visible()
    page.get_by_role("button", name="Finish the test").click()
    expect(page.get_by_role("heading", name="Performance tests")).to_be_visible()
    look_at_both_sizes(visit, "list")
    page.get_by_role("button", name="Open").first.click()
    expect(rows).to_have_count(FIGURES)
    look_at_both_sizes(visit, "record")
    check_record(station, page)
    export_from(visit)
    page.get_by_role("button", name="Cancel").click()
    page.get_by_role("link", name="Records").click()
    expect(page.get_by_text("Each symbol over time appears here after the second")).to_be_visible()
    assert not visit.faults
    page.close()


def test_the_length_test_from_start_to_errors(
    station: Demo, browser: Browser, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.set_default_timeout(WAIT_MS)
    visit = Visit(page, screenshots)
    page.goto(station.link)
    page.get_by_role("link", name="Performance").click()
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
    visit.wait_until(
        "errors",
        "/api/performance",
        lambda view: (
            view["step"] == "lengths" and len(view["picture"]["lengths"]["touched"]["errors"]) >= 7
        ),
    )
    expect(page.locator("svg [data-place='1'][data-state='done']")).to_have_count(2)
    look_at_both_sizes(visit, "lengths")
    visit.wait_until(
        "temperatures",
        "/api/performance",
        lambda view: view["step"] == "temperatures" and view["busy"] is None,
    )
    # those of the beginning are filled in
    expect(page.get_by_label("Temperature of the artefact")).to_have_value("20.4")
    expect(page.get_by_label("Temperature of the arm")).to_have_value("21")
    set_temperatures(page, artefact=22.4, arm=21.0)
    expect(page.get_by_text("The temperature of the artefact changed by 2.0 °C")).to_be_visible()
    look_at_both_sizes(visit, "lengths-temperatures")
    page.get_by_role("button", name="Confirm the temperatures").click()
    row = page.locator("tr[data-quantity='length-touch']")
    expect(row.get_by_text("Uncertain")).to_be_visible()
    page.get_by_role("button", name="Change the temperatures").click()
    # what stands in the fields counts, though it was not set
    page.get_by_label("Temperature of the artefact").fill("20.8")
    page.get_by_role("button", name="Confirm the temperatures").click()
    visit.wait_until(
        "review", "/api/performance", lambda view: view["picture"]["result"] is not None
    )
    expect(page.get_by_text("changed by 0.4 °C at most")).to_be_visible()
    look_at_both_sizes(visit, "lengths-review")
    drawn = page.locator("circle[data-beyond]")
    expect(drawn).to_have_count(LENGTHS)
    expect(row.get_by_text("± 260 µm")).to_be_visible()
    page.get_by_role("button", name="Finish the test").click()
    page.get_by_role("button", name="Open").first.click()
    expect(drawn).to_have_count(LENGTHS)
    look_at_both_sizes(visit, "lengths-record")
    with page.expect_popup() as opened:
        page.get_by_role("link", name="Report", exact=True).click()
    report = opened.value
    expect(report.get_by_role("img", name="Errors of length")).to_be_visible()
    assert not visit.faults
    page.close()


def begin_test(station: Demo, page: Page, kind: str) -> None:
    """From Home to the choice of the artefact."""
    page.goto(station.link)
    page.get_by_role("link", name="Performance").click()
    page.get_by_role("button", name=kind, exact=True).click()
    page.get_by_role("button", name="Start the test").click()


def wait_for_result(visit: Visit) -> None:
    visit.wait_until(
        "result",
        "/api/performance",
        lambda view: view["step"] == "review" and view["picture"]["result"] is not None,
    )


def test_the_plane_test_from_start_to_form(
    station: Demo, browser: Browser, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.set_default_timeout(WAIT_MS)
    visit = Visit(page, screenshots)
    begin_test(station, page, "Plane")
    small = page.get_by_role("radio", name="Simulated gauge plate")
    expect(small).to_have_attribute("aria-disabled", "true")
    expect(page.get_by_text("The plate is 40 mm wide; 50 mm are needed")).to_be_visible()
    expect(page.get_by_role("radio", name="Simulated flat plate")).to_be_checked()
    page.get_by_label("form of the scanned plane").fill("2000")
    page.get_by_role("button", name="Set", exact=True).click()
    expect(page.get_by_role("button", name="Set", exact=True)).to_have_count(0)
    look_at_both_sizes(visit, "plane-artefact")
    page.get_by_role("button", name="The plate lies still").click()
    expect(page.get_by_text("at about 45° to the edges")).to_be_visible()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until(
        "second orientation",
        "/api/performance",
        lambda view: view["picture"]["articulations"][0]["state"] == "done",
    )
    look_at_both_sizes(visit, "plane-scan")
    visit.wait_until(
        "temperatures", "/api/performance", lambda view: view["step"] == "temperatures"
    )
    page.get_by_role("button", name="Confirm the temperatures").click()
    wait_for_result(visit)
    row = page.locator("tr[data-quantity='plane-scan']")
    expect(row.get_by_text("Pass")).to_be_visible()
    look_at_both_sizes(visit, "plane-review")
    page.get_by_role("button", name="Finish the test").click()
    page.get_by_role("button", name="Open").first.click()
    expect(page.get_by_text("Simulated flat plate ·")).to_be_visible()
    (newest, *_) = page.request.get(f"{station.address.rstrip('/')}/api/performances").json()
    found = read_performance(station.data / "performance" / newest["id"])
    (figure,) = found.figures
    assert 10 < (figure.value or 0.0) < 2000
    assert len(figure.values) == 2
    assert not visit.faults
    page.close()


def test_the_contact_tests_from_start_to_figures(
    station: Demo, browser: Browser, screenshots: Path | None
) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.set_default_timeout(WAIT_MS)
    visit = Visit(page, screenshots)
    begin_test(station, page, "Contact tests")
    page.get_by_role("radio", name="Without a sphere").click()
    expect(page.get_by_label("effective diameter")).to_have_count(0)
    expect(page.get_by_label("volumetric length, largest")).to_be_visible()
    look_at_both_sizes(visit, "contact-artefact")
    page.get_by_role("button", name="The artefacts are ready").click()
    expect(page.get_by_text("Clamp the seat near the shoulder")).to_be_visible()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until(
        "bar", "/api/performance", lambda view: view["step"] == "bar" and view["busy"] is None
    )
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until(
        "placements",
        "/api/performance",
        lambda view: view["picture"]["contact"]["lines"][0]["state"] == "done",
    )
    # before the operator is done with the last placement
    page.get_by_role("button", name="Stop the simulated operator").click()
    look_at_both_sizes(visit, "contact-placements")
    page.get_by_role("button", name="Cancel the test").click()
    page.get_by_role("button", name="Operating error").click()
    begin_test(station, page, "Contact tests")
    page.get_by_role("radio", name="Simulated gauge sphere").click()
    page.get_by_role("radio", name="Without a ball bar").click()
    page.get_by_role("button", name="Let the simulated operator do everything").click()
    for number, step in enumerate(CONTACT):
        visit.wait_until(
            step,
            "/api/performance",
            lambda view, number=number: view["step"] in (*CONTACT[number:], "review"),  # type: ignore[misc]
        )
        look_at_both_sizes(visit, f"contact-{step}")
    wait_for_result(visit)
    look_at_both_sizes(visit, "contact-review")
    page.get_by_role("button", name="Finish the test").click()
    expect(page.get_by_role("button", name="Open").first).to_be_visible()
    newest, cancelled, *_ = page.request.get(
        f"{station.address.rstrip('/')}/api/performances"
    ).json()
    assert cancelled["result"] == "cancelled"
    folder = station.data / "performance" / newest["id"]
    plan, found = read_plan(folder), read_performance(folder)
    assert plan.edition == "B89.4.22"
    assert plan.sphere is not None
    assert plan.length is None
    values = {figure.quantity: figure.value for figure in found.figures}
    assert abs(values["effective-diameter"] or 1e3) < 100
    assert 5 < (values["articulation-largest"] or 0.0) < 500
    assert "volumetric-largest" not in values
    assert not visit.faults
    page.close()
