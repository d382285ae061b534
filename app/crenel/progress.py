"""How long jobs report their progress."""

from collections.abc import Callable

from crenel.messages.message import Text

Progress = Callable[[float, Text], None]
"""Called with the share done, 0 to 1, and the current step (may be empty)."""


def no_progress(share: float, text: Text) -> None:
    """For callers that do not need the progress."""
