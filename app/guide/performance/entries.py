"""What is entered, touched and scanned in a performance test, as its journal has it."""

from dataclasses import dataclass

from app.formats.performance.plan import sphere_scan
from app.guide.gauge.state import Payload


@dataclass(frozen=True)
class DatasheetLimit:
    """A maximum permissible error: ``A``, or ``A + L/K`` up to ``B``; in µm, ``K`` without unit."""

    a_um: float
    k: float | None = None
    b_um: float | None = None


@dataclass(frozen=True)
class Temperatures:
    """Of artefact and arm; None: not measured."""

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
    voided: bool = False


@dataclass(frozen=True)
class SphereScan:
    """One scan of the sphere in an articulation."""

    number: int
    """Of all scans of the test."""
    position: int
    articulation: int
    at: str
    """When it was begun."""
    ended: bool = False
    points: int = 0
    """Of the sphere, within the gate."""
    patches: tuple[tuple[int, int], ...] = ()
    """Points and frames of each of the 25; empty until it is measured."""
    refused: Payload | None = None
    """Why it is of no use."""
    aside: str = ""
    """Why it does not count: dropped while it was scanned, or repeated; empty if it counts."""

    @property
    def name(self) -> str:
        """Of its folder."""
        return sphere_scan(self.position, self.articulation)

    @property
    def waiting(self) -> bool:
        """Whether it is still to be measured."""
        return self.ended and not self.patches and self.refused is None and not self.aside

    @property
    def good(self) -> bool:
        """Whether it counts."""
        return bool(self.patches) and not self.aside
