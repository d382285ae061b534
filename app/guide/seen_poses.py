"""What the pictures of a session's poses show: looked at once, and remembered."""

from collections.abc import Mapping

from app.files.calibrate import AnySeen
from app.metrology.refusal import Refusal


class SeenPoses:
    """Of one session at a time; what is not remembered is looked at again from its files."""

    def __init__(self) -> None:
        self._session_id = ""
        self._seen: dict[int, AnySeen | Refusal] = {}

    def keep(self, session_id: str, number: int, seen: AnySeen | Refusal) -> None:
        """Remembers what a pose's pictures showed."""
        if session_id != self._session_id:
            self._session_id, self._seen = session_id, {}
        self._seen[number] = seen

    def of(self, session_id: str) -> Mapping[int, AnySeen | Refusal]:
        """What is known of a session's poses, by number."""
        return dict(self._seen) if session_id == self._session_id else {}
