"""Which scans of a ball bar its present place takes, and which one is next. Pure."""

from collections.abc import Iterator, Sequence

from crenel.gauges.length.guide_sequence import LengthSequence
from crenel.gauges.plan.maths_lengths import REPEATS
from crenel.gauges.session.entries import BarPass, BarScan


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
