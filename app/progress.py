"""How long work reports how far it is."""

from collections.abc import Callable

from app.messages.message import Text

Progress = Callable[[float, Text], None]
"""Called with the share done, 0 to 1, and what is being worked on (may be empty)."""


def no_progress(share: float, text: Text) -> None:
    """For callers without interest in it."""
