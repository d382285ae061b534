"""Coming in as a browser does: by the link or the code that the console shows."""

from collections.abc import Iterator
from contextlib import contextmanager

import httpx


@contextmanager
def client(link: str) -> Iterator[httpx.Client]:
    """A client that entered a demonstration by its link."""
    base, _, fragment = link.partition("#")
    with httpx.Client(base_url=base, timeout=20.0) as http:
        enter(http, fragment.removeprefix("code="))
        yield http


def enter(http: httpx.Client, code: str | None) -> None:
    """Signs a client in as a demonstration's guest."""
    http.post("/api/session/code", json={"code": code}).raise_for_status()


def cookie(http: httpx.Client) -> dict[str, str]:
    """The header that a live connection of this client sends."""
    return {"Cookie": "; ".join(f"{name}={value}" for name, value in http.cookies.items())}
