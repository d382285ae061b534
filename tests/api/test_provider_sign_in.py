"""A station whose people sign in with the accounts of a provider, which runs as a process."""

import io
import logging
import zipfile
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import httpx
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel.api.access import browser
from crenel.operations.health_checks import HealthChecker
from crenel.security import login_throttle
from crenel.single_sign_on import provider as provider_module
from crenel.single_sign_on.pending import ProviderAnswer
from crenel.store.accounts import Role
from tests.api.conftest import PATIENCE_S, Server, code_of, running_server
from tests.single_sign_on.mock_provider import MockProvider, answer_of, mock_provider

pytestmark = pytest.mark.device

log = logging.getLogger(__name__)
HOST = "10.9.8.7:8000"
"""By which browsers reach the station: the provider knows only this address."""
BACK = f"http://{HOST}{browser.BACK}"
PASSWORD = "three unrelated words"


@dataclass
class Station:
    server: Server
    provider: MockProvider

    def browser(self, host: str = HOST) -> httpx.Client:
        return httpx.Client(
            base_url=self.server.address, headers={"Host": host}, timeout=PATIENCE_S
        )

    def sign_in(self, browser: httpx.Client, subject: str) -> httpx.Response:
        return finish(browser, answer_of(begin(browser), subject))

    def newest(self) -> tuple[str, str]:
        """Who is in the newest entry of the audit log, and how it ended."""
        entry = self.server.context.store.audit.newest(1)[0]
        return entry.who, str(entry.outcome)


def begin(browser: httpx.Client) -> str:
    """The page of the provider."""
    return str(browser.post("/api/session/provider").raise_for_status().json()["address"])


def finish(browser: httpx.Client, answer: ProviderAnswer) -> httpx.Response:
    """What the page /sign-in posts."""
    body = {"state": answer.state, "code": answer.code, "error": answer.error}
    return browser.post("/api/session/provider/answer", json=body)


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Station]:
    folder = tmp_path_factory.mktemp("plant")
    with mock_provider() as provider:
        provider.register(BACK)
        provider.put("1", preferred_username="Anna", groups=["sensor-operators"])
        with running_server(folder / "data", sign_in=provider.settings(folder)) as server:
            yield Station(server, provider)
        assert not server.sent.untranslated()


@pytest.fixture(autouse=True)
def tries_forgotten(station: Station) -> None:
    """The wrong tries of one test do not slow the next one down."""
    station.server.context.authenticator.note_provider_attempt(True, "127.0.0.1")


def you(browser: httpx.Client) -> Any:
    return browser.get("/api/session").json()["you"]


def test_a_person_signs_in_with_the_role_of_their_groups_today(station: Station) -> None:
    with station.browser() as first, station.browser() as second:
        assert first.get("/api/session").json()["provider"] == "Plant accounts"
        station.provider.put("1", preferred_username="Anna", groups=["sensor-operators"])
        signed_in = station.sign_in(first, "1").raise_for_status().json()["you"]
        assert (signed_in["name"], signed_in["role"]) == ("Anna", "operator")
        assert signed_in["by_provider"]
        assert station.newest() == ("Anna", "done")
        assert first.get("/api/logs").status_code == 200
        assert first.get("/api/accounts").status_code == 403
        groups = ["sensor-operators", "sensor-admins"]
        station.provider.put("1", preferred_username="anna", groups=groups)
        assert you(first)["role"] == "operator"
        assert station.sign_in(second, "1").json()["you"]["role"] == "admin"
        assert you(first) is None
        assert second.get("/api/accounts").status_code == 200
        known = {one["name"]: one for one in second.get("/api/accounts").json()}
        assert known["Anna"]["by_provider"]
        assert not known["Demo"]["by_provider"]


def test_a_person_who_lost_the_groups_is_signed_out_and_stays_out(station: Station) -> None:
    station.provider.put("2", preferred_username="Berta", groups=["sensor-viewers"])
    with station.browser() as first, station.browser() as second:
        assert station.sign_in(first, "2").json()["you"]["role"] == "viewer"
        station.provider.put("2", preferred_username="Berta", groups=["canteen"])
        refused = station.sign_in(second, "2")
        assert code_of(refused) == (401, "sign-in-no-group")
        text = "Berta is in no group of Plant accounts that may sign in here"
        assert refused.json()["detail"] == text
        assert station.newest() == ("", f"{text}.")
        assert you(first) is None
        assert you(second) is None


