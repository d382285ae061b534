"""Every page for those who use no mouse or no eyes, and light enough for a poor network."""

import gzip
import re

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page, Response, ViewportSize, expect

from tests.e2e.conftest import Demo
from tests.e2e.fits import SIZES, misfits

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
SETTLING_MS = 200
"""Until what a page has asked for is on it."""
LOADING = re.compile("Warten auf die Station|wird geladen")
PAINTED = "performance.getEntriesByName('first-contentful-paint')[0].startTime"
# what is drawn in the 3D view belongs to viser
WHERE = {"exclude": [["iframe"]]}


DEEPER = (
    *("performance", "part", "datasheets", "datasheets/new/arm", "datasheets/new/block"),
    *("datasheets/design/block", "datasheets/design/board", "docs"),
)
GO = "path => { history.pushState(null, '', path); dispatchEvent(new PopStateEvent('popstate')); }"
GERMAN_INCHES = "localStorage.setItem('crenel-units', 'inch')"


def test_every_page_fits_every_screen(browser: Browser, demo: Demo) -> None:
    """In German and inches, which take most space, with scroll bars; the tour is left first, and
    does not come back."""
    page = browser.new_page(viewport=SIZES[0], color_scheme="dark")
    page.add_init_script(GERMAN_INCHES)
    page.goto(demo.link.replace("#", "?lang=de#"))
    end = page.get_by_role("button", name="Rundgang beenden")
    end.click()
    expect(end).to_have_count(0)
    found = fits(page, demo, (*PAGES, *DEEPER))
    page.set_viewport_size(SIZES[0])
    page.reload()
    page.get_by_role("link", name="Kalibrieren").click()
    page.get_by_role("button", name="Kalibrierung starten").click()
    for step in ("1 von 7", "2 von 7"):
        expect(page.get_by_text(step).first).to_be_visible()
        found += fits(page, demo, ("calibrate",))
        page.set_viewport_size(SIZES[0])
        expect(
            page.get_by_role("list", name="Schritte").get_by_role("listitem").last
        ).to_be_in_viewport()
        page.locator("[data-kind=primary]").click()
    assert not found, "\n".join(found)


def fits(page: Page, demo: Demo, names: tuple[str, ...]) -> list[str]:
    """What does not fit on these pages, at every size."""
    found = []
    for name in names:
        page.evaluate(GO, f"{demo.address}{name}")
        page.get_by_role("heading", level=1).first.wait_for()
        expect(page.get_by_text(LOADING)).to_have_count(0)
        page.wait_for_timeout(SETTLING_MS)
        page.locator("h1:visible").first.wait_for()  # the one before may have been seen above
        for size in SIZES:
            page.set_viewport_size(size)
            found += [f"{name or 'home'}, {size['width']}: {one}" for one in misfits(page)]
    return found


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
    if not page.request.get(f"{demo.address}api/flow").json()["running"]:  # by the test above
        page.get_by_role("button", name="Start calibration").click()
    page.get_by_text(re.compile(r"Step \d of 7")).first.wait_for()
    found += in_both_themes(page, "calibrate, a step")
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
