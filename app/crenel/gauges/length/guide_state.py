"""The state of a length test. Pure."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import ClassVar, Self

from crenel.gauges.length.guide_sequence import (
    BarPass,
    BarScan,
    LengthEnd,
    LengthSequence,
    next_pass,
    whole_place,
)
from crenel.gauges.plan.document import Kind
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.plan.maths_lengths import PLACES
from crenel.gauges.session.changes import Payload
from crenel.gauges.session.entries import SphereContact
from crenel.gauges.session.state import ArtefactShape, PerformanceState


@dataclass(frozen=True)
class LengthState(PerformanceState):
    """Where a length test stands."""

    test: ClassVar[Kind] = "lengths"
    shape: ClassVar[ArtefactShape] = "length"
    quantities: ClassVar[tuple[Quantity, ...]] = ("length-touch", "length-scan")
    between: ClassVar[tuple[str, ...]] = ("lengths",)
    first: ClassVar[tuple[str, ...]] = ("lengths",)
    touching: ClassVar[tuple[str, ...]] = ("lengths",)
    touched_and_scanned: ClassVar[tuple[str, ...]] = ("lengths",)
    by_touch: ClassVar[bool] = True
    scans_most: ClassVar[int] = 30 * PLACES
    limits_grow: ClassVar[bool] = True

    sequence: LengthSequence | None = None
    """The touches, from the choice of the standard on."""

    def plan_fields(self, by_scan: bool) -> Mapping[str, object]:
        return {"by_scan": by_scan}

    def list_quantities(self, by_scan: bool) -> tuple[Quantity, ...]:
        return tuple(one for one in self.quantities if by_scan or one != "length-scan")

    @property
    def end(self) -> LengthEnd | None:
        """The end of a length that is touched next; None without any, and while a scan is due."""
        if self.step != "lengths" or self.sequence is None or self.due is not None:
            return None
        return self.sequence.end_at(len(self.counted))

    @property
    def whole_place(self) -> int:
        if self.step != "lengths" or self.sequence is None:
            return 0
        return whole_place(self.sequence, len(self.counted))

    @property
    def due(self) -> BarPass | None:
        if self.sequence is None or not self.sequence.by_scan or not self.whole_place:
            return None
        return next_pass(self.whole_place, self.bar_scans)

    @property
    def place(self) -> int:
        """The place of the standard now, from 1; 0 once all is done."""
        if self.due is not None:
            return self.due.place
        return 0 if self.end is None else self.end.place

    @property
    def in_scan(self) -> bool:
        return self.due is not None

    @property
    def feature(self) -> str:
        return "" if self.end is None else self.end.feature

    @property
    def of_step(self) -> tuple[SphereContact, ...]:
        return self.counted

    @property
    def wanted(self) -> int:
        return 0 if self.sequence is None else self.sequence.touches

    @property
    def bar_scans(self) -> tuple[BarScan, ...]:
        """Scans of a ball bar, those set aside, too."""
        return tuple(scan for scan in self.scans if isinstance(scan, BarScan))

    def scan_of_row(self, payload: Payload, number: int) -> BarScan:
        of = BarPass(payload["place"], payload["repeat"], payload["length"])
        return BarScan(number=number, at=payload["at"], of=of)

    def scan_values(self, payload: Payload) -> Payload:
        return {
            "lengths_mm": tuple((int(number), float(mm)) for number, mm in payload["lengths"]),
            "alone": tuple(int(number) for number in payload["alone"]),
        }

    def count_confirmed_at_touch(self) -> int:
        """The first touch of a length confirms the one before."""
        if self.sequence is None:
            return self.confirmed
        whole = len(self.counted) // self.sequence.of_measurement
        return max(self.confirmed, whole * self.sequence.of_measurement)

    def count_confirmed_at_scan(self) -> int:
        """All before it."""
        return max(self.confirmed, len(self.counted))

    def begin(self, payload: Payload) -> Self:
        sequence = LengthSequence(
            payload["lengths"], payload["touches_each"], payload.get("by_scan", False)
        )
        return replace(self, sequence=sequence)
