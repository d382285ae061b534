"""Programs that may read the metrics, each by a token of its own.

Of tokens only the SHA-256 is kept, so that a copied database opens no door.
"""

import hashlib
import secrets
from dataclasses import dataclass

from app.store.database import Database
from app.timestamps import utc_now

TOKEN_BYTES = 32


@dataclass(frozen=True, slots=True)
class ApiToken:
    """One token, without what opens."""

    id: str
    name: str
    made_by: str
    made_at: str


class ApiTokenStore:
    """Tokens for ``/metrics``."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def add(self, name: str, made_by: str) -> tuple[ApiToken, str]:
        """A new one and its token, which is shown this once."""
        token = secrets.token_urlsafe(TOKEN_BYTES)
        api_token = ApiToken(secrets.token_hex(6), name, made_by, utc_now())
        with self._database.transaction() as connection:
            connection.execute(
                "INSERT INTO api_token (id, token, name, made_by, made_at) VALUES (?, ?, ?, ?, ?)",
                (
                    api_token.id,
                    _digest(token),
                    api_token.name,
                    api_token.made_by,
                    api_token.made_at,
                ),
            )
        return api_token, token

    def all(self) -> list[ApiToken]:
        """Every one, oldest first."""
        rows = self._database.read("SELECT * FROM api_token ORDER BY made_at")
        return [ApiToken(row["id"], row["name"], row["made_by"], row["made_at"]) for row in rows]

    def is_valid(self, token: str) -> bool:
        """Whether the token is one of these."""
        found = self._database.read("SELECT 1 FROM api_token WHERE token = ?", _digest(token))
        return bool(token) and bool(found)

    def remove(self, token_id: str) -> None:
        """Its token is good for nothing from now on."""
        with self._database.transaction() as connection:
            connection.execute("DELETE FROM api_token WHERE id = ?", (token_id,))


def _digest(token: str) -> str:
    return hashlib.sha256(token.encode()).hexdigest()
