"""The Settings page, German and inch in a real browser: chosen, remembered, exact where typed."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, Response, expect

from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit

pytestmark = pytest.mark.device

MM_PER_INCH = Fraction(254, 10)
TYPED = ("0.5", "0.0123", "0.1", "0.000787", ".02", "0.0000393701")
"""With a point; German fields take a comma, too."""


def test_words_and_lengths_change_and_stay(browser: Browser, demo: Demo, pictures: Path) -> None:
    page = browser.new_page(viewport={"width": 1180, "height": 820}, locale="en-US")
    faults: list[str] = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto(demo.link)
    html = page.locator("html")
    expect(html).to_have_attribute("lang", "en")
    page.get_by_role("link", name="Calibrate").click()
    page.get_by_role("button", name="Start calibration").click()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    expect(page.get_by_text("44.000 × 24.000 × 27.000 mm, 4 merlons")).to_be_visible()
    page.get_by_role("button", name="Language and units").click()
    page.get_by_role("button", name="inch").click()
    expect(page.get_by_text("1.73228 × 0.94488 × 1.06299 in, 4 merlons")).to_be_visible()
    expect(page.get_by_text("1.73 in × 0.94 in × 1.06 in").first).to_be_visible()
    german = page.get_by_role("button", name="Deutsch", exact=True)
    german.click()
    expect(html).to_have_attribute("lang", "de")
    expect(german).to_be_focused()
    expect(page.get_by_text("1,73228 × 0,94488 × 1,06299 in, 4 Zinnen")).to_be_visible()
    page.keyboard.press("Escape")

    page.get_by_role("button", name="Simulierten Bediener starten").click()
    expect(page.get_by_role("heading", name="Objekt antasten")).to_be_visible()
    expect(page.get_by_role("button", name="Punkt aufnehmen")).to_be_visible()
    expect(page.get_by_text("An den Ringen antasten.")).to_be_visible()
    expect(page.get_by_text("Schritt 3 von 7").first).to_be_visible()
    page.screenshot(path=pictures / "language-1-touch.png")
    page.reload()
    expect(page.get_by_role("heading", name="Objekt antasten")).to_be_visible()
    expect(html).to_have_attribute("lang", "de")

    page.get_by_role("link", name="Einstellungen").click()
    blur = page.get_by_label("Unschärfe, ab der eine Überfahrt zu schnell ist")
    expect(blur).to_be_visible()
    for text in TYPED:
        set_to(page, text)
        assert ask(page, "/api/settings")["blur_limit_mm"] == float(Fraction(text) * MM_PER_INCH)
        expect(blur).to_have_value(in_german(str(float(text)) if float(text) > 1e-4 else text))
    page.screenshot(path=pictures / "language-2-settings.png")
    page.reload()
    expect(blur).to_have_value(in_german(TYPED[-1]))
    page.get_by_role("group", name="Längen").get_by_role("button", name="mm").click()
    expect(blur).to_have_value("0,00100000054")
    set_to(page, "0,1")
    page.get_by_role("group", name="Sprache").get_by_role(
        "button", name="English", exact=True
    ).click()
    expect(html).to_have_attribute("lang", "en")
    expect(page.get_by_label("Maximum blur")).to_have_value("0.1")
    page.context.close()
    assert not faults, "\n".join(faults)


def set_to(page: Page, text: str) -> None:
    """Typed in, and taken by the station."""
    page.get_by_label("Unschärfe, ab der eine Überfahrt zu schnell ist").fill(text)
    with page.expect_response(is_change_of_settings) as answer:
        page.get_by_role("button", name="Übernehmen").click()
    assert answer.value.ok, answer.value.text()


def is_change_of_settings(response: Response) -> bool:
    """The page also reads the settings, and its answer may come late."""
    return response.request.method == "POST" and response.url.endswith("/api/settings")


def in_german(number: str) -> str:
    return number.replace(".", ",")


def ask(page: Page, path: str) -> Any:
    return json.loads(page.evaluate("path => fetch(path).then(answer => answer.text())", path))


def test_a_link_may_ask_for_its_language(browser: Browser, demo: Demo) -> None:
    page = browser.new_page(locale="en-US")
    page.goto(f"{demo.address}?lang=de#wall=nonsense")
    expect(page.get_by_role("heading", name="Die Station mit dem Link öffnen")).to_be_visible()
    assert page.url == demo.address
    page.reload()
    expect(page.get_by_role("heading", name="Die Station mit dem Link öffnen")).to_be_visible()
    page.context.close()


def test_a_browser_brings_its_language_along(browser: Browser, demo: Demo) -> None:
    page = browser.new_page(locale="de-AT")
    page.goto(demo.address)
    expect(page.get_by_role("heading", name="Die Station mit dem Link öffnen")).to_be_visible()
    page.get_by_role("button", name="English", exact=True).click()
    expect(page.get_by_role("heading", name="Open the station with its link")).to_be_visible()
    page.context.close()


def test_zones_are_drawn_pulled_undone_kept(demo: Demo, browser: Browser, pictures: Path) -> None:
    page = browser.new_page(viewport={"width": 1180, "height": 820})
    visit = Visit(page)
    page.goto(demo.link)
    page.get_by_role("link", name="Settings").click()
    editor = page.get_by_role("group", name="Zones without measurement")
    expect(editor).to_be_visible()
    page.get_by_role("button", name="Draw a zone").click()
    expect(page.get_by_text("Press on the picture and drag to draw the zone.")).to_be_visible()
    box = editor.bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 100, box["y"] + 100)
    page.mouse.down()
    page.mouse.move(box["x"] + 300, box["y"] + 250, steps=5)
    page.mouse.up()
    visit.wait_until("a zone", "/api/settings", lambda now: len(now["zones"]) == 1)
    drawn = visit.ask("/api/settings")["zones"]
    assert len(drawn[0]) == 4

    corner = page.get_by_role("button", name="Corner 1 of zone 1")
    corner.press("ArrowLeft")
    visit.wait_until("moved", "/api/settings", lambda now: now["zones"] != drawn)
    moved = visit.ask("/api/settings")["zones"][0][0]
    assert moved == [drawn[0][0][0] - 5, drawn[0][0][1]]
    page.get_by_role("button", name="Undo").click()
    visit.wait_until("undone", "/api/settings", lambda now: now["zones"] == drawn)

    page.get_by_label("Threshold").fill("-4")
    page.get_by_role("button", name="Set", exact=True).click()
    expect(page.get_by_text("greater than 0")).to_be_visible()
    page.get_by_label("Threshold").fill("25")
    page.get_by_role("button", name="Set", exact=True).click()
    visit.wait_until("set", "/api/settings", lambda now: now["threshold"] == 25)
    page.get_by_label("Smoothing along the line").fill("1.5")
    page.get_by_role("button", name="Set", exact=True).click()
    visit.wait_until("smoothed", "/api/settings", lambda now: now["smoothing_px"] == 1.5)
    page.get_by_label("If several lines cross a column").select_option("first")
    visit.wait_until("chosen", "/api/settings", lambda now: now["choice"] == "first")
    page.reload()
    expect(page.get_by_label("Threshold")).to_have_value("25")
    page.screenshot(path=pictures / "settings.png")
    # the answer that refused is the browser's own word, too
    assert [fault for fault in visit.faults if "422" not in fault] == []
