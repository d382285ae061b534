"""People sign in with accounts of a provider on another site, as a browser sees it."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from app.bench.station.subprocess_station import free_port
from app.store.accounts import Role
from app.store.store import Store
from tests.e2e.conftest import Demo
from tests.forked import COMMAND_LINE
from tests.single_sign_on.mock_provider import SIGN_IN, MockProvider, mock_provider

pytestmark = pytest.mark.device

PASSWORD = "three unrelated words"
STATION = (
    """
[station]
data = "data"
"""
    + SIGN_IN
)


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


def test_a_person_in_no_group_is_refused_in_one_sentence(
    browser: Browser, station: Demo, pictures: Path
) -> None:
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
