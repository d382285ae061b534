"""Signing in and out, control, accounts and kiosk links, as browsers do it."""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial

import httpx
import pytest
from websockets.sync.client import connect

from crenel.store.accounts import Role
from tests.api.conftest import PATIENCE_S, Server, code_of, until_closed
from tests.entering import cookie
from tests.sent_texts import english

pytestmark = pytest.mark.device

PASSWORD = "three unrelated words"


@contextmanager
def browser(server: Server, name: str = "", password: str = PASSWORD) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=server.address, timeout=PATIENCE_S) as http:
        if name:
            sign_in(http, name, password).raise_for_status()
        yield http


def sign_in(http: httpx.Client, name: str, password: str = PASSWORD) -> httpx.Response:
    return http.post("/api/session", json={"name": name, "password": password})


def forget_guesses(server: Server, *names: str) -> None:
    """They slow no next test down."""
    keys = ("address 127.0.0.1", *(f"name {name}" for name in names))
    server.context.authenticator._throttle.note_success(*keys)


@pytest.fixture
def people(server: Server, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    # waits do not end while a busy machine is slow
    monkeypatch.setattr(server.context.authenticator._throttle, "_clock", lambda: 1e6)
    accounts = server.context.store.accounts
    for name, role in (("Anna", Role.operator), ("Ben", Role.operator), ("Vera", Role.viewer)):
        accounts.add(name, role, PASSWORD)
    server.http.post("/api/control/take", json={"reason": "a test begins"}).raise_for_status()
    server.http.post("/api/control/release").raise_for_status()
    yield
    for name in ("Anna", "Ben", "Vera"):
        if accounts.get(name) is not None:
            accounts.remove(name)
    server.http.post("/api/control/take", json={"reason": "a test is over"}).raise_for_status()


def test_a_sign_in_is_a_cookie_that_no_script_reads(server: Server, people: None) -> None:
    with browser(server) as http:
        assert http.get("/api/session").json()["you"] is None
        answer = sign_in(http, " anna ")
        assert answer.json()["you"]["name"] == "Anna"
        flags = answer.headers["set-cookie"].lower()
        assert "httponly" in flags
        assert "samesite=strict" in flags
        assert http.get("/api/home").status_code == 200
        kept = cookie(http)
        http.delete("/api/session").raise_for_status()
        assert http.get("/api/home").status_code == 401
        with browser(server) as other:
            assert other.get("/api/home", headers=kept).status_code == 401


@pytest.mark.parametrize("name", ["Anna", "Nobody", "", "Demo", "' OR 1=1 --"])
def test_a_wrong_password_is_answered_alike(server: Server, people: None, name: str) -> None:
    with browser(server) as http:
        answer = sign_in(http, name, "!")
        assert code_of(answer) == (401, "wrong-password")
        assert "set-cookie" not in answer.headers
    forget_guesses(server)


def test_guessing_becomes_slow_also_for_the_right_password(server: Server, people: None) -> None:
    with browser(server) as http:
        codes = [sign_in(http, "Anna", "guess").status_code for _ in range(7)]
        assert (codes[0], codes[-1]) == (401, 429)
        answer = sign_in(http, "Anna")
        assert answer.status_code == 429
        assert int(answer.headers["retry-after"]) >= 1
        forget_guesses(server, "anna")
        assert sign_in(http, "Anna").status_code == 200


def test_guesses_keep_nobody_out_of_a_browser_that_is_known(server: Server, people: None) -> None:
    with browser(server, "Anna") as anna, browser(server) as other:
        # one name however it is spelled, and one address whatever a header says
        spellings = ("Anna", "anna ", "ANNA", "\uff21nna", " Anna", "Anna\u2003") * 3
        codes: list[int] = []
        for spelled in spellings:
            asked = {"name": spelled, "password": "guess"}
            elsewhere = {"x-forwarded-for": f"10.0.0.{len(codes)}"}
            codes.append(other.post("/api/session", json=asked, headers=elsewhere).status_code)
            if codes[-1] == 429:
                break
        failures = server.context.authenticator._throttle._failures
        assert failures["name anna"][0] == failures["address 127.0.0.1"][0] == codes.count(401)
        assert codes[-1] == 429
        anna.delete("/api/session").raise_for_status()
        assert sign_in(anna, "Anna").status_code == 200
        # there it becomes slow for who guesses, too
        anna.delete("/api/session").raise_for_status()
        assert 429 in [sign_in(anna, "Anna", "guess").status_code for _ in range(12)]
    forget_guesses(server, "anna")


def test_signing_out_closes_what_is_live(server: Server, people: None) -> None:
    with (
        browser(server, "Vera") as http,
        connect(server.live, additional_headers=cookie(http)) as socket,
    ):
        assert '"Vera"' in str(socket.recv(PATIENCE_S))
        http.delete("/api/session").raise_for_status()
        assert until_closed(socket) == 4401


def test_control_is_taken_by_acting_and_seen_by_all(server: Server, people: None) -> None:
    with browser(server, "Anna") as anna, browser(server, "Ben") as ben:
        assert anna.post("/api/exposure", json={"exposure_us": 3000}).status_code == 200
        refused = ben.post("/api/exposure", json={"exposure_us": 3000})
        assert code_of(refused) == (422, "control")
        assert "Anna has control" in refused.json()["detail"]
        # what ends a danger needs no control
        assert ben.post("/api/laser/off").status_code == 200
        assert ben.post("/api/stop").status_code == 204

        assert ben.post("/api/control/ask").json()["asked_by"]["name"] == "Ben"
        assert ben.post("/api/control/answer", json={"give": True}).status_code == 422
        given = anna.post("/api/control/answer", json={"give": True}).json()
        assert given["holder"]["name"] == "Ben"
        assert anna.post("/api/exposure", json={"exposure_us": 3000}).status_code == 422

        assert anna.post("/api/control/take", json={}).json()["code"] == "control-reason"
        taken = anna.post("/api/control/take", json={"reason": "Ben is at lunch"}).json()
        assert taken["holder"]["name"] == "Anna"
        with browser(server) as admin:
            admin.cookies = server.http.cookies
            acts = [english(entry["act"]) for entry in admin.get("/api/audit").json()]
        assert "took over control: Ben is at lunch" in acts
        anna.delete("/api/session").raise_for_status()
        assert ben.post("/api/exposure", json={"exposure_us": 3000}).status_code == 200


def test_a_viewer_looks_on(server: Server, people: None) -> None:
    with browser(server, "Vera") as vera:
        assert vera.get("/api/flow").status_code == 200
        answer = vera.post("/api/flow/start")
        assert answer.status_code == 403
        assert "Vera may not do this" in answer.json()["detail"]


def test_a_new_password_signs_out_every_other_browser(server: Server, people: None) -> None:
    with browser(server, "Vera") as here, browser(server, "Vera") as there:

        def change(old: str, new: str) -> httpx.Response:
            return here.post("/api/session/password", json={"old": old, "new": new})

        assert change("?", PASSWORD + "!").status_code == 403
        assert change(PASSWORD, "short").json()["code"] == "password-length"
        assert change(PASSWORD, PASSWORD + "!").status_code == 200
        assert here.get("/api/home").status_code == 200
        assert there.get("/api/home").status_code == 401
        with browser(server, "Vera", PASSWORD + "!") as later:
            assert later.get("/api/home").status_code == 200


def test_administrators_make_change_and_remove_accounts(server: Server, people: None) -> None:
    admin = server.http
    new = {"name": "Carl", "role": "viewer", "password": PASSWORD}
    assert admin.post("/api/accounts", json=new).json()["role"] == "viewer"
    for name, code in (("carl", "account-taken"), (" ", "account-name")):
        assert admin.post("/api/accounts", json={**new, "name": name}).json()["code"] == code
    with browser(server, "Carl") as carl:
        assert admin.post("/api/account?name=Carl", json={"role": "operator"}).status_code == 200
        assert carl.get("/api/home").status_code == 401
        assert admin.delete("/api/account?name=Carl").status_code == 204
        assert sign_in(carl, "Carl").status_code == 401
    assert admin.delete("/api/account?name=Carl").status_code == 404
    forget_guesses(server, "carl")


@pytest.mark.parametrize("name", ["a/b", "..", ".", "?x#y", "100%", "a b/../c", "ä ", "\\"])
def test_an_account_of_any_name_is_changed_and_removed(server: Server, name: str) -> None:
    admin, asked = server.http, {"name": name}
    new = {"name": name, "role": "viewer", "password": PASSWORD}
    assert admin.post("/api/accounts", json=new).status_code == 200
    changed = admin.post("/api/account", params=asked, json={"role": "operator"})
    assert changed.json()["role"] == "operator"
    assert admin.delete("/api/account", params=asked).status_code == 204
    assert admin.delete("/api/account", params=asked).status_code == 404


def test_a_user_who_loses_the_account_loses_control_at_once(server: Server, people: None) -> None:
    def holder() -> str | None:
        person = server.context.lease.control.holder
        return person.name if person else None

    for end in (
        partial(server.http.delete, "/api/account", params={"name": "Anna"}),
        partial(server.http.post, "/api/account", params={"name": "Ben"}, json={"role": "viewer"}),
    ):
        name = "Anna" if server.context.store.accounts.get("Anna") else "Ben"
        with browser(server, name) as http:
            assert http.post("/api/control/ask").status_code == 200
            assert holder() == name
            assert end().is_success
            assert holder() is None


def test_what_was_done_is_in_the_audit_log_before_it_is_answered(server: Server) -> None:
    for number in range(20):
        made = server.http.post("/api/kiosk-links", json={"name": f"Audit {number}"}).json()
        newest = server.context.store.audit.newest(1)[0]
        assert str(newest.act) == f"created a kiosk link: Audit {number}"
        server.http.delete(f"/api/kiosk-links/{made['id']}").raise_for_status()
        assert str(server.context.store.audit.newest(1)[0].act).startswith("revoked a kiosk link")


def test_the_last_administrator_stays(server: Server) -> None:
    accounts = server.context.store.accounts
    (guest,) = (one.name for one in accounts.all() if one.role is Role.admin)
    for name in (guest, guest.lower()):
        assert server.http.delete(f"/api/account?name={name}").json()["code"] == "last-admin"
        change = server.http.post(f"/api/account?name={name}", json={"role": "viewer"})
        assert change.json()["code"] == "last-admin"
    accounts.add("Ada", Role.admin, PASSWORD)
    assert server.http.delete("/api/account?name=Ada").status_code == 204


def test_a_kiosk_shows_and_does_nothing(server: Server) -> None:
    made = server.http.post("/api/kiosk-links", json={"name": "Hall 3"}).json()
    with browser(server) as screen:
        assert screen.post("/api/session/kiosk", json={"code": "guess"}).status_code == 401
        entered = screen.post("/api/session/kiosk", json={"code": made["token"]}).json()
        you = {"name": "Hall 3", "role": "viewer", "kiosk": True, "by_provider": False}
        assert entered["you"] == {**you, "id": entered["you"]["id"]}
        assert screen.get("/api/flow").status_code == 200
        assert screen.post("/api/stop").status_code == 403
        (listed,) = (w for w in server.http.get("/api/kiosk-links").json() if w["id"] == made["id"])
        assert (listed["name"], listed["token"]) == ("Hall 3", None)
        assert server.http.delete(f"/api/kiosk-links/{made['id']}").status_code == 204
        assert screen.get("/api/flow").status_code == 401
    assert server.http.delete("/api/kiosk-links/none").status_code == 404
