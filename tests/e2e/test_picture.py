"""Pictures in a real browser: the live one of a lost camera, and what a refused one shows."""

import signal
import time
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.e2e.conftest import Demo, wait_in_page
from tests.e2e.visit import Visit

pytestmark = pytest.mark.device

ROUNDS = 2
DRAWN = """
window.drawn = [];
window.denied = 0;
const draw = CanvasRenderingContext2D.prototype.drawImage;
CanvasRenderingContext2D.prototype.drawImage = function (...given) {
  window.drawn.push(Date.now());
  if (document.body.innerText.includes("No picture yet")) window.denied++;
  return draw.apply(this, given);
};
"""
"""When pictures were drawn, in ms of the clock that the tests have too, and how many of them while
the page said that there is none."""

BREAKING = """
const real = window.fetch;
window.fetch = async (path, init) => {
  if (!window.breaking || init?.method !== "POST") return real(path, init);
  const gone = new DOMException("signal timed out", "TimeoutError");
  return new Response(new ReadableStream({ start: body => body.error(gone) }));
};
"""
"""While ``window.breaking``, answers to what is sent break off after their heads."""

SEEN = """button => {
  const { left, right, top, bottom } = button.getBoundingClientRect();
  return [left + 6, (left + right) / 2, right - 6]
    .map(x => document.elementFromPoint(x, (top + bottom) / 2))
    .filter(seen => !button.contains(seen))
    .map(seen => seen?.outerHTML ?? "outside");
}"""
SLOW_CHOICES = """
    const send = window.fetch;
    window.fetch = async (path, init) => {
        if (String(init?.body).includes('"choose"')) await new Promise((go) => setTimeout(go, 999));
        return send(path, init);
    };
"""
"""What is pressed after a choice follows it, however slow the line is."""
SIZES = {"desktop": (1440, 900), "tablet": (1024, 768), "upright": (800, 1280)}


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    data = tmp_path_factory.mktemp("station") / "data"
    running = Demo(data, ("tests.e2e.failing_station", str(data)))
    yield running
    running.end()


def first_after(page: Page, moment_ms: float) -> float:
    """When the first picture was drawn after a moment."""
    wait_in_page(page, "moment => window.drawn.some(at => at > moment)", moment_ms)
    return float(page.evaluate("moment => window.drawn.find(at => at > moment)", moment_ms))


def test_the_picture_comes_back_by_itself(
    browser: Browser, station: Demo, pictures: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    page.add_init_script(DRAWN)
    page.goto(station.link)
    page.get_by_role("link", name="Settings").click()
    picture = page.get_by_role("img", name="Live picture of the camera")
    expect(picture).to_be_visible()
    first_after(page, 1e3 * time.time())
    page.evaluate("window.drawn = []")
    page.wait_for_timeout(1000)
    figures = [f"{page.evaluate('window.drawn.length')} pictures a second"]
    for _ in range(ROUNDS):
        station.process.send_signal(signal.SIGUSR1)
        away = page.get_by_text("The camera is offline. This picture")
        expect(away).to_be_visible()
        expect(picture).to_have_attribute("data-old", "true")
        page.screenshot(path=pictures / "picture-away.png")
        back_ms = 1e3 * time.time()
        station.process.send_signal(signal.SIGUSR1)
        figures.append(f"drawn again {(first_after(page, back_ms) - back_ms) / 1e3:.2f} s after")
        expect(away).to_have_count(0)
        expect(picture).not_to_have_attribute("data-old", "true")
    # nothing was loaded again: what was drawn before the camera went is still known
    assert page.evaluate("window.drawn.length") > ROUNDS
    assert page.evaluate("window.denied") == 0
    page.close()
    with capsys.disabled():
        print(f"\nlive picture: {', '.join(figures)} the camera is back")


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("width", [320, 390])
def test_stop_is_whole_on_a_phone(
    browser: Browser, station: Demo, pictures: Path, language: str, width: int
) -> None:
    page = browser.new_page(viewport={"width": width, "height": 760}, has_touch=True)
    visit = Visit(page)
    page.goto(station.link.replace("#", f"?lang={language}#"))
    page.get_by_role("main").wait_for()
    stop = page.get_by_role("button", name="STOP")
    expect(stop).to_be_in_viewport(ratio=1)
    # nothing lies over it, from edge to edge, once the page has all of its header
    wait_in_page(page, f"button => ({SEEN})(button).length === 0", stop.element_handle())
    page.screenshot(path=pictures / f"stop-{language}-{width}.png")
    visit.wait_until("let in by the link", "/api/session", lambda now: now["you"] is not None)
    with page.expect_response("**/api/stop") as answered:
        stop.tap()
    assert answered.value.status == 204
    page.close()


def test_an_answer_that_breaks_off_is_none(browser: Browser, station: Demo) -> None:
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    faults: list[str] = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.add_init_script(BREAKING)
    page.goto(station.link)
    page.get_by_role("link", name="Calibrate").click()
    begin = page.get_by_role("button", name="Start calibration")
    expect(begin).to_be_visible()
    page.evaluate("window.breaking = true")
    begin.click()
    expect(page.get_by_text("No answer from the station")).to_be_visible()
    page.evaluate("window.breaking = false")
    begin.click()
    expect(page.get_by_text("Step 1 of 7").first).to_be_visible()
    page.close()
    assert not faults


def take_refused_picture(page: Page) -> None:
    """Of the table, where no chessboard is to be seen; the arm is not moved for it."""
    page.get_by_role("button", name="Calibrate").click()
    page.get_by_role("button", name="Start calibration").click()
    page.get_by_role("button", name="Continue", exact=True).click()
    page.get_by_text("Simulated chessboard").click()
    page.get_by_role("button", name="Use these").click()
    for step in ("Continue", "The object is in the picture", "Take the picture"):
        button = page.get_by_role("button", name=step)
        expect(button).to_be_enabled()
        button.click()


def test_a_refused_picture_is_explained_and_saved(
    browser: Browser, demo: Demo, pictures: Path, tmp_path: Path
) -> None:
    page = browser.new_page(viewport={"width": 1440, "height": 900}, accept_downloads=True)
    page.add_init_script(SLOW_CHOICES)
    page.goto(demo.link)
    take_refused_picture(page)
    save = page.get_by_role("link", name="Save for support")
    expect(save).to_be_visible()
    for name, (width, height) in SIZES.items():
        page.set_viewport_size({"width": width, "height": height})
        page.wait_for_timeout(400)
        page.screenshot(path=pictures / f"refused-{name}.png")
        expect(save).to_be_in_viewport()
        box = save.bounding_box()
        assert box is not None
        assert box["height"] >= 44
    with page.expect_download() as saving:
        save.click()
    saving.value.save_as(tmp_path / "picture.zip")
    names = zipfile.ZipFile(tmp_path / "picture.zip").namelist()
    assert {"context.json", "object.json", "sensor.json", "found.png"} <= set(names)
    page.close()
