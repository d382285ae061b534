"""Secrets that give access to one thing each: a kiosk link to the station's display, an API token
to the metrics.

Only the SHA-256 of each is stored, so that a copied database gives no access.
"""

import hashlib
import secrets
from dataclasses import dataclass
from typing import Literal

from crenel.store.database import Database
from crenel.timestamps import utc_now

TOKEN_BYTES = 32
Table = Literal["kiosk_link", "api_token"]


@dataclass(frozen=True, slots=True)
class AccessToken:
    """A kiosk link or an API token, without the secret."""

    id: str
    name: str
    made_by: str
    made_at: str


class AccessTokenStore:
    """The secrets of one kind, which is a table of the database."""

    def __init__(self, database: Database, table: Table) -> None:
        self._database, self._table = database, table

    def add(self, name: str, made_by: str) -> tuple[AccessToken, str]:
        """A new entry and its secret, which is shown only once."""
        secret = secrets.token_urlsafe(TOKEN_BYTES)
        made = AccessToken(secrets.token_hex(6), name, made_by, utc_now())
        with self._database.transaction() as connection:
            connection.execute(
                f"INSERT INTO {self._table} (id, token, name, made_by, made_at)"
                " VALUES (?, ?, ?, ?, ?)",
                (made.id, token_digest(secret), made.name, made.made_by, made.made_at),
            )
        return made, secret

    def all(self) -> list[AccessToken]:
        """All entries, oldest first."""
        rows = self._database.read(
            f"SELECT id, name, made_by, made_at FROM {self._table} ORDER BY made_at"
        )
        return [AccessToken(**dict(row)) for row in rows]

    def find(self, secret: str) -> AccessToken | None:
        """The entry of a secret; None if there is none (any more)."""
        rows = self._database.read(
            f"SELECT id, name, made_by, made_at FROM {self._table} WHERE token = ?",
            token_digest(secret),
        )
        return AccessToken(**dict(rows[0])) if secret and rows else None

    def remove(self, token_id: str) -> bool:
        """Revokes a secret; False if there is no such entry."""
        with self._database.transaction() as connection:
            removed = connection.execute(f"DELETE FROM {self._table} WHERE id = ?", (token_id,))
        return removed.rowcount > 0


def token_digest(secret: str) -> str:
    """The stored form of a random secret."""
    return hashlib.sha256(secret.encode()).hexdigest()
