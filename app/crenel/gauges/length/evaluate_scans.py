"""Lengths of a ball bar by scan: the distance of the centres of two scanned spheres."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import inf

import numpy as np

from crenel.gauges.judgement.evaluate_measured_data import MeasuredData, ScanCloud
from crenel.gauges.length.maths_bar_spheres import (
    LEAST_FRAMES,
    LEAST_POINTS,
    find_spheres,
    measure_sphere,
)
from crenel.gauges.plan.document import length_scan
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_gate import SphereGate
from crenel.gauges.plan.maths_lengths import PLACES, REPEATS, MeasuredLength, length_of_bar_mm
from crenel.messages.message import Text, message, quantity
from crenel.metrology.transforms import Floats

OTHER_LENGTH_MM = 2.0
"""Two spheres whose distance differs by more are not those of a length."""


@dataclass(frozen=True)
class LengthInScan:
    """A length of the standard in one scan."""

    number: int
    """The number of the length among the standard's, from 1."""
    measured_mm: float | None
    problem: Text = ""
    """Why the scan does not show it."""
    is_ambiguous: bool = False
    """Whether more than one pair of spheres is so far apart: it needs a scan of its own."""
    scatter_mm: float = 0.0
    """Rms distance of the points from the calibrated spheres."""


@dataclass(frozen=True)
class ScannedLengths:
    """The lengths by scan, and why some are missing."""

    values: tuple[MeasuredLength, ...]
    scans: tuple[str, ...]
    """From which they were computed."""
    problems: tuple[Text, ...]
    scatter_um: float
    """Rms distance of the points from the calibrated spheres; infinite without any."""


def has_length_scans(data: MeasuredData) -> bool:
    """Whether a bar was scanned."""
    return any(data.has_scan(name) for name, _, _, _ in _scans(data.plan.length))


def measure_scanned_lengths(data: MeasuredData) -> ScannedLengths:
    """Every length of the scans of a test: one scan of the whole bar in each place and repeat, or
    one for each length.

    Raises:
        OperationError: a scan cannot be rebuilt, or the folder has no calibration.
    """
    standard = data.plan.length
    assert standard is not None, "a plan of this kind has lengths"
    if standard.sphere_diameter_mm is None:
        return ScannedLengths((), (), (message("only-ball-bars-are-scanned"),), inf)
    values: list[MeasuredLength] = []
    names: list[str] = []
    problems: list[Text] = []
    scatters_mm: list[float] = []
    for name, place, repeat, numbers in _scans(standard):
        if not data.has_scan(name):
            continue
        names.append(name)
        if len(numbers) > 1:  # a scan of one length stands for it
            numbers = [n for n in numbers if not data.has_scan(length_scan(place, repeat, n))]
        for one in lengths_in_scan(standard, data.scan(name), data.plan.gate.gate, numbers):
            if one.measured_mm is None:
                problems.append(message("titled-text", title=name, text=one.problem))
                continue
            nominal = standard.nominal(one.number)
            scatters_mm.append(one.scatter_mm)
            values.append(
                MeasuredLength(place, repeat, nominal, one.measured_mm, data.artefact, "scan")
            )
    scatter_um = 1e3 * float(np.sqrt(np.mean(np.square(scatters_mm)))) if scatters_mm else inf
    return ScannedLengths(tuple(values), tuple(names), tuple(problems), scatter_um)


def lengths_in_scan(
    standard: LengthStandardFile, cloud: ScanCloud, gate: SphereGate, numbers: Sequence[int]
) -> list[LengthInScan]:
    """The lengths that one scan of a ball bar is to show, each with its value or why it has none.

    Args:
        numbers: of the lengths, from 1.
    """
    if standard.sphere_diameter_mm is None:
        text = message("only-ball-bars-are-scanned")
        return [LengthInScan(number, None, text) for number in numbers]
    centres = find_spheres(cloud.points_mm, cloud.views, standard.sphere_diameter_mm)
    return [_measure_length(standard, cloud, gate, centres, number) for number in numbers]


def _scans(
    standard: LengthStandardFile | None,
) -> Iterator[tuple[str, int, int, Sequence[int]]]:
    """Names of scans with their place, repeat and the numbers of the lengths that they show."""
    count = 0 if standard is None else len(standard.lengths)
    for place in range(1, PLACES + 1):
        for repeat in range(1, REPEATS + 1):
            yield length_scan(place, repeat), place, repeat, range(1, count + 1)
            for number in range(1, count + 1):
                one = range(number, number + 1)
                yield length_scan(place, repeat, number), place, repeat, one


def _measure_length(
    standard: LengthStandardFile,
    cloud: ScanCloud,
    gate: SphereGate,
    centres_mm: Floats,
    number: int,
) -> LengthInScan:
    nominal_mm = standard.lengths[number - 1].length_mm
    size = quantity(nominal_mm, "mm")
    pairs = [
        (a, b)
        for a, b in combinations(centres_mm, 2)
        if abs(length_of_bar_mm(a, b) - nominal_mm) <= OTHER_LENGTH_MM
    ]
    if not pairs:
        text = message("scan-without-length", length=size, count=len(centres_mm))
        return LengthInScan(number, None, text)
    if len(pairs) > 1:
        text = message("scan-has-length-twice", length=size)
        return LengthInScan(number, None, text, is_ambiguous=True)
    (first, second) = pairs[0]
    diameter_mm = standard.sphere_diameter_mm or 0.0
    along = np.asarray(second - first) / np.linalg.norm(second - first)
    ends = [
        measure_sphere(
            cloud.points_mm,
            cloud.views,
            cloud.frame,
            diameter_mm,
            start,
            along,
            gate,
        )
        for start in (first, second)
    ]
    if not all(one.is_covered for one in ends):
        text = message(
            "scan-shows-little-of-sphere", length=size, points=LEAST_POINTS, frames=LEAST_FRAMES
        )
        return LengthInScan(number, None, text)
    length_mm = length_of_bar_mm(ends[0].centre_mm, ends[1].centre_mm)
    scatter_mm = max(one.scatter_mm for one in ends)
    return LengthInScan(number, length_mm, scatter_mm=scatter_mm)
