"""Login sessions: browsers by their cookie, kiosks by their link.

A browser in which somebody signed in before is identified by a second cookie, which gives no
access: passwords from this browser are checked even while others guess for the same name.

Only the SHA-256 of cookies and links is stored, so that a copied database gives no access.
"""

import logging
import secrets
import sqlite3
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.store.access_tokens import TOKEN_BYTES, AccessTokenStore, token_digest
from crenel.store.accounts import Role
from crenel.store.database import NOT_SAVED, Database
from crenel.timestamps import is_moment, parse_moment, utc_now

log = logging.getLogger(__name__)
IDLE = timedelta(hours=14)
"""A browser that was not used for this long must sign in again: longer than a shift."""
LONGEST = timedelta(days=7)
"""This long after signing in, a person must sign in again, even if active: a page may be left
open."""
ACTIVITY_STEP = timedelta(minutes=1)
ID_DIGITS = 12


@dataclass(frozen=True, slots=True)
class Principal:
    """The user of a request."""

    id: str
    """The id of this browser's login session; it gives no access."""
    name: str
    role: Role
    kiosk: bool
    """A screen on the shop floor without an operator."""
    provider: str = ""
    """The issuer of an account of a provider; empty for one of this station."""


class LoginSessionStore:
    """Valid cookies, and the user of a cookie or a kiosk link."""

    def __init__(self, database: Database) -> None:
        self._database = database
        self._kiosk_links = AccessTokenStore(database, "kiosk_link")
        self._in_memory: dict[str, tuple[str, str]] = {}
        """Browsers that signed in while the disk was full: account and time."""

    def begin(self, account: str, device: str) -> str:
        """Signs a browser in; returns its cookie, which is shown only once.

        Raises:
            OperationError: the account was removed just now.
        """
        token = secrets.token_urlsafe(TOKEN_BYTES)
        now = utc_now()
        try:
            with self._database.transaction() as connection:
                connection.execute(
                    "INSERT INTO sign_in (token, account, device, begun_at, seen_at)"
                    " VALUES (?, ?, ?, ?, ?)",
                    (token_digest(token), account, device[:200], now, now),
                )
        except sqlite3.IntegrityError as error:
            raise OperationError(
                "account-gone", message("there-no-account", name=account)
            ) from error
        except OperationError as error:  # a full disk keeps nobody out; the next start does
            if error.code != NOT_SAVED:
                raise
            log.warning("a sign-in is kept only in memory: %s", error.why)
            self._in_memory[token_digest(token)] = account, now
        return token

    def principal(self, token: str) -> Principal | None:
        """The user of a cookie or kiosk link; None if it is not valid (any more)."""
        digest = token_digest(token)
        rows = self._database.read(
            "SELECT sign_in.begun_at, sign_in.seen_at, account.name, account.role,"
            " account.provider FROM sign_in JOIN account ON account.name = sign_in.account"
            " WHERE token = ?",
            digest,
        )
        if rows:
            return self._principal(digest, rows[0])
        if digest in self._in_memory:
            return self._memory_principal(digest)
        link = self._kiosk_links.find(token)
        return Principal(digest[:ID_DIGITS], link.name, Role.viewer, kiosk=True) if link else None

    def _memory_principal(self, digest: str) -> Principal | None:
        account, begun_at = self._in_memory[digest]
        rows = self._database.read(
            "SELECT name, role, provider FROM account WHERE name = ?", account
        )
        late = datetime.now(UTC) - datetime.fromisoformat(begun_at) > IDLE
        if late or not rows:
            self._in_memory.pop(digest, None)
            return None
        return _principal_of(digest, rows[0])

    def _principal(self, digest: str, row: sqlite3.Row) -> Principal | None:
        now = datetime.now(UTC)
        if not (is_moment(row["seen_at"]) and is_moment(row["begun_at"])):
            self._end("token = ?", digest)  # from a damaged page
            return None
        idle = now - parse_moment(row["seen_at"])
        if idle > IDLE or now - parse_moment(row["begun_at"]) > LONGEST:
            self._end("token = ?", digest)
            return None
        if abs(idle) > ACTIVITY_STEP:  # or the clock was set back
            try:
                with self._database.transaction() as connection:
                    connection.execute(
                        "UPDATE sign_in SET seen_at = ? WHERE token = ?", (utc_now(), digest)
                    )
            except OperationError as error:  # a full disk does not prevent Stop
                log.warning("a sign-in is not noted as used: %s", error.why)
        return _principal_of(digest, row)

    def end(self, token: str) -> None:
        """Signs one browser out."""
        self._in_memory.pop(token_digest(token), None)
        self._end("token = ?", token_digest(token))

    def end_all(self, account: str) -> None:
        """Signs a user out everywhere."""
        for digest, (name, _) in list(self._in_memory.items()):
            if name.casefold() == account.casefold():
                self._in_memory.pop(digest, None)
        self._end("account = ?", account)

    def end_other_providers(self, provider: str) -> None:
        """Signs out everyone whose account is of another provider; an empty one: of any."""
        self._end("account IN (SELECT name FROM account WHERE provider NOT IN ('', ?))", provider)

    def remember_browser(self, token: str, account: str) -> str:
        """Marks a browser as known for this account; returns its token, a new one if it had
        none."""
        query = "SELECT 1 FROM known_browser WHERE token = ?"
        if not self._database.read(query, token_digest(token)):
            token = secrets.token_urlsafe(TOKEN_BYTES)
        try:
            with self._database.transaction() as connection:
                connection.execute(
                    "INSERT OR IGNORE INTO known_browser (token, account, made_at)"
                    " VALUES (?, ?, ?)",
                    (token_digest(token), account, utc_now()),
                )
        except OperationError as error:  # it is known from the next time on
            if error.code != NOT_SAVED:
                raise
        return token

    def is_known_browser(self, token: str, account: str) -> bool:
        """Whether this account signed in at the browser of this token before."""
        query = "SELECT 1 FROM known_browser WHERE token = ? AND account = ?"
        return bool(token) and bool(self._database.read(query, token_digest(token), account))

    def _end(self, clause: str, value: str) -> None:
        with self._database.transaction() as connection:
            connection.execute(f"DELETE FROM sign_in WHERE {clause}", (value,))


def _principal_of(digest: str, row: sqlite3.Row) -> Principal:
    role = Role[row["role"]]
    return Principal(digest[:ID_DIGITS], row["name"], role, kiosk=False, provider=row["provider"])
