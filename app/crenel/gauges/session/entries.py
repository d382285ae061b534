"""What is entered, touched and scanned in a performance test, as its journal has it."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, replace

from crenel.errors import OperationError
from crenel.gauges.plan.document import length_scan, plane_scan, sphere_scan
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
class _TestScan(ABC):
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


@dataclass(frozen=True, kw_only=True)
class SphereScan(_TestScan):
    """One scan of the sphere in an articulation."""

    position: int
    articulation: int
    points: int = 0
    """The points of the sphere within the gate."""
    patches: tuple[tuple[int, int], ...] = ()
    """Points and frames of each of the 25; empty until it is measured."""

    @property
    def name(self) -> str:
        return sphere_scan(self.position, self.articulation)

    @property
    def measured(self) -> bool:
        return bool(self.patches)


@dataclass(frozen=True)
class BarPass:
    """What a scan of a ball bar is to show; numbers from 1."""

    place: int
    repeat: int
    length: int = 0
    """The one whose two spheres are scanned by themselves; 0: the whole bar."""

    @property
    def name(self) -> str:
        """The name of the folder of its scan."""
        return length_scan(self.place, self.repeat, self.length)


@dataclass(frozen=True, kw_only=True)
class BarScan(_TestScan):
    """One scan of a ball bar in one of its places."""

    of: BarPass
    lengths_mm: tuple[tuple[int, float], ...] = ()
    """The lengths that it shows, by their numbers; as they are at the bar's temperature."""
    alone: tuple[int, ...] = ()
    """The lengths that need a scan of their two spheres by themselves."""

    @property
    def name(self) -> str:
        return self.of.name

    @property
    def measured(self) -> bool:
        return bool(self.lengths_mm or self.alone)


@dataclass(frozen=True, kw_only=True)
class PlateScan(_TestScan):
    """One scan of a plate in an orientation."""

    orientation: int
    """From 1."""
    points: int = 0
    """The points of the plate; 0 until it is measured."""
    width_mm: float = 0.0
    """The width of the part that it shows, in its narrower direction."""
    dispersion_um: float = 0.0
    """``E_Form.Pla.D95%`` by this scan."""
    turn_deg: float | None = None
    """The turn of the sensor since the scan of the other orientation; None before there is one."""

    @property
    def name(self) -> str:
        return plane_scan(self.orientation)

    @property
    def measured(self) -> bool:
        return self.points > 0


AnyScan = SphereScan | BarScan | PlateScan


def scan_from_row(payload: Payload, number: int, position: int) -> AnyScan:
    """The scan that a row begins: of a ball bar, a plate, or the sphere at its present position."""
    if "place" in payload:
        of = BarPass(payload["place"], payload["repeat"], payload["length"])
        return BarScan(number=number, at=payload["at"], of=of)
    if "orientation" in payload:
        return PlateScan(number=number, at=payload["at"], orientation=payload["orientation"])
    return SphereScan(
        number=number,
        at=payload["at"],
        position=position,
        articulation=payload["articulation"],
    )


def add_scan(scans: tuple[AnyScan, ...], scan: AnyScan) -> tuple[AnyScan, ...]:
    """With one more; a good one of the same is repeated by it."""
    before = (
        replace(one, aside="repeated") if one.good and one.name == scan.name else one
        for one in scans
    )
    return (*before, scan)


def values_from_row(payload: Payload) -> Mapping[str, object]:
    """What a row says that a scan shows, by the scan's fields."""
    if "patches" in payload:
        patches = tuple((int(points), int(frames)) for points, frames in payload["patches"])
        return {"points": payload["points"], "patches": patches}
    if "dispersion_um" in payload:
        return {name: payload[name] for name in ("points", "width_mm", "dispersion_um", "turn_deg")}
    return {
        "lengths_mm": tuple((int(number), float(mm)) for number, mm in payload["lengths"]),
        "alone": tuple(int(number) for number in payload["alone"]),
    }


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
