"""Accounts, sign-ins and the audit log in the database."""

import sqlite3
from datetime import UTC, datetime, timedelta

import pytest

from crenel.messages.catalogue import renderer
from crenel.messages.message import message
from crenel.monitoring.log_store import LogStore
from crenel.security.authentication import Authenticator
from crenel.store import login_sessions as sign_ins
from crenel.store.accounts import Role
from crenel.store.store import Store
from tests.refusals import refused
from tests.store.conftest import open_database

pytestmark = pytest.mark.slow

PASSWORD = "three unrelated words"


def test_neither_password_nor_token_stands_in_the_database(store: Store) -> None:
    store.accounts.add("Anna", Role.operator, PASSWORD)
    cookie = store.login_sessions.begin("Anna", "a browser")
    _, link = store.kiosk_links.add("Hall", "Anna")
    content = b"".join(path.read_bytes() for path in store.folder.glob("station.db*"))
    for secret in (PASSWORD, cookie, link):
        assert secret.encode() not in content
    assert b"$argon2id$" in content


def test_passwords_match_their_own_account_only(store: Store) -> None:
    store.accounts.add("Anna", Role.operator, PASSWORD)
    store.accounts.add("Ben", Role.viewer, PASSWORD + "!")
    assert store.accounts.authenticate("ANNA", PASSWORD) == store.accounts.get("anna")
    for name, password in (("Anna", PASSWORD + "!"), ("Ben", PASSWORD), ("Carl", PASSWORD)):
        assert store.accounts.authenticate(name, password) is None


def test_a_guest_has_no_password_and_is_an_administrator_while_the_code_holds(store: Store) -> None:
    store.accounts.add("Demo", Role.admin, None)
    assert not store.accounts.has_admin()
    assert store.accounts.authenticate("Demo", "!") is None
    assert store.accounts.authenticate("Demo", "") is None
    entrance = Authenticator(store.accounts, store.login_sessions, store.api_tokens, "Demo", "ABCD")
    for name in ("Demo", "demo"):
        with refused("last-admin"):
            store.accounts.remove(name)
        with refused("last-admin"):
            store.accounts.set_role(name, Role.operator)
    assert entrance.guest_by_code("abcd", "::1") == "Demo"
    store.accounts.add("Anna", Role.admin, PASSWORD)
    store.accounts.remove("Demo")
    assert entrance.guest_by_code("abcd", "::1") is None
    with refused("account-gone"):
        store.login_sessions.begin("Demo", "a browser")
    with refused("last-admin"):
        store.accounts.remove("Anna")


@pytest.mark.parametrize(
    ("name", "password", "code"),
    [
        ("", PASSWORD, "account-name"),
        ("x" * 41, PASSWORD, "account-name"),
        ("a\x00b", PASSWORD, "account-name"),
        ("Carl", "short", "password-length"),
        ("Carl", "x" * 201, "password-length"),
        ("ABCDEFGHIJ", "abcdefghij", "password-is-name"),
    ],
)
def test_what_will_not_do_is_refused(store: Store, name: str, password: str, code: str) -> None:
    with refused(code):
        store.accounts.add(name, Role.viewer, password)
    assert store.accounts.all() == []


