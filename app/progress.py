"""How long work tells how far it is."""

from collections.abc import Callable

Progress = Callable[[float, str], None]
"""Told the share done, 0 to 1, and what is being worked on (may be empty)."""


def no_progress(share: float, text: str) -> None:
    """For those who do not want to know."""
