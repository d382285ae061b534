"""The order in which the ends of lengths are touched and a bar is scanned. Pure."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from crenel.gauges.plan.document import length_feature, length_scan
from crenel.gauges.plan.maths_lengths import PLACES, REPEATS
from crenel.gauges.session.entries import TestScan


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
class BarScan(TestScan):
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


@dataclass(frozen=True)
class LengthEnd:
    """One end of one measurement of a length; numbers from 1, the end 0 or 1."""

    place: int
    repeat: int
    length: int
    end: int

    @property
    def feature(self) -> str:
        """The name of its touches."""
        return length_feature(self.place, self.repeat, self.length, self.end)


@dataclass(frozen=True)
class LengthSequence:
    """In each place all lengths one after another, three times; of each length both ends."""

    lengths: int
    """The number of lengths of the standard."""
    touches_each: int
    """On each end."""
    by_scan: bool = False
    """Whether each place takes scans of the whole bar after its touches."""

    @property
    def scans(self) -> int:
        """The number of scans of the whole bar in the whole test."""
        return PLACES * REPEATS if self.by_scan else 0

    @property
    def measurements(self) -> int:
        """The number of measurements of lengths in the whole test."""
        return PLACES * REPEATS * self.lengths

    @property
    def touches(self) -> int:
        """In the whole test."""
        return self.measurements * self.of_measurement

    @property
    def of_measurement(self) -> int:
        """Touches on both ends of a length."""
        return 2 * self.touches_each

    @property
    def of_place(self) -> int:
        """Touches in one place."""
        return REPEATS * self.lengths * self.of_measurement

    def end_at(self, touch: int) -> LengthEnd | None:
        """The end that a touch (from 0) belongs to; None once all are done.

        Example:
            >>> LengthSequence(5, 1).end_at(11)
            LengthEnd(place=1, repeat=2, length=1, end=1)
        """
        if not 0 <= touch < self.touches:
            return None
        measurement, within = divmod(touch, self.of_measurement)
        row, length = divmod(measurement, self.lengths)
        place, repeat = divmod(row, REPEATS)
        return LengthEnd(place + 1, repeat + 1, length + 1, within // self.touches_each)


def whole_place(sequence: LengthSequence, touches: int) -> int:
    """The place that was touched last, from 1, if it has all its touches; else 0."""
    return 0 if touches % sequence.of_place else touches // sequence.of_place


def passes_of(place: int, scans: Sequence[BarScan]) -> Iterator[BarPass]:
    """The scans of a place in their order: the whole bar in each repeat, and then the spheres of
    each length that it does not tell from another one."""
    for repeat in range(1, REPEATS + 1):
        whole = BarPass(place, repeat)
        yield whole
        found = last_scan(whole, scans)
        if found is not None and found.good:
            for number in found.alone:
                yield BarPass(place, repeat, number)


def next_pass(place: int, scans: Sequence[BarScan]) -> BarPass | None:
    """The first scan of a place that is missing; None once it has all."""
    for one in passes_of(place, scans):
        found = last_scan(one, scans)
        if found is None or not found.good:
            return one
    return None


def last_scan(of: BarPass, scans: Sequence[BarScan]) -> BarScan | None:
    """The newest scan of a pass that was not set aside; None without any."""
    found = [scan for scan in scans if scan.of == of and not scan.aside]
    return found[-1] if found else None
