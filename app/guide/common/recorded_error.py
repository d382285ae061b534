"""An error as a journal row has it: its code, and its texts as data. Pure."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from app.errors import OperationError, reason_sentence, sentence
from app.findings import Finding, Quality
from app.messages.message import Text, text_from_json, text_to_json


@dataclass(frozen=True)
class RecordedError:
    """Why something was declined."""

    code: str
    what: Text
    why: Text
    remedy: Text

    @property
    def reason(self) -> Text:
        """What happened and why, as a sentence."""
        return reason_sentence(self.what, self.why)

    def finding(self, quality: Quality, remedy: Text = "") -> Finding:
        """The error as it is shown; ``remedy`` is used where it has none of its own."""
        return Finding(quality, self.reason, sentence(self.remedy or remedy))


def error_payload(error: OperationError) -> dict[str, object]:
    """The fields of a row."""
    return {
        "code": error.code,
        "what": text_to_json(error.what),
        "why": text_to_json(error.why),
        "remedy": text_to_json(error.remedy),
    }


def error_from_payload(payload: Mapping[str, Any]) -> RecordedError:
    """From the fields of a row; rows of earlier versions have English sentences."""
    return RecordedError(
        str(payload["code"]),
        text_from_json(payload["what"]),
        text_from_json(payload["why"]),
        text_from_json(payload["remedy"]),
    )
