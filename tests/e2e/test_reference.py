"""The reference of the HTTP interface, for people who write programs for the station."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Route, expect

from tests.e2e.conftest import Demo

pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_the_reference_lists_every_route(demo: Demo, browser: Browser, pictures: Path) -> None:
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    page.goto(f"{demo.address}docs")
    expect(page.get_by_role("heading", name="HTTP interface")).to_have_count(0)
    page.goto(demo.link)
    page.get_by_role("link", name="Health").click()
    page.get_by_role("link", name="Open the reference").click()
    expect(page.get_by_role("heading", name="HTTP interface")).to_be_visible()
    described = page.evaluate("fetch('/api/openapi.json').then(answer => answer.json())")
    routes = sum(len(operations) for operations in described["paths"].values())
    expect(page.get_by_text(re.compile("^(GET|POST|PUT|PATCH|DELETE)$"))).to_have_count(routes)
    page.screenshot(path=pictures / "reference.png")
    page.get_by_role("article").filter(has_text="/api/flow/command").get_by_role(
        "link", name="FlowCommand"
    ).click()
    shape = page.locator("#type-FlowCommand")
    expect(shape).to_be_in_viewport()
    expect(shape.get_by_text("rev", exact=True)).to_be_visible()
    page.set_viewport_size({"width": 820, "height": 1180})
    page.screenshot(path=pictures / "reference-type-tablet.png")
    page.close()


def test_who_is_quicker_than_the_sign_in_sees_the_page_later(demo: Demo, browser: Browser) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    signing_in: list[Route] = []
    refused: list[str] = []
    page.on("response", lambda one: refused.append(one.url) if one.status == 401 else None)
    page.route("**/api/session/code", lambda route: signing_in.append(route))
    page.goto(demo.link, wait_until="commit")
    page.get_by_role("link", name="Health").click()
    page.get_by_role("link", name="Records").click()
    page.wait_for_timeout(500)
    assert len(signing_in) == 1
    signing_in[0].continue_()
    expect(page.get_by_text("Accepted calibrations appear")).to_be_visible()
    assert not refused
    page.close()
