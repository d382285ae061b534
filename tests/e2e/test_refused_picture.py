"""A refused picture in a real browser: what was found drawn on it, and the file to send."""

import zipfile
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.e2e.conftest import Demo

pytestmark = pytest.mark.device

SLOW_CHOICES = """
    const send = window.fetch;
    window.fetch = async (path, init) => {
        if (String(init?.body).includes('"choose"')) await new Promise((go) => setTimeout(go, 999));
        return send(path, init);
    };
"""
"""What is pressed after a choice follows it, however slow the line is."""
SIZES = {"desktop": (1440, 900), "tablet": (1024, 768), "upright": (800, 1280)}


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
