"""What is entered, touched and scanned in a performance test, as its journal has it."""

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace

from crenel.errors import OperationError
from crenel.gauges.session.changes import Payload
from crenel.messages.limits import beside_limit
from crenel.messages.message import message


@dataclass(frozen=True)
class DatasheetLimit:
    """A maximum permissible error: ``A``, or ``A + L/K`` up to ``B``; in µm, ``K`` without unit."""

    a_um: float
    k: float | None = None
    b_um: float | None = None


@dataclass(frozen=True)
class Temperatures:
    """The temperatures of artefact and arm; None: not measured."""

    artefact_c: float | None = None
    arm_c: float | None = None


NOT_MEASURED = Temperatures()


@dataclass(frozen=True)
class SphereContact:
    """One touch of the sphere or the length standard."""

    index: int
    feature: str
    """Its part of the test, as in the table of touches."""
    place: int
    """Which of the part's places it was at, from 0; on the end of a length, which touch."""
    reading: tuple[float, ...]
    """The arm's."""
    at: str
    """When it was taken."""
    voided: bool = False


@dataclass(frozen=True, kw_only=True)
class TestScan(ABC):
    """What all scans of a test have."""

    number: int
    """The number of the scan among all scans of the test."""
    at: str
    """When it was begun."""
    ended: bool = False
    refused: Payload | None = None
    """Why it is of no use."""
    aside: str = ""
    """Why it does not count: dropped while it was scanned, or repeated; empty if it counts."""

    @property
    @abstractmethod
    def name(self) -> str:
        """The name of its folder."""

    @property
    @abstractmethod
    def measured(self) -> bool:
        """Whether it was found to be of use."""

    @property
    def waiting(self) -> bool:
        """Whether it is still to be measured."""
        return self.ended and not self.judged

    @property
    def judged(self) -> bool:
        """Whether it is known if it counts."""
        return self.measured or self.refused is not None or bool(self.aside)

    @property
    def good(self) -> bool:
        """Whether it counts."""
        return self.measured and not self.aside


def add_scan(scans: tuple[TestScan, ...], scan: TestScan) -> tuple[TestScan, ...]:
    """With one more; a good one of the same is repeated by it."""
    before = (
        replace(one, aside="repeated") if one.good and one.name == scan.name else one
        for one in scans
    )
    return (*before, scan)


def same_place_error() -> OperationError:
    """The sphere was touched near there already."""
    return OperationError(
        "same-place",
        message("performance-sphere-touch-not-taken"),
        remedy=message("performance-touch-sphere-elsewhere"),
    )


def another_length_error(found_mm: float, wanted_mm: float) -> OperationError:
    """The touch would make another length than that of the standard."""
    found, wanted = beside_limit(found_mm, wanted_mm, "mm")
    return OperationError(
        "another-length",
        message("performance-another-length-not-taken", found=found, wanted=wanted),
        remedy=message("performance-touch-ends-of-length"),
    )