def test_sign_ins_end_with_time_or_account(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    store.accounts.add("Anna", Role.operator, PASSWORD)
    first, second = (store.login_sessions.begin("Anna", "a browser") for _ in range(2))
    assert store.login_sessions.principal(first) != store.login_sessions.principal(second)
    store.accounts.remove("Anna")
    assert store.login_sessions.principal(first) is None

    store.accounts.add("Anna", Role.operator, PASSWORD)
    again = store.login_sessions.begin("Anna", "a browser")
    assert store.login_sessions.principal(again) is not None
    with monkeypatch.context() as patch:
        patch.setattr(sign_ins, "datetime", moment(sign_ins.IDLE + timedelta(seconds=1)))
        assert store.login_sessions.principal(again) is None
    assert store.login_sessions.principal(again) is None


def moment(ahead: timedelta) -> type[datetime]:
    """A clock that is ahead."""

    class Ahead(datetime):
        @classmethod
        def now(cls, tz: object = None) -> datetime:  # type: ignore[override]
            return datetime.now(UTC) + ahead

    return Ahead


def test_a_page_left_open_is_signed_out(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    store.accounts.add("Anna", Role.operator, PASSWORD)
    cookie = store.login_sessions.begin("Anna", "a browser")
    hour = timedelta(hours=1)
    for hours in range(1, int(sign_ins.LONGEST / hour) + 1):
        ahead = hours * hour - timedelta(minutes=1)
        monkeypatch.setattr(sign_ins, "datetime", moment(ahead))
        seen = (datetime.now(UTC) + ahead).isoformat()
        monkeypatch.setattr(sign_ins, "utc_now", lambda seen=seen: seen)
        assert store.login_sessions.principal(cookie) is not None, hours
    monkeypatch.setattr(sign_ins, "datetime", moment(sign_ins.LONGEST + timedelta(minutes=1)))
    assert store.login_sessions.principal(cookie) is None


def test_the_audit_log_is_searched_by_words(store: Store) -> None:
    store.audit.note("Anna", "10.0.0.1", "pressed Stop")
    store.audit.note("Ben", "10.0.0.2", "pressed Stop")
    store.audit.note("Ben", "10.0.0.2", "wrote 100% of it")
    found = [(entry.who, entry.act) for entry in store.audit.newest(10, " STOP ben")]
    assert found == [("Ben", "pressed Stop")]
    assert [entry.who for entry in store.audit.newest(10, "%")] == ["Ben"]
    assert store.audit.newest(10, "anna 10.0.0.2") == []
    assert len(store.audit.newest(2, "10.0.0")) == 2


def test_half_of_a_character_holds_up_no_other_entry_of_the_audit_log(store: Store) -> None:
    store.audit.note("\udcfc", "10.0.0.1", "signed in", "\ud800")
    store.audit.note("Anna", "10.0.0.1", "pressed Stop")
    assert [entry.who for entry in store.audit.newest(2)] == ["Anna", "\\udcfc"]


def test_the_audit_log_is_searched_in_the_readers_language_too(store: Store) -> None:
    act, why = message("account-has-no-name"), message("password-has-characters", count=3)
    store.audit.note("Anna", "10.0.0.1", "pressed Stop")
    store.audit.note("Ben", "10.0.0.2", act, why)
    german = renderer("de")
    assert [entry.who for entry in store.audit.newest(10, "3 zeichen konto", german)] == ["Ben"]
    assert [entry.who for entry in store.audit.newest(10, "3 characters", german)] == ["Ben"]
    assert [entry.who for entry in store.audit.newest(1, "anna", german)] == ["Anna"]
    assert [entry.who for entry in store.audit.newest(10, "pressed", german)] == ["Anna"]
    assert len(store.audit.newest(10, "", german)) == 2
    assert store.audit.newest(10, "3 zeichen") == []


def test_the_audit_log_is_only_ever_added_to(store: Store) -> None:
    store.audit.note("Anna", "10.0.0.1", "pressed Stop")
    store.audit.note("", "10.0.0.2", "signed in", "wrong password" * 100)
    entries = [(entry.who, entry.act) for entry in store.audit.newest(10)]
    assert entries == [("", "signed in"), ("Anna", "pressed Stop")]
    with open_database(store) as database:
        for statement in ("DELETE FROM audit", "UPDATE audit SET who = 'Eve'"):
            with pytest.raises(sqlite3.IntegrityError, match="append-only"):
                database.execute(statement)


def test_the_log_is_english_with_the_messages_next_to_it(store: Store) -> None:
    act, why = message("account-has-no-name"), message("password-has-characters", count=3)
    store.audit.note("Anna", "10.0.0.1", act, why)
    store.audit.note("Anna", "10.0.0.1", "pressed Stop")
    first = store.audit.newest(10)[1]
    assert (first.act, first.outcome) == (act, why)
    with open_database(store) as database:
        rows = database.execute("SELECT act, outcome FROM audit ORDER BY number").fetchall()
    assert rows == [(str(act), str(why)), ("pressed Stop", "done")]


def test_the_database_and_what_is_logged_are_for_the_owner_alone(store: Store) -> None:
    file = store.folder / "station.db"
    assert file.stat().st_mode & 0o777 == 0o600
    journal = file.with_name("station.db-wal")
    assert journal.stat().st_mode & 0o777 == 0o600
    book = LogStore(store.folder)
    book.close()
    assert book.folder.stat().st_mode & 0o777 == 0o700
    store.close()
    (store.folder / "scans").rename(store.folder.parent / "scans")
    (store.folder / "scans").symlink_to(store.folder.parent / "scans")
    for folder in (store.folder, store.folder / "scans"):
        folder.chmod(0o2775)  # of an earlier version, shared with a group
    Store(store.folder).close()
    for folder in (store.folder, store.folder / "scans"):
        assert folder.stat().st_mode & 0o7777 == 0o2770


def test_a_browser_is_known_for_those_who_signed_in_at_it(store: Store) -> None:
    for name in ("Anna", "Ben"):
        store.accounts.add(name, Role.operator, PASSWORD)
    token = store.login_sessions.remember_browser("", "Anna")
    assert store.login_sessions.is_known_browser(token, "anna")
    assert not store.login_sessions.is_known_browser(token, "Ben")
    assert not store.login_sessions.is_known_browser("", "Anna")
    assert store.login_sessions.remember_browser(token, "Ben") == token
    assert store.login_sessions.remember_browser("made up", "Ben") != "made up"
    assert store.login_sessions.principal(token) is None  # it lets nobody in
    store.accounts.remove("Anna")
    assert not store.login_sessions.is_known_browser(token, "Anna")
    assert store.login_sessions.is_known_browser(token, "Ben")


def test_who_signed_in_with_another_provider_must_sign_in_again(store: Store) -> None:
    store.accounts.add("Local", Role.viewer, PASSWORD)
    store.accounts.admit("https://one", "1", "One", Role.viewer)
    store.accounts.admit("https://two", "1", "Two", Role.viewer)
    tokens = {name: store.login_sessions.begin(name, "") for name in ("Local", "One", "Two")}
    store.login_sessions.end_other_providers("https://two")
    known = {name for name, token in tokens.items() if store.login_sessions.principal(token)}
    assert known == {"Local", "Two"}
    store.login_sessions.end_other_providers("")
    known = {name for name, token in tokens.items() if store.login_sessions.principal(token)}
    assert known == {"Local"}


def test_an_administrator_of_the_provider_does_not_replace_the_last_one(store: Store) -> None:
    store.accounts.add("Anna", Role.admin, PASSWORD)
    store.accounts.admit("https://one", "1", "Ben", Role.admin)
    with refused("last-admin"):
        store.accounts.remove("Anna")
    with refused("account-of-provider"):
        store.accounts.set_password("ben", PASSWORD)
    with refused("account-of-provider"):
        store.accounts.set_role("ben", Role.viewer)
