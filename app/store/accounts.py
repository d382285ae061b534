"""The people who may sign in, and the role of each."""

import sqlite3
import unicodedata
from dataclasses import dataclass
from enum import IntEnum
from functools import cache

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

from app.errors import OperationError
from app.messages.message import message
from app.store.database import Database
from app.timestamps import utc_now

LONGEST_NAME = 40
SHORTEST_PASSWORD, LONGEST_PASSWORD = 10, 200
HASHER = PasswordHasher()
NO_PASSWORD = "!"
"""In place of a hash: the account can sign in with a link only."""


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


class AccountStore:
    """Accounts by name, ignoring case; passwords as argon2id hashes."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def all(self) -> list[Account]:
        """All accounts, by name."""
        return self._read("ORDER BY name")

    def get(self, name: str) -> Account | None:
        found = self._read("WHERE name = ?", plain_name(name))
        return found[0] if found else None

    def has_admin(self) -> bool:
        """Whether anyone can sign in as an administrator."""
        return bool(self._admins())

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

    def authenticate(self, name: str, password: str) -> Account | None:
        """The account to which name and password belong; takes equally long for unknown names."""
        rows = self._database.read("SELECT * FROM account WHERE name = ?", plain_name(name))
        hashed = rows[0]["password"] if rows else _dummy_hash()
        try:
            HASHER.verify(hashed, password)
        except (VerificationError, InvalidHashError):
            return None
        return _account(rows[0]) if rows else None

    def set_password(self, name: str, password: str) -> None:
        """Raises ``OperationError`` if the password is unsuitable."""
        hashed = self._hash_password(name, password)
        with self._database.transaction() as connection:
            connection.execute("UPDATE account SET password = ? WHERE name = ?", (hashed, name))

    def set_role(self, name: str, role: Role) -> None:
        """Raises ``OperationError`` if no administrator would be left."""
        self._check_admin_left(name, role)
        with self._database.transaction() as connection:
            connection.execute("UPDATE account SET role = ? WHERE name = ?", (role.name, name))

    def remove(self, name: str) -> None:
        """Removes an account with its login sessions; raises ``OperationError`` like
        ``set_role``."""
        self._check_admin_left(name, None)
        with self._database.transaction() as connection:
            connection.execute("DELETE FROM account WHERE name = ?", (name,))

    def _check_admin_left(self, name: str, role: Role | None) -> None:
        admins = {admin.lower() for admin in self._admins()}
        if role is not Role.admin and admins == {name.lower()}:
            raise OperationError(
                "last-admin",
                message("only-administrator", name=name),
                message("somebody-must-able-give-people-access"),
                message("make-somebody-else-administrator-first"),
            )

    def _admins(self) -> list[str]:
        """Names of the administrators who can sign in."""
        rows = self._database.read(
            "SELECT name FROM account WHERE role = 'admin' AND password <> ?", NO_PASSWORD
        )
        return [row["name"] for row in rows]

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
    return Account(row["name"], Role[row["role"]], row["made_at"])


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