def test_a_person_with_a_new_name_keeps_the_account(station: Station) -> None:
    station.provider.put("3", preferred_username="Carla Alt", groups=["sensor-viewers"])
    with station.browser() as browser:
        station.sign_in(browser, "3").raise_for_status()
        station.provider.put("3", preferred_username="Carla Neu", groups=["sensor-viewers"])
        with station.browser() as other:
            assert station.sign_in(other, "3").json()["you"]["name"] == "Carla Neu"
        assert you(browser) is None
    names = {account.name for account in station.server.context.store.accounts.all()}
    assert "Carla Neu" in names
    assert "Carla Alt" not in names


def test_an_account_of_the_station_is_not_taken_over(station: Station) -> None:
    store = station.server.context.store
    store.accounts.add("Dora", Role.admin, PASSWORD)
    station.provider.put("4", preferred_username="dora", groups=["sensor-viewers"])
    station.provider.put("5", preferred_username="ＤＯＲＡ", groups=["sensor-admins"])
    station.provider.put("6", preferred_username="Demo", groups=["sensor-admins"])
    before = store.accounts.all()
    for subject in ("4", "5", "6"):
        with station.browser() as browser:
            assert code_of(station.sign_in(browser, subject)) == (401, "account-of-station")
            assert you(browser) is None
    assert store.accounts.all() == before
    with station.browser() as browser:
        body = {"name": "Dora", "password": PASSWORD}
        assert browser.post("/api/session", json=body).json()["you"]["role"] == "admin"


@pytest.mark.parametrize("name", ["", " ", "x" * 41, "a\nb\x00c"])
def test_a_name_that_is_no_name_is_refused(station: Station, name: str) -> None:
    station.provider.put("7", preferred_username=name, groups=["sensor-admins"])
    with station.browser() as browser:
        assert code_of(station.sign_in(browser, "7"))[0] == 401
        assert you(browser) is None


def test_nobody_sets_password_or_role_of_an_account_of_the_provider(station: Station) -> None:
    station.provider.put("8", preferred_username="Emil", groups=["sensor-viewers"])
    admin = station.server.http
    with station.browser() as browser:
        station.sign_in(browser, "8").raise_for_status()
        own = browser.post("/api/session/password", json={"old": "!", "new": PASSWORD})
        changes = ({"password": PASSWORD}, {"role": "admin"})
        by_admin = (admin.post("/api/account?name=emil", json=change) for change in changes)
        for refused in (own, *by_admin):
            assert code_of(refused) == (422, "account-of-provider")
        for password in ("!", "", PASSWORD, "nobody has this password"):
            local = browser.post("/api/session", json={"name": "Emil", "password": password})
            assert local.status_code == 401
        assert you(browser)["role"] == "viewer"
        admin.delete("/api/account", params={"name": "Emil"}).raise_for_status()
        assert you(browser) is None


def test_signing_out_names_the_page_of_the_provider(station: Station) -> None:
    with station.browser() as browser:
        station.sign_in(browser, "1").raise_for_status()
        page = browser.delete("/api/session").json()["sign_out_page"]
        assert you(browser) is None
    assert page.startswith(f"{station.provider.issuer}/oauth2/end_session?")
    parameters = httpx.URL(page).params
    assert parameters["post_logout_redirect_uri"] == f"http://{HOST}/"
    assert parameters["client_id"] == station.provider.client_id
    assert httpx.get(page).status_code == 200
    with station.browser() as browser:
        assert browser.delete("/api/session").json()["sign_out_page"] == ""


def test_each_failure_is_one_sentence(station: Station, monkeypatch: pytest.MonkeyPatch) -> None:
    def assert_reported(refused: httpx.Response, code: str) -> None:
        assert code_of(refused) == (401, f"sign-in-{code}")
        assert refused.json()["remedy"]
        assert station.newest() == ("", f"{refused.json()['detail']}.")

    with station.browser() as browser:
        page = begin(browser)
        answer = answer_of(page, "1")
        with station.browser() as other:
            assert_reported(finish(other, answer), "begin-again")
        finish(browser, answer).raise_for_status()
        assert_reported(finish(browser, answer), "begin-again")
        cancelled = answer_of(begin(browser), "1", action="deny")
        # the provider leaves the state out; a proper one does not
        cancelled = replace(cancelled, state=answer_of(begin(browser), "1").state)
        assert_reported(finish(browser, cancelled), "cancelled")
        state = answer_of(begin(browser), "1").state
        assert_reported(finish(browser, ProviderAnswer(state, "made up")), "code")
    with station.browser("10.9.8.8:8000") as elsewhere:
        refused = elsewhere.post("/api/session/provider")
        assert_reported(refused, "not-registered")
        assert "http://10.9.8.8:8000/sign-in" in refused.json()["remedy"]
    station.server.context.authenticator.note_provider_attempt(True, "127.0.0.1")
    own = station.server.context.provider
    assert own is not None
    monkeypatch.setattr(type(own.settings), "client_secret", lambda _: "a wrong one")
    with station.browser() as browser:
        assert_reported(station.sign_in(browser, "1"), "secret")


