"""People in browsers of their own: at one station with a kiosk, and by accounts of a provider."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from crenel.store.accounts import Role
from crenel.store.store import Store
from tests.bench.station.subprocess_station import free_port
from tests.e2e.conftest import Demo
from tests.forked import COMMAND_LINE
from tests.single_sign_on.mock_provider import SIGN_IN, MockProvider, mock_provider

pytestmark = [pytest.mark.device, pytest.mark.soak]

PASSWORD = "three unrelated words"
STATION = (
    """
[station]
data = "data"
"""
    + SIGN_IN
)


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
    expect(anna.get_by_text("Step 2 of 7").locator("visible=true").first).to_be_visible()
    expect(admin.get_by_text("Step 2 of 7").first).to_be_visible()

    anna.get_by_role("link", name="Arm & tip").click()
    in_use = anna.get_by_text("The arm is in use: Calibration, Anna, since")
    for answer in ("No, keep it", "End it and go on"):
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


@pytest.fixture(scope="module")
def provider() -> Iterator[MockProvider]:
    with mock_provider() as running:
        yield running


@pytest.fixture(scope="module")
def station(provider: MockProvider, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    """``crenel serve`` without devices, on a site other than the provider's."""
    folder, port = tmp_path_factory.mktemp("plant"), free_port()
    provider.register(f"http://127.0.0.1:{port}/sign-in")
    provider.put("1", preferred_username="Anna", groups=["measuring-room"])
    provider.put("2", preferred_username="Ben", groups=["canteen"])
    store = Store(folder / "data")
    store.accounts.add("Chief", Role.admin, PASSWORD)
    store.close()
    (folder / "secret").write_text(provider.secret)
    issuer = provider.issuer.replace("127.0.0.1", "localhost")
    config = folder / "station.toml"
    config.write_text(STATION.format(issuer=issuer, client=provider.client_id))
    command = (COMMAND_LINE, "serve", "--config", str(config), "--port", str(port))
    running = Demo(folder / "data", command)
    yield running
    running.end()


def sign_in(page: Page, subject: str) -> None:
    """The button of the station, and then the page of the provider."""
    page.get_by_role("button", name="Sign in with Keycloak").click()
    page.locator("input[name=sub]").first.fill(subject)
    page.get_by_role("button", name="Authorize").first.click()


def test_a_person_signs_in_where_they_were_and_out_at_the_provider(
    browser: Browser, station: Demo, pictures: Path
) -> None:
    page = browser.new_context(viewport={"width": 1280, "height": 800}).new_page()
    page.goto(f"{station.address}records")
    expect(page.get_by_label("Password")).to_be_visible()
    page.screenshot(path=pictures / "sign-in-1-entrance.png")
    sign_in(page, "1")
    control = page.get_by_role("button", name=re.compile("^Control"))
    expect(control).to_be_visible()
    assert page.url == f"{station.address}records"
    control.click()
    expect(page.get_by_text("You are signed in as Anna, operator.")).to_be_visible()
    expect(page.get_by_role("button", name="Change the password")).to_have_count(0)
    page.get_by_role("button", name="Sign out").click()
    page.wait_for_url("**/end_session**")
    page.get_by_role("button").first.click()
    expect(page.get_by_role("button", name="Sign in with Keycloak")).to_be_visible()
    page.context.close()


def test_a_person_in_no_group_is_refused(browser: Browser, station: Demo, pictures: Path) -> None:
    page = browser.new_context(viewport={"width": 1024, "height": 768}).new_page()
    page.goto(station.address)
    sign_in(page, "2")
    refused = page.get_by_role("alert")
    expect(refused).to_contain_text("Ben is in no group of Keycloak that may sign in here")
    assert page.url == station.address
    page.screenshot(path=pictures / "sign-in-2-no-group.png")
    page.get_by_label("Name").fill("Chief")
    page.get_by_label("Password").fill(PASSWORD)
    page.get_by_label("Password").press("Enter")
    page.get_by_role("link", name="People").click()
    row = page.get_by_role("listitem").filter(has_text="Anna")
    expect(row).to_contain_text("Account of the provider, which sets role and password")
    expect(row.get_by_role("combobox")).to_have_count(0)
    expect(row.get_by_role("button", name="New password")).to_have_count(0)
    page.screenshot(path=pictures / "sign-in-3-people.png")
    page.context.close()
