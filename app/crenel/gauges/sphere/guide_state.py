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
    sphere_scan,
)
from crenel.gauges.plan.document_symbols import SPHERE_QUANTITIES, Quantity
from crenel.gauges.session.changes import Payload
from crenel.gauges.session.entries import SphereContact, TestScan
from crenel.gauges.session.state import ArtefactShape, PerformanceState

WANTED: Mapping[str, int] = {
    "pattern": PATTERN_TOUCHES,
    "location": ARTICULATIONS * LOCATION_TOUCHES,
    "end": LOCATION_TOUCHES,
}
"""Touches of each step."""


@dataclass(frozen=True, kw_only=True)
class SphereScan(TestScan):
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

    def scan_of_row(self, payload: Payload, number: int) -> SphereScan:
        return SphereScan(
            number=number,
            at=payload["at"],
            position=self.position,
            articulation=payload["articulation"],
        )

    def scan_values(self, payload: Payload) -> Payload:
        patches = tuple((int(points), int(frames)) for points, frames in payload["patches"])
        return {"points": payload["points"], "patches": patches}

    def next_step(self) -> Self:
        """After the last step of a position, the first of the next."""
        if self.step == "end" and self.position < self.positions:
            return replace(self, step="pattern", position=self.position + 1)
        return super().next_step()