def test_wrong_tries_are_slowed_down_apart_from_those_of_passwords(
    station: Station, monkeypatch: pytest.MonkeyPatch
) -> None:
    # waits do not end while a busy machine is slow
    monkeypatch.setattr(station.server.context.authenticator._throttle, "_clock", lambda: 1e6)
    with station.browser() as browser:
        answers = [finish(browser, ProviderAnswer("x", "y")) for _ in range(8)]
        assert [one.status_code for one in answers[:5]] == [401] * 5
        assert code_of(answers[-1]) == (429, "too-many-tries")
        assert browser.post("/api/session/provider").status_code == 429
        body = {"name": "nobody", "password": PASSWORD}
        assert browser.post("/api/session", json=body).status_code == 401


TEXTS = st.one_of(st.text(max_size=50), st.integers(), st.none())


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(
    body=st.one_of(
        st.fixed_dictionaries({"state": TEXTS, "code": TEXTS, "error": TEXTS}),
        st.dictionaries(st.text(max_size=9), TEXTS, max_size=3),
    ),
    cookie=st.text(st.characters(min_codepoint=33, max_codepoint=126), max_size=60),
)
def test_any_strange_answer_fails(station: Station, body: dict[str, object], cookie: str) -> None:
    with station.browser() as browser, pytest.MonkeyPatch.context() as patch:
        patch.setattr(login_throttle, "FREE_TRIES", 10**6)
        headers = {"Cookie": f"crenel-8000-pending={cookie}"}
        answer = browser.post("/api/session/provider/answer", json=body, headers=headers)
        assert answer.status_code in (401, 422)
        assert "Traceback" not in answer.text
        assert station.provider.secret not in answer.text


def test_the_secret_is_in_no_support_bundle(station: Station) -> None:
    log.warning("the secret is %s", station.provider.secret)
    packed = station.server.http.get("/api/support.zip").raise_for_status().content
    with zipfile.ZipFile(io.BytesIO(packed)) as bundle:
        contents = {name: bundle.read(name).decode() for name in bundle.namelist()}
    assert any("the secret is" in text for text in contents.values())
    for text in contents.values():
        assert station.provider.secret not in text


def test_a_station_without_a_provider_has_none(tmp_path: Path) -> None:
    with running_server(tmp_path) as server:
        assert server.http.get("/api/session").json()["provider"] == ""
        assert code_of(server.http.post("/api/session/provider")) == (404, "not-found")
        assert finish(server.http, ProviderAnswer("x")).status_code == 404


def quality_in_health(server: Server) -> str:
    items = HealthChecker(server.context).look().items
    return next(item.quality for item in items if item.id == "sign-in")


def test_a_station_works_without_provider(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(provider_module, "METADATA_S", 0.0)
    with ExitStack() as running, ExitStack() as plant:
        provider = plant.enter_context(mock_provider())
        provider.register(BACK)
        provider.put("1", preferred_username="Anna", groups=["sensor-operators"])
        own = provider.settings(tmp_path)
        server = running.enter_context(running_server(tmp_path / "data", sign_in=own))
        station = Station(server, provider)
        anna, other = (running.enter_context(station.browser()) for _ in range(2))
        station.sign_in(anna, "1").raise_for_status()
        server.context.store.accounts.add("Ben", Role.operator, PASSWORD)
        assert quality_in_health(server) == "good"
        plant.close()
        assert quality_in_health(server) == "attention"
        refused = other.post("/api/session/provider")
        assert code_of(refused) == (401, "sign-in-provider-away")
        assert refused.json()["detail"] == "Plant accounts cannot be reached"
        assert station.newest() == ("", "Plant accounts cannot be reached.")
        trouble = other.get("/api/session").json()["provider_trouble"]
        assert trouble["message_id"] == "sign-in-provider-away"
        assert you(anna)["name"] == "Anna"
        anna.post("/api/laser/off").raise_for_status()
        body = {"name": "Ben", "password": PASSWORD}
        assert other.post("/api/session", json=body).json()["you"]["name"] == "Ben"
        assert anna.delete("/api/session").json()["sign_out_page"] == ""
        assert not server.sent.untranslated()
