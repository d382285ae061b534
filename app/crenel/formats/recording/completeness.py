"""Whether a scan is complete: the share of it that may be left out."""

from dataclasses import dataclass

from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message

MOST_LEFT_OUT = 0.1
"""A scan is incomplete if a larger share of it gave no points. A warning is then too little, as
the cloud does not show that a part of the surface is missing."""
UNFINISHED_BYTES = 2 << 20
"""A killed process leaves less than this behind what can be read of its recording."""


@dataclass(frozen=True, slots=True)
class MissingFrames:
    """Frames with a line that gave no points, because the arm's position was unknown or
    impossible; among all frames with a line."""

    frames: int = 0
    of: int = 0

    @property
    def share(self) -> float:
        """0 to 1."""
        return self.frames / self.of if self.of else 0.0

    @property
    def is_too_much(self) -> bool:
        """Whether the scan is incomplete."""
        return self.frames > MOST_LEFT_OUT * self.of

    @property
    def text(self) -> Text:
        """How much of the scan is missing, with the limit."""
        share, limit = beside_limit(100 * self.share, 100 * MOST_LEFT_OUT, "%", 1)
        return message(
            "scan-is-incomplete", count=self.frames, total=self.of, share=share, limit=limit
        )


NONE_MISSING = MissingFrames()


def is_mostly_unread(bytes_read: int, size: int) -> bool:
    """Whether so much of a damaged recording cannot be read that the scan is incomplete."""
    unread = size - bytes_read
    return unread > max(MOST_LEFT_OUT * size, UNFINISHED_BYTES)
