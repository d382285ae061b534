"""Two people and a kiosk at one station, each in a browser of their own."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.e2e.conftest import Demo

pytestmark = pytest.mark.device

PASSWORD = "three unrelated words"


def page_of(browser: Browser, width: int, height: int) -> Page:
    return browser.new_context(viewport={"width": width, "height": height}).new_page()


def test_control_passes_from_person_to_person(browser: Browser, demo: Demo, pictures: Path) -> None:
    admin = page_of(browser, 1440, 900)
    admin.goto(demo.address)
    admin.get_by_label("Code").fill("a wrong one")
    admin.get_by_label("Code").press("Enter")
    expect(admin.get_by_text("The code is wrong.")).to_be_visible()
    admin.screenshot(path=pictures / "people-1-entrance.png")
    admin.goto(demo.link)
    admin.get_by_role("link", name="People").click()
    assert "#" not in admin.url
    admin.get_by_role("textbox", name="New account").fill("Anna")
    admin.get_by_label("Initial password").fill(PASSWORD)
    admin.get_by_role("button", name="Add").click()
    expect(admin.get_by_text("Anna", exact=True)).to_be_visible()
    admin.get_by_label("New link").fill("Hall 3")
    admin.get_by_role("button", name="Create link").click()
    kiosk_link = admin.locator("code").inner_text()
    admin.screenshot(path=pictures / "people-2-accounts.png")
    admin.get_by_role("link", name="Calibrate").click()
    admin.get_by_role("button", name="Start calibration").click()
    expect(admin.get_by_role("button", name="Control: you")).to_be_visible()

    anna = page_of(browser, 1024, 768)
    anna.goto(f"{demo.address}calibrate")
    anna.get_by_role("button", name="Sign in with a name").click()
    anna.get_by_label("Name").fill("Anna")
    anna.get_by_label("Password").fill(PASSWORD)
    anna.get_by_label("Password").press("Enter")
    proceed = anna.get_by_role("button", name="Continue")
    expect(proceed).to_have_attribute("aria-disabled", "true")
    expect(proceed).to_contain_text("Continue")
    expect(anna.get_by_text("Demo has control.").first).to_be_visible()
    anna.get_by_role("button", name="Control: Demo").click()
    anna.screenshot(path=pictures / "people-3-looking-on.png")
    anna.get_by_role("button", name="Request control").click()

    expect(admin.get_by_text("Anna requests control")).to_be_visible()
    admin.screenshot(path=pictures / "people-4-asked.png")
    admin.get_by_role("button", name="Give control").click()
    expect(anna.get_by_role("button", name="Control: you")).to_be_visible()
    anna.keyboard.press("Escape")
    proceed.click()
    expect(anna.get_by_text("Step 2 of 7").first).to_be_visible()
    expect(admin.get_by_text("Step 2 of 7").first).to_be_visible()

    anna.get_by_role("link", name="Arm & tip").click()
    in_use = anna.get_by_text("The arm is in use: Calibration, Anna, since")
    for answer in ("Leave it", "End it and go on"):
        expect(admin.get_by_text("arm in use: Calibration, Anna, since")).to_be_visible()
        anna.get_by_role("button", name="Check the tip").click()
        expect(in_use).to_be_visible()
        anna.screenshot(path=pictures / "people-5-arm-in-use.png")
        anna.get_by_role("button", name=answer).click()
        expect(in_use).to_be_hidden()
    expect(admin.get_by_text("arm in use: Arm check, Anna, since")).to_be_visible()

    kiosk = page_of(browser, 1920, 1080)
    kiosk.goto(kiosk_link)
    expect(kiosk.get_by_text("Anna", exact=True)).to_be_visible()
    expect(kiosk.get_by_role("button", name="STOP")).to_have_count(0)
    assert kiosk.evaluate("fetch('/api/stop', {method: 'POST'}).then(a => a.status)") == 403
    kiosk.screenshot(path=pictures / "people-6-kiosk.png")

    anna.get_by_role("button", name="Control: you").click()
    anna.get_by_role("button", name="Sign out").click()
    expect(anna.get_by_role("button", name="Sign in", exact=True)).to_be_visible()
    expect(admin.get_by_role("button", name="Control: nobody")).to_be_visible()
    for page in (admin, anna, kiosk):
        page.context.close()
