"""The Settings page in a real browser: a zone drawn on the live picture, a number typed in."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit

pytestmark = pytest.mark.device


def test_a_zone_is_drawn_pulled_undone_and_kept(
    demo: Demo, browser: Browser, pictures: Path
) -> None:
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
