"""One entry of the catalogue: what a record says of itself, without its data."""

import re
from dataclasses import dataclass
from datetime import datetime
from typing import Literal, get_args

from crenel.fleet.catalogue.quantities import title_of
from crenel.messages.message import Text

EntryKind = Literal[
    "calibration", "verification", "performance", "arm_check", "tip_check", "session", "scan"
]
ENTRY_KINDS: tuple[EntryKind, ...] = get_args(EntryKind)
EntryVerdict = Literal["", "pass", "fail", "uncertain", "good", "attention", "bad", "neutral"]
"""The verdict on the record, in its own words; empty where nothing is judged."""

WORD = re.compile(r"[^\W_]+")
LONGEST_WORD = 64


def split_words(text: str) -> frozenset[str]:
    """The words of a text in small letters, without any other characters.

    Example:
        >>> sorted(split_words("Housing_4711-B, 4711"))
        ['4711', 'b', 'housing']
    """
    return frozenset(word[:LONGEST_WORD] for word in WORD.findall(text.casefold()))


@dataclass(frozen=True, slots=True)
class EntryFile:
    """A file of the record."""

    path: str
    bytes: int
    sha256: str


@dataclass(frozen=True, slots=True)
class EntryFigure:
    """One result: a symbol with its value."""

    symbol: str
    """As the record writes it, for example ``L_Dia.2x1:Ps``."""
    quantity: str
    """What it is, whatever a standard calls it; the same in every record."""
    value: float
    unit: str
    expanded_uncertainty: float | None = None
    """k = 2."""
    limit: float | None = None
    """The limit of the absolute value."""
    decision: str = ""

    @property
    def title(self) -> Text:
        """What it is, in words."""
        return title_of(self.quantity)


@dataclass(frozen=True, slots=True)
class CatalogueEntry:
    """One record of one station."""

    station: str
    kind: EntryKind
    id: str
    """The name of its folder on the station."""
    content: str
    """Names the content of its folder, as the archive's manifest does."""
    at: datetime
    """When it was made, with its time zone."""
    label: str = ""
    """Its name: of a scan, what the operator called the part."""
    operator: str = ""
    simulated: bool = False
    arm_serial: str = ""
    sensor_serial: str = ""
    object_serial: str = ""
    """The serial number of the calibration object, gauge or artefact."""
    calibration_id: str = ""
    """The calibration in use: the name of its session."""
    calibration_sha256: str = ""
    arm_sha256: str = ""
    software: str = ""
    """Name and version of the program that wrote it."""
    verdict: EntryVerdict = ""
    temperature_c: float | None = None
    points: int | None = None
    """The points of a scan."""
    current_at: datetime | None = None
    """The last time that this was known to be the content; None: unknown."""
    archived_at: datetime | None = None
    """When the archive had it whole; None if only the station has it."""
    place: str = ""
    """The archive or data folder that it was collected from."""
    files: tuple[EntryFile, ...] = ()
    figures: tuple[EntryFigure, ...] = ()

    @property
    def words(self) -> frozenset[str]:
        """By which it is found."""
        texts = (self.id, self.label, self.operator)
        serials = (self.arm_serial, self.sensor_serial, self.object_serial)
        return split_words(" ".join((*texts, *serials)))

    @property
    def size_bytes(self) -> int:
        """All files together."""
        return sum(file.bytes for file in self.files)
