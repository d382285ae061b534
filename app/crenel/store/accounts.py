"""The people who may sign in, and the role of each."""

import sqlite3
import unicodedata
from dataclasses import dataclass
from enum import IntEnum
from functools import cache

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.store.database import Database
from crenel.timestamps import utc_now

LONGEST_NAME = 40
SHORTEST_PASSWORD, LONGEST_PASSWORD = 10, 200
HASHER = PasswordHasher()
NO_PASSWORD = "!"
"""In place of a hash: the account can sign in with a link, or at a provider, only."""
ADMINS = "SELECT name FROM account WHERE role = 'admin' AND (password <> ? OR name = ?)"
"""Those who can sign in: with a password, or as the guest."""


class Role(IntEnum):
    """The role of an account; each role includes those below it."""

    viewer = 1
    """See everything."""
    operator = 2
    """Probe, capture, calibrate, scan."""
    admin = 3
    """Manage accounts, links and the audit log."""


@dataclass(frozen=True, slots=True)
class Account:
    """One person, or one kiosk."""

    name: str
    role: Role
    made_at: str
    provider: str = ""
    """The issuer of an account of a provider; empty for one of this station."""


class AccountStore:
    """Accounts by name, ignoring case; passwords as argon2id hashes."""

    def __init__(self, database: Database) -> None:
        self._database = database
        self._guest = ""

    def all(self) -> list[Account]:
        """All accounts, by name."""
        return self._read("ORDER BY name")

    def get(self, name: str) -> Account | None:
        found = self._read("WHERE name = ?", plain_name(name))
        return found[0] if found else None

    def has_admin(self) -> bool:
        """Whether anyone can sign in as an administrator."""
        return bool(self._database.read(ADMINS, NO_PASSWORD, self._guest))

    def admit_guest(self, name: str) -> None:
        """Lets an account sign in with the console's code while this process runs; creates it as
        an administrator if it does not exist."""
        if self.get(name) is None:
            self.add(name, Role.admin, None)
        self._guest = name

    def add(self, name: str, role: Role, password: str | None) -> Account:
        """Creates an account; without a password, it can sign in with a link only.

        Raises:
            OperationError: the name is taken or invalid, or the password is unsuitable.
        """
        name = _check_account_name(name)
        hashed = NO_PASSWORD if password is None else self._hash_password(name, password)
        account = Account(name, role, utc_now())
        with self._database.transaction() as connection:
            taken = connection.execute("SELECT 1 FROM account WHERE name = ?", (name,)).fetchone()
            if taken:
                raise OperationError(
                    "account-taken",
                    message("account-taken", name=name),
                    remedy=message("choose-another-name"),
                )
            connection.execute(
                "INSERT INTO account (name, role, password, made_at) VALUES (?, ?, ?, ?)",
                (account.name, role.name, hashed, account.made_at),
            )
        return account

    def admit(self, provider: str, subject: str, name: str, role: Role) -> Account:
        """The account of a person whom a provider signed in, with the role that they have now.

        The person is recognised by the subject: with another name than before, the account gets
        that name, and browsers with the former one are signed out.

        Raises:
            OperationError: the name is invalid, or belongs to another account, which stays as it
                is.
        """
        name = _check_account_name(name)
        with self._database.transaction() as connection:
            rows = connection.execute(
                "SELECT name, role, made_at FROM account WHERE provider = ? AND subject = ?",
                (provider, subject),
            ).fetchall()
            before = rows[0]["name"] if rows else None
            if before is not None and before.lower() == name.lower():
                connection.execute(
                    "UPDATE account SET role = ? WHERE name = ?", (role.name, before)
                )
                return Account(before, role, rows[0]["made_at"], provider)
            if connection.execute("SELECT 1 FROM account WHERE name = ?", (name,)).fetchone():
                raise OperationError(
                    "account-of-station",
                    message("account-belongs-to-another", name=name),
                    remedy=message("account-remove-or-use-password"),
                )
            if before is not None:
                connection.execute("DELETE FROM account WHERE name = ?", (before,))
            made_at = rows[0]["made_at"] if rows else utc_now()
            connection.execute(
                "INSERT INTO account (name, role, password, made_at, provider, subject)"
                " VALUES (?, ?, ?, ?, ?, ?)",
                (name, role.name, NO_PASSWORD, made_at, provider, subject),
            )
        return Account(name, role, made_at, provider)

    def find_subject(self, provider: str, subject: str) -> Account | None:
        """The account of a person of a provider."""
        found = self._read("WHERE provider = ? AND subject = ?", provider, subject)
        return found[0] if found else None

    def authenticate(self, name: str, password: str) -> Account | None:
        """The account to which name and password belong; takes equally long for unknown names."""
        rows = self._database.read("SELECT * FROM account WHERE name = ?", plain_name(name))
        known = bool(rows) and rows[0]["password"] != NO_PASSWORD
        hashed = rows[0]["password"] if known else _dummy_hash()
        try:
            HASHER.verify(hashed, password)
        except (VerificationError, InvalidHashError):
            return None
        return _account(rows[0]) if known else None

    def check_local(self, name: str) -> None:
        """Raises ``OperationError`` if the provider decides on password and role."""
        account = self.get(name)
        if account is not None and account.provider:
            raise OperationError(
                "account-of-provider",
                message("account-is-of-provider", name=account.name),
                remedy=message("account-change-at-provider"),
            )

    def set_password(self, name: str, password: str) -> None:
        """Raises ``OperationError`` if the password is unsuitable, or for an account of a
        provider."""
        self.check_local(name)
        hashed = self._hash_password(name, password)
        with self._database.transaction() as connection:
            connection.execute("UPDATE account SET password = ? WHERE name = ?", (hashed, name))

    def set_role(self, name: str, role: Role) -> None:
        """Raises ``OperationError`` if no administrator would be left, or for an account of a
        provider."""
        self.check_local(name)
        with self._database.transaction() as connection:
            self._check_admin_left(connection, name, role)
            connection.execute("UPDATE account SET role = ? WHERE name = ?", (role.name, name))

    def remove(self, name: str) -> None:
        """Removes an account with its login sessions; raises ``OperationError`` like
        ``set_role``."""
        with self._database.transaction() as connection:
            self._check_admin_left(connection, name, None)
            connection.execute("DELETE FROM account WHERE name = ?", (name,))

    def _check_admin_left(
        self, connection: sqlite3.Connection, name: str, role: Role | None
    ) -> None:
        """Within the transaction of the change: two administrators may remove each other."""
        rows = connection.execute(ADMINS, (NO_PASSWORD, self._guest))
        admins = {row["name"].lower() for row in rows}
        if role is not Role.admin and admins == {name.lower()}:
            raise OperationError(
                "last-admin",
                message("only-administrator", name=name),
                message("somebody-must-able-give-people-access"),
                message("make-somebody-else-administrator-first"),
            )

    def _hash_password(self, name: str, password: str) -> str:
        if not SHORTEST_PASSWORD <= len(password) <= LONGEST_PASSWORD:
            raise OperationError(
                "password-length",
                message("password-has-characters", count=len(password)),
                message(
                    "password-length-wanted",
                    least=SHORTEST_PASSWORD,
                    most=LONGEST_PASSWORD,
                ),
                message("take-longer-one-three-unrelated-words"),
            )
        if password.lower() == name.lower():
            raise OperationError(
                "password-is-name",
                message("password-is-name"),
                remedy=message("take-another-password"),
            )
        return HASHER.hash(password)

    def _read(self, clause: str, *values: str) -> list[Account]:
        return [
            _account(row) for row in self._database.read(f"SELECT * FROM account {clause}", *values)
        ]


@cache
def _dummy_hash() -> str:
    """A hash for comparison if there is none."""
    return HASHER.hash("nobody has this password")


def _account(row: sqlite3.Row) -> Account:
    return Account(row["name"], Role[row["role"]], row["made_at"], row["provider"])


def plain_name(name: str) -> str:
    """A common spelling of names that look alike."""
    return " ".join(unicodedata.normalize("NFKC", name).split())


def _check_account_name(name: str) -> str:
    plain = plain_name(name)
    if not plain or len(plain) > LONGEST_NAME or not plain.isprintable():
        raise OperationError(
            "account-name",
            message("no-account-name", name=repr(plain))
            if plain
            else message("account-has-no-name"),
            message("account-name-length", most=LONGEST_NAME),
        )
    return plain
