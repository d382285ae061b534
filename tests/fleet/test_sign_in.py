"""People sign in at the fleet's server with accounts of a provider, which runs as a process."""

from pathlib import Path
from typing import Any

import httpx
import pytest

from crenel.api.access.browser import BACK
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.fleet_settings import ACCOUNTS_FILE
from crenel.server.fleet.access import FleetPeople
from crenel.single_sign_on.person import ProviderPerson
from crenel.store.accounts import Role
from tests.api.test_provider_sign_in import begin, finish
from tests.fleet.entries import entry_of
from tests.fleet.test_server import refused_start, running_fleet
from tests.single_sign_on.mock_provider import (
    SIGN_IN,
    MockProvider,
    answer_of,
    mock_provider,
    read_table,
)

pytestmark = pytest.mark.device

HOST = "10.9.8.7:8100"
"""By which browsers reach the server: the provider knows only this address."""
PASSWORD = ("anyone", "a page's password")
SETTINGS = f"""
[catalogue]
database = "sqlite:///catalogue.db"

[server]
password_file = "password"
{SIGN_IN}"""

AWAY = MockProvider("http://127.0.0.1:9", "crenel-fleet", "secret")
"""Nobody listens there."""


def write_settings(folder: Path, provider: MockProvider, issuer: str = "") -> Path:
    (folder / "password").write_text(PASSWORD[1])
    (folder / "secret").write_text(provider.secret)
    with FleetCatalogue(f"sqlite:///{folder}/catalogue.db") as catalogue:
        catalogue.add([entry_of()])
    path = folder / "fleet.toml"
    path.write_text(SETTINGS.format(issuer=issuer or provider.issuer, client=provider.client_id))
    return path


def browser_of(client: httpx.Client) -> httpx.Client:
    headers = {"Host": HOST}
    return httpx.Client(base_url=client.base_url, headers=headers, timeout=30.0, trust_env=False)


def sign_in(browser: httpx.Client, subject: str) -> httpx.Response:
    return finish(browser, answer_of(begin(browser), subject))


def state_of(browser: httpx.Client) -> Any:
    return browser.get("/api/session").raise_for_status().json()


def test_people_sign_in_with_the_provider_or_with_the_password(tmp_path: Path) -> None:
    with mock_provider() as provider:
        provider.register(f"http://{HOST}{BACK}")
        provider.put("1", preferred_username="Anna", groups=["measuring-room"])
        provider.put("2", preferred_username="Ben", groups=["canteen"])
        settings = write_settings(tmp_path, provider)
        with running_fleet(settings, "--host", "0.0.0.0") as client, browser_of(client) as anna:
            check_that_anna_may_enter(anna)
            with browser_of(client) as ben:
                check_that_ben_needs_the_password(ben)
            cookies = dict(anna.cookies)
            with browser_of(client) as elsewhere:
                sign_in(elsewhere, "1")
                out = elsewhere.delete("/api/session").raise_for_status().json()
                page = f"{provider.issuer}/oauth2/end_session"
                assert (out["you"], out["sign_out_page"].split("?")[0]) == (None, page)
    # the provider is away now
    with running_fleet(settings) as client, browser_of(client) as anna:
        anna.cookies.update(cookies)
        assert state_of(anna)["you"]["name"] == "Anna"
        assert anna.get("/api/fleet/overview").is_success
        with browser_of(client) as ben:
            check_that_the_provider_is_away(ben)
        assert anna.delete("/api/session").raise_for_status().json()["sign_out_page"] == ""
        anna.cookies.update(cookies)
        assert anna.get("/api/fleet/overview").status_code == 401
    assert (tmp_path / ACCOUNTS_FILE).stat().st_mode & 0o077 == 0


def check_that_anna_may_enter(anna: httpx.Client) -> None:
    refused = anna.get("/api/fleet/overview")
    assert (refused.status_code, refused.json()["code"]) == (401, "signed-out")
    assert "www-authenticate" not in refused.headers
    assert anna.get("/").is_success
    before = state_of(anna)
    assert (before["you"], before["provider"]) == (None, "Keycloak")
    assert before["password_page"] == "/password"
    you = sign_in(anna, "1").raise_for_status().json()["you"]
    assert (you["name"], you["role"], you["by_provider"]) == ("Anna", "operator", True)
    assert anna.get("/api/fleet/overview").json()["stations"][0]["records"] == 1
    foreign = anna.delete("/api/session", headers={"Origin": "https://evil.example"})
    assert foreign.status_code == 403
    other_name = anna.get("/", headers={"Host": "evil.example"})
    assert other_name.json()["detail"].endswith("Add names with hosts in fleet.toml.")


def check_that_ben_needs_the_password(ben: httpx.Client) -> None:
    denied = sign_in(ben, "2")
    assert (denied.status_code, denied.json()["code"]) == (401, "sign-in-no-group")
    assert denied.json()["detail"] == "Ben is in no group of Keycloak that may sign in here"
    assert ben.get("/api/fleet/overview").status_code == 401
    asked = ben.get("/password")
    assert (asked.status_code, asked.headers["www-authenticate"][:5]) == (401, "Basic")
    back = ben.get("/password", auth=PASSWORD)
    assert (back.status_code, back.headers["location"]) == (303, "/")
    assert ben.get("/api/fleet/overview", auth=PASSWORD).is_success
    assert ben.get("/api/session", auth=PASSWORD).json()["provider"] == ""


def check_that_the_provider_is_away(ben: httpx.Client) -> None:
    refused = ben.post("/api/session/provider")
    assert refused.status_code == 401
    assert refused.json()["detail"] == "Keycloak cannot be reached"
    assert refused.json()["remedy"].startswith("Sign in without the provider")
    assert state_of(ben)["provider_trouble"]["message_id"] == "sign-in-provider-away"
    assert ben.get("/api/fleet/overview", auth=PASSWORD).is_success
    # a slow machine guesses slowly, for which the first waits are too short
    guesses = [ben.get("/api/fleet/overview", auth=("anyone", "a guess")) for _ in range(12)]
    slowed = next(one for one in guesses if one.status_code == 429)
    assert slowed.json()["code"] == "too-many-tries"


def test_settings_that_cannot_work_are_refused(tmp_path: Path) -> None:
    settings = write_settings(tmp_path, AWAY)
    (tmp_path / "password").write_text("\n")
    assert "password is empty" in refused_start(settings)
    settings = write_settings(tmp_path, AWAY, "http://keycloak.example")
    assert "it must be an https address" in refused_start(settings)
    settings = write_settings(tmp_path, AWAY)
    (tmp_path / "fleet-accounts.db").write_text("no database" * 1000)
    assert "fleet-accounts.db" in refused_start(settings)


def test_accounts_follow_the_provider(tmp_path: Path) -> None:
    """Another person with the name of a former one gets it; another provider has no old people."""
    file = tmp_path / "accounts.db"
    first = FleetPeople(AWAY.settings(tmp_path), file)
    former = first.admit(ProviderPerson("1", "Anna", "viewer"), "")
    bearer = first.admit(ProviderPerson("7", "anna", "operator"), "")
    assert first.sessions.principal(former) is None
    principal = first.sessions.principal(bearer)
    assert principal is not None
    assert (principal.name, principal.role) == ("anna", Role.operator)
    first.close()
    settings = AWAY.settings(tmp_path).model_dump()
    other = read_table(tmp_path, {**settings, "issuer": "https://other.example"})
    second = FleetPeople(other, file)
    assert second.sessions.principal(bearer) is None
    second.close()
