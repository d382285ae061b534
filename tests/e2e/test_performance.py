"""The performance tests in a real browser: how each begins, and one to its record and exports."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from crenel.gauges.judgement.document import read_performance
from tests.e2e.conftest import Demo
from tests.e2e.performance_visits import (
    begin_contact_test,
    begin_length_test,
    begin_sphere_test,
    look_at_both_sizes,
    station,
    visit_station,
    wait_for_result,
)
from tests.e2e.visit import Visit

__all__ = ["station"]
pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_each_can_be_cancelled(station: Demo, browser: Browser, screenshots: Path | None) -> None:
    visit = visit_station(station, browser, screenshots)
    for begin in (begin_sphere_test, begin_length_test, begin_contact_test):
        before = len(visit.ask("/api/performances"))
        begin(visit)
        cancel_once_touched(visit)
        newest, *_ = listed = visit.ask("/api/performances")
        assert (len(listed), newest["result"]) == (before + 1, "cancelled")
    assert not visit.faults
    visit.page.close()


def cancel_once_touched(visit: Visit) -> None:
    """Stops the operator after a touch, and ends the test with a reason."""
    page = visit.page
    visit.wait_until("touches", "/api/performance", lambda view: view["frozen"])
    page.get_by_role("button", name="Stop the simulated operator").click()
    visit.wait_until("rest", "/api/performance", lambda view: view["busy"] is None)
    page.get_by_role("button", name="Cancel the test").click()
    page.get_by_role("button", name="Operating error").click()
    expect(page.get_by_role("heading", name="Performance tests")).to_be_visible()


def test_the_whole_plane_test(station: Demo, browser: Browser, screenshots: Path | None) -> None:
    visit = visit_station(station, browser, screenshots)
    page = visit.page
    page.get_by_role("button", name="Plane", exact=True).click()
    page.get_by_role("button", name="Start the test").click()
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
    export_from(visit)
    page.get_by_role("button", name="Cancel").click()
    page.get_by_role("link", name="Records").click()
    expect(page.get_by_text("Each symbol over time appears here after the second")).to_be_visible()
    assert not visit.faults
    page.close()


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
