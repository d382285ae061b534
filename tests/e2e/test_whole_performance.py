"""Whole performance tests in a real browser: from their start to their figures and their record.

Limits of what is scanned are wide: a busy machine stamps the readings of a moving arm late.
"""

import json
from pathlib import Path

import pytest
from playwright.sync_api import APIResponse, Browser, Page, expect

from crenel.gauges.judgement.document import read_performance
from crenel.gauges.plan.document import read_plan
from tests.e2e.conftest import Demo
from tests.e2e.performance_visits import (
    begin_contact_test,
    begin_length_test,
    begin_sphere_test,
    look_at_both_sizes,
    set_temperatures,
    station,
    visit_station,
    wait_for_result,
)

__all__ = ["station"]
pytestmark = [pytest.mark.device, pytest.mark.soak]

STEPS = ("pattern", "location", "scan", "end", "review")
CONTACT = ("diameter", "seats", "temperatures")
FIGURES = 11
LENGTHS = 7 * 3
"""Of a standard with a single length."""


def test_the_one_sphere_test(station: Demo, browser: Browser, screenshots: Path | None) -> None:
    visit = visit_station(station, browser, screenshots)
    page = visit.page
    begin_sphere_test(visit)
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
    assert not visit.faults
    page.close()


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


def test_the_length_test(station: Demo, browser: Browser, screenshots: Path | None) -> None:
    visit = visit_station(station, browser, screenshots)
    page = visit.page
    begin_length_test(visit)
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
    expect(row.get_by_text("Undecided")).to_be_visible()
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


def test_the_contact_tests(station: Demo, browser: Browser, screenshots: Path | None) -> None:
    visit = visit_station(station, browser, screenshots)
    page = visit.page
    begin_contact_test(visit)
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
    page.get_by_role("button", name="Contact tests", exact=True).click()
    page.get_by_role("button", name="Start the test").click()
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
