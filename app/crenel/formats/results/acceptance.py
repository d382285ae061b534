"""``acceptance.json``: who put a calibration to use, where and when, and by which limits.

The calibration itself says what was found; this stands beside it in the session's folder,
so that its report can be made from the folder alone.
"""

from pathlib import Path
from typing import ClassVar

from crenel.formats.json_document import Document, DocumentPart, NotNegative, Number
from crenel.formats.results.decision_rule import FORMER_POINT_RULE, RulePart

ACCEPTANCE = "acceptance.json"


class ComparisonPart(DocumentPart):
    """How far points of the measuring volume moved since the calibration that was in use."""

    name: str
    rms_um: NotNegative
    max_um: NotNegative


class Acceptance(Document):
    FORMAT: ClassVar[str] = "crenel/acceptance"

    name: str
    """The name of the calibration, as the station lists it."""
    accepted_at: str
    operator: str = ""
    station: str = ""
    simulated: bool = False
    calibration_sha256: str
    good_um: NotNegative | None = None
    usable_um: NotNegative | None = None
    """What the verdict went by: the standard uncertainty of a point, k = 1."""
    rule: RulePart = FORMER_POINT_RULE
    """For features that are given by scanned points."""
    temperature_c: Number | None = None
    compared: ComparisonPart | None = None


def read_acceptance(folder: Path) -> Acceptance | None:
    """Reads the acceptance in a session's folder; None where its calibration was not put to use on
    a station.

    Raises:
        OperationError: the file is damaged.
    """
    path = folder / ACCEPTANCE
    return Acceptance.read(path) if path.exists() else None
