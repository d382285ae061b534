"""What the browser is shown of the datasheets."""

from collections.abc import Mapping
from dataclasses import dataclass

from crenel.findings import Quality
from crenel.messages.message import Text
from crenel.operations.datasheets.documents import DatasheetForm, DatasheetKind, FieldProblem
from crenel.operations.datasheets.ranges import FieldRange


@dataclass(frozen=True)
class LastUse:
    """For what a thing was last used: an accepted calibration or verification, or a test."""

    at: str
    """ISO 8601."""
    quality: Quality
    text: Text
    """The result in one sentence."""


@dataclass(frozen=True)
class DatasheetRow:
    """One file among the datasheets."""

    kind: DatasheetKind
    file: str
    """Its name in the folder of its kind."""
    version: str
    """The version of its content; another one after any change."""
    retired: bool
    form: DatasheetForm | None
    """None of a file that cannot be read."""
    problem: Text
    """Why it cannot be read; empty if it can."""
    name: str
    serial_number: str
    certificate: str
    issued_on: str
    """The date of the certificate, YYYY-MM-DD; empty where the file does not say."""
    valid_until: str
    since: str
    """The file's time, ISO 8601."""
    last_use: LastUse | None
    """The last use of the thing with its serial number, or of the gauge with its name; None if no
    record names it."""
    in_use: tuple[str, ...]
    """Names of the calibrations in use that rest on it."""
    connected: bool
    """The connected device has its serial number."""
    note: Text
    """What is unlikely of one in use, and what to do; empty if nothing is."""


@dataclass(frozen=True)
class ConnectedArmView:
    """The connected arm, for whose datasheet a form can be filled in."""

    name: str
    serial_number: str
    joint_count: int


@dataclass(frozen=True)
class JointsView:
    """How the joints of the connected arm stand."""

    joints_deg: tuple[float, ...]
    """Empty without recent readings, and of an arm that reports poses."""


@dataclass(frozen=True)
class DatasheetsView:
    """The content of the Datasheets page."""

    rows: tuple[DatasheetRow, ...]
    arm: ConnectedArmView | None
    ranges: Mapping[str, Mapping[str, FieldRange]]
    """The ranges of the numbers in each form, by their fields: ``lengths.*.length_mm``."""


@dataclass(frozen=True)
class DatasheetCheck:
    """What a document is worth that is not kept."""

    form: DatasheetForm | None
    problems: tuple[FieldProblem, ...]
    """None of a document that can be kept."""
    note: Text
    """What is unlikely, though it can be kept; empty if nothing is."""
