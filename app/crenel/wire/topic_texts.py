"""Topics as the texts that browsers receive, each encoded once for all tabs."""

import logging

from crenel.wire.json_response import encode_json

log = logging.getLogger(__name__)


class TopicTexts:
    """The text of each topic's newest value. It is used on the event loop only."""

    def __init__(self) -> None:
        self._newest: dict[str, tuple[object, str | None]] = {}
        self._unsent: set[str] = set()

    def of(self, name: str, value: object) -> str | None:
        """The message with a value; None if it cannot be encoded, which is logged once a topic."""
        known = self._newest.get(name)
        if known is None or known[0] is not value:
            known = self._newest[name] = (value, self._encode(name, value))
        return known[1]

    def _encode(self, name: str, value: object) -> str | None:
        try:
            return encode_json({"type": "topic", "name": name, "value": value}).decode()
        except (ValueError, TypeError, RecursionError):
            if name not in self._unsent:  # a topic may occur many times per second
                self._unsent.add(name)
                log.exception("the topic %s cannot be sent", name)
            return None
