"""The state of a one-sphere test. Pure."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar, Self

from crenel.gauges.plan.document import (
    ARTICULATIONS,
    LOCATION_TOUCHES,
    PATTERN_TOUCHES,
    Kind,
    sphere_feature,
)
from crenel.gauges.plan.document_symbols import SPHERE_QUANTITIES, Quantity
from crenel.gauges.session.entries import SphereContact, SphereScan
from crenel.gauges.session.state import ArtefactShape, PerformanceState

WANTED: Mapping[str, int] = {
    "pattern": PATTERN_TOUCHES,
    "location": ARTICULATIONS * LOCATION_TOUCHES,
    "end": LOCATION_TOUCHES,
}
"""Touches of each step."""


@dataclass(frozen=True)
class SphereState(PerformanceState):
    """Where a one-sphere test stands."""

    test: ClassVar[Kind] = "sphere"
    shape: ClassVar[ArtefactShape] = "sphere"
    quantities: ClassVar[tuple[Quantity, ...]] = SPHERE_QUANTITIES
    between: ClassVar[tuple[str, ...]] = ("pattern", "location", "scan", "end")
    first: ClassVar[tuple[str, ...]] = ("pattern",)
    touching: ClassVar[tuple[str, ...]] = ("pattern", "location", "end")
    scanning: ClassVar[tuple[str, ...]] = ("scan",)

    def plan_fields(self, by_scan: bool) -> Mapping[str, object]:
        return {"positions": self.positions}

    @property
    def articulation(self) -> int:
        for number in range(1, ARTICULATIONS + 1):
            if self.step == "location":
                feature = sphere_feature(self.position, "location", number)
                done = len(self.of(feature)) >= LOCATION_TOUCHES
            else:
                done = self.scan_of(number) is not None
            if not done:
                return number
        return 0

    @property
    def feature(self) -> str:
        if self.step == "location" and self.articulation:
            return sphere_feature(self.position, "location", self.articulation)
        if self.step == "pattern":
            return sphere_feature(self.position, "pattern")
        return sphere_feature(self.position, "end") if self.step == "end" else ""

    @property
    def of_step(self) -> tuple[SphereContact, ...]:
        start = f"p{self.position}-{self.step}"
        return tuple(touch for touch in self.counted if touch.feature.startswith(start))

    @property
    def wanted(self) -> int:
        return WANTED[self.step]

    @property
    def here(self) -> tuple[SphereScan, ...]:
        """Scans of the present position, those set aside, too."""
        return tuple(
            scan
            for scan in self.scans
            if isinstance(scan, SphereScan) and scan.position == self.position
        )

    def scan_of(self, articulation: int) -> SphereScan | None:
        """The scan that counts of an articulation at the present position."""
        found = [one for one in self.here if one.articulation == articulation and one.good]
        return found[-1] if found else None

    def next_step(self) -> Self:
        """After the last step of a position, the first of the next."""
        if self.step == "end" and self.position < self.positions:
            return replace(self, step="pattern", position=self.position + 1)
        return super().next_step()
