"""Whether a length standard rocks: its lengths then differ between repeats more than touches do, or
the touches of its spheres scatter far more than elsewhere."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import inf, isfinite

import numpy as np

from crenel.gauges.plan.maths_lengths import MeasuredLength
from crenel.metrology.fitting.reference_sphere import sphere_centre
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

FAR_MORE = 6.0
"""So many times what the touches explain. Of steady standards with a single length, one in two
thousand has such a place by chance; with two lengths or more, none of two thousand."""
LEAST_OTHERS = 4
"""Places that the scatter of single touches is taken from."""
STEADIEST_TIMES, LEAST_LENGTHS = 2.0, 3
"""Touches are taken to scatter by no more than so many times what they do in the steadiest place
but one, with a standard of so many lengths. Of steady standards, one in two thousand has a place
with 4.4 times that scatter by chance, and twelve times are found to rock: the rest is left for how
differently an arm scatters near and far."""
LEAST_UM = 10.0
"""A standard that moves by less does not show in the figures of an arm."""


@dataclass(frozen=True)
class RockingPlace:
    """A place in which the standard does not stand still."""

    place: int
    scatter_um: float
    """Standard deviation of a length between repeats, or of touches about the spheres."""
    expected_um: float
    """What the touches explain, or other places show."""


def repeat_scatter_um(values: Sequence[MeasuredLength]) -> dict[int, float]:
    """Standard deviation of a length between the repeats, pooled for each place that has some."""
    errors: dict[tuple[int, float], list[float]] = {}
    for one in values:
        errors.setdefault((one.place, one.nominal.length_mm), []).append(one.error_um)
    squares: dict[int, float] = {}
    freedom: dict[int, int] = {}
    for (place, _), found in errors.items():
        squares[place] = squares.get(place, 0.0) + len(found) * float(np.var(found))
        freedom[place] = freedom.get(place, 0) + len(found) - 1
    return {place: (squares[place] / n) ** 0.5 for place, n in freedom.items() if n > 0}


def sphere_touch_scatter_um(ends_mm: Mapping[str, Floats], reach_mm: float) -> float | None:
    """Standard deviation of a length that follows from the touches' distances from the spheres.

    Args:
        ends_mm: tip centres (N, 3) on each end of a bar; groups of four or more count.
        reach_mm: radius of sphere and tip together.

    Returns:
        None without such a group.
    """
    found_um = scatter_about_spheres_um(ends_mm.values(), reach_mm)
    # a centre by four touches is about as good as one of them; a length has two
    return None if found_um is None else float(np.sqrt(2)) * found_um


def scatter_about_spheres_um(ends_mm: Iterable[Floats], reach_mm: float) -> float | None:
    """Standard deviation of touches about the spheres of a certified diameter.

    Args:
        ends_mm: tip centres (N, 3) on each sphere; groups of four or more count.
        reach_mm: radius of sphere and tip together.

    Returns:
        None without such a group.
    """
    squares, freedom = 0.0, 0
    for tips in ends_mm:
        if len(tips) < 4:
            continue
        off = np.linalg.norm(tips - sphere_centre(tips, 2 * reach_mm), axis=1) - reach_mm
        squares, freedom = squares + float(off @ off), freedom + len(tips) - 3
    return 1e3 * float(np.sqrt(squares / freedom)) if freedom else None


def find_rocking_places(
    values: Sequence[MeasuredLength], touches_um: float | None = None
) -> list[RockingPlace]:
    """The places in which the repeats scatter far more than the touches explain.

    Where each end has one touch, nothing but the places tells what touches scatter: a standard that
    rocks in all of them but one looks like one that stands still, measured by a worse arm.

    Args:
        touches_um: of a length, by the touches themselves; None where each end has one touch: the
            other places then show what touches scatter, or the steadiest where the standard rocks
            in many.
    """
    found = repeat_scatter_um(values)
    several = len({one.nominal.length_mm for one in values}) >= LEAST_LENGTHS
    rocking = []
    for place, scatter_um in found.items():
        expected_um = touches_um
        if expected_um is None:
            others = [value for other, value in found.items() if other != place]
            if len(others) < LEAST_OTHERS:
                continue
            expected_um = median(others)
            if several:
                expected_um = min(expected_um, STEADIEST_TIMES * sorted(others)[1])
        if scatter_um > max(FAR_MORE * expected_um, LEAST_UM):
            rocking.append(RockingPlace(place, scatter_um, expected_um))
    return rocking


def find_loose_places(
    scatter_um: Mapping[int, float], steady_um: float = inf
) -> list[RockingPlace]:
    """The places in which touches scatter far more about the spheres than they do elsewhere: the
    standard gives way while it is touched, which its repeats alone do not show.

    Args:
        scatter_um: of the touches in each place.
        steady_um: of touches on what surely stands still; infinite if there are none.
    """
    loose = []
    for place, found_um in scatter_um.items():
        others = [value for other, value in scatter_um.items() if other != place]
        expected_um = min(median(others) if len(others) >= LEAST_OTHERS else inf, steady_um)
        if isfinite(expected_um) and found_um > max(FAR_MORE * expected_um, LEAST_UM):
            loose.append(RockingPlace(place, found_um, expected_um))
    return loose
