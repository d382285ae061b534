"""The state of a test on a plate. Pure."""

from dataclasses import dataclass
from typing import ClassVar

from crenel.gauges.plan.document import ORIENTATIONS, Kind
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.session.entries import PlateScan, SphereContact
from crenel.gauges.session.state import ArtefactShape, PerformanceState


@dataclass(frozen=True)
class PlaneState(PerformanceState):
    """Where a test on a plate stands; nothing is touched."""

    test: ClassVar[Kind] = "plane"
    shape: ClassVar[ArtefactShape] = "plane"
    quantities: ClassVar[tuple[Quantity, ...]] = ("plane-scan",)
    between: ClassVar[tuple[str, ...]] = ("plate",)
    first: ClassVar[tuple[str, ...]] = ("plate",)
    scanning: ClassVar[tuple[str, ...]] = ("plate",)

    @property
    def feature(self) -> str:
        return ""

    @property
    def of_step(self) -> tuple[SphereContact, ...]:
        return ()

    @property
    def wanted(self) -> int:
        return 0

    @property
    def plate_scans(self) -> tuple[PlateScan, ...]:
        """Scans of the plate, those set aside, too."""
        return tuple(scan for scan in self.scans if isinstance(scan, PlateScan))

    @property
    def orientation(self) -> int:
        done = {scan.orientation for scan in self.plate_scans if scan.good}
        left = (number for number in range(1, ORIENTATIONS + 1) if number not in done)
        return next(left, 0)
