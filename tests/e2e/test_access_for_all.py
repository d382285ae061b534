"""Every page for those who use no mouse or no eyes, and light enough for a poor network."""

import gzip

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page, Response, ViewportSize

from tests.e2e.conftest import Demo

pytestmark = pytest.mark.device

PAGES = (
    *("", "calibrate", "verify", "scan", "arm", "records", "supervise", "health", "settings"),
    *("devices", "people"),
)
USUAL: ViewportSize = {"width": 1180, "height": 820}
# so low that every page that can scroll does
LOW: ViewportSize = {"width": 1180, "height": 420}
MOST_BYTES = 500_000
"""Of everything that a page's first visit loads, the 3D view aside, as sent by gzip."""
PAINTED = "performance.getEntriesByName('first-contentful-paint')[0].startTime"
# what is drawn in the 3D view belongs to viser
WHERE = {"exclude": [["iframe"]]}


@pytest.mark.soak
def test_axe_finds_no_serious_fault(browser: Browser, demo: Demo) -> None:
    page = browser.new_page(viewport=USUAL)
    page.goto(demo.link)
    page.get_by_role("link", name="Calibrate").wait_for()
    found: list[str] = []
    for name in PAGES:
        page.goto(f"{demo.address}{name}")
        page.get_by_role("main").wait_for()
        found += in_both_themes(page, name or "home")
        page.set_viewport_size(LOW)
        found += serious(page, f"{name or 'home'}, low")
        page.set_viewport_size(USUAL)
    page.goto(f"{demo.address}calibrate")
    page.get_by_role("button", name="Start calibration").click()
    page.get_by_text("Step 1 of 7").first.wait_for()
    found += in_both_themes(page, "calibrate, devices")
    assert not found, "\n".join(found)


def in_both_themes(page: Page, name: str) -> list[str]:
    found = []
    for theme in ("light", "dark"):
        page.emulate_media(color_scheme=theme)
        page.wait_for_timeout(300)
        found += serious(page, f"{name}, {theme}")
    return found


def serious(page: Page, name: str) -> list[str]:
    """What axe finds on the page that keeps people from using it."""
    results = Axe().run(page, context=WHERE, options={"resultTypes": ["violations"]})
    return [
        f"{name}: {fault['id']} ({fault['impact']}) at {fault['nodes'][0]['target']}: "
        f"{fault['nodes'][0]['failureSummary']}"
        for fault in results.response["violations"]
        if fault["impact"] in ("serious", "critical")
    ]


def test_a_page_is_light(browser: Browser, demo: Demo) -> None:
    page = browser.new_page()
    weights: dict[str, int] = {}

    def weigh(answer: Response) -> None:
        if "/api/" not in answer.url and "/viewer" not in answer.url and answer.status == 200:
            weights[answer.url.removeprefix(demo.address)] = len(gzip.compress(answer.body()))

    page.on("response", weigh)
    page.goto(demo.link)
    page.get_by_role("link", name="Calibrate").wait_for()
    painted_ms = page.evaluate(
        "performance.getEntriesByName('first-contentful-paint')[0].startTime"
    )
    print(f"first paint after {painted_ms:.0f} ms, {sum(weights.values())} bytes")
    assert sum(weights.values()) > 10_000
    assert sum(weights.values()) < MOST_BYTES, weights
