"""Removes secrets and names of people from texts."""

import json
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from urllib.parse import quote, urlsplit

GONE = "[removed]"
SHORTEST_SECRET = 4
LONG_ENOUGH = 8
PATTERNS: tuple[tuple[re.Pattern[str], str], ...] = (
    (re.compile(r"-----BEGIN [A-Z ]+-----.*?(-----END [A-Z ]+-----|\Z)", re.S), GONE),
    (re.compile(r"\$argon2\S+"), GONE),
    (re.compile(r"(?i)\b(bearer|basic)\s+[a-z0-9._~+/=-]{6,}"), rf"\1 {GONE}"),
    (re.compile(r"(?<=://)[^/\s@\"']+@"), f"{GONE}@"),
    (re.compile(r"(?i)#(code|kiosk|wall)=\w[\w-]*"), rf"#\1={GONE}"),
    (
        re.compile(
            r"(?i)((?:password|passwd|secret|token|api_?key|authorization|cookie))"
            r"([\"']?\s*[=:]\s*[\"']?)([^\s\"',;}]+)"
        ),
        rf"\1\2{GONE}",
    ),
    (re.compile(r"(?<![\w.-])[A-Za-z0-9_-]{40,}(?![\w-])"), GONE),
    (
        re.compile(r"(?<![\w.])(?!127\.0\.0\.1|0\.0\.0\.0)(?:\d{1,3}\.){3}\d{1,3}(?![\w.])"),
        "ADDRESS",
    ),
    (
        re.compile(r"(?i)(?<![\w:])(?!::1\b)(?:[0-9a-f]{1,4}:){3,7}[0-9a-f]{1,4}(?![\w:])"),
        "ADDRESS",
    ),
)
SECRET_KEY = re.compile(r"(?i)password|passwd|secret|token|api_?key|credential|authorization")


class Redactor:
    """Knows what must be removed.

    Args:
        secrets: literal secrets, also found where no pattern matches.
        people: names, which are replaced by "person 1" and so on.
        folders: paths by their designation, e.g. the data folder.
    """

    def __init__(
        self, secrets: Iterable[str], people: Iterable[str], folders: dict[str, Path] | None = None
    ) -> None:
        known = {
            spelled
            for text in secrets
            if len(text) >= SHORTEST_SECRET
            for spelled in (text, json.dumps(text)[1:-1], repr(text)[1:-1], quote(text, safe=""))
        }
        self._secrets = sorted(known, key=len, reverse=True)
        named = sorted({name for name in people if name.strip()})
        self._people = [
            (re.compile(rf"(?<!\w){re.escape(name)}(?!\w)", re.I), f"person {number}")
            for number, name in enumerate(named, 1)
        ]
        places = {title: str(path) for title, path in (folders or {}).items()}
        self._places = sorted(places.items(), key=lambda item: len(item[1]), reverse=True)

    def text(self, text: str) -> str:
        """The redacted text."""
        for secret in self._secrets:
            text = text.replace(secret, GONE)
        for title, path in self._places:
            if len(path) > 1:
                text = text.replace(path, title)
        for pattern, instead in PATTERNS:
            text = pattern.sub(instead, text)
        for name, person in self._people:
            text = name.sub(person, text)
        return text

    def value(self, value: object, key: str = "") -> object:
        """The redacted JSON value; a value under the name of a secret is removed completely."""
        if SECRET_KEY.search(key) and value not in (None, "", True, False) and "file" not in key:
            return GONE
        if isinstance(value, str):
            return self.text(value)
        if isinstance(value, dict):
            return {self.text(str(name)): self.value(of, str(name)) for name, of in value.items()}
        if isinstance(value, (list, tuple)):
            return [self.value(one, key) for one in value]
        return value


def secrets_in(value: object, key: str = "") -> Iterator[str]:
    """Values under the name of a secret in settings, or after a user name in an address."""
    if isinstance(value, dict):
        for name, of in value.items():
            yield from secrets_in(of, str(name))
    elif isinstance(value, (list, tuple)):
        for one in value:
            yield from secrets_in(one, key)
    elif isinstance(value, str):
        if SECRET_KEY.search(key) and "file" not in key:
            yield value
        elif "://" in value:
            user, at, _ = value.partition("://")[2].partition("@")
            if at:
                yield user.partition(":")[2]


def address_secrets(address: str) -> Iterator[str]:
    """Parts of an address that may be keys: parts of its path and of its query."""
    yield address
    parts = urlsplit(address)
    pieces = [*parts.path.split("/"), *re.split("[&=]", parts.query), parts.password or ""]
    yield from (piece for piece in pieces if len(piece) >= LONG_ENOUGH)
