"""Artefacts that rock or give way while they are touched: then no symbol is stated, and it is said
why."""

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from math import inf, sqrt
from typing import Literal

from crenel.errors import OperationError
from crenel.gauges.judgement.maths_length_scatter import (
    LEAST_UM,
    RockingPlace,
    find_loose_places,
    scatter_about_spheres_um,
)
from crenel.messages.message import Text, message, quantity
from crenel.metrology.fitting.reference_sphere import least_squares_sphere
from crenel.metrology.probing.seat_articulation import seat_articulation
from crenel.metrology.transforms import Floats

STEADY_TIMES = 2.0
"""Touches of a sphere may scatter by so many times what they do along an axis in the worst seat:
there, the tip does not slide."""
TIMES_OF_SCANS = {"pattern": 4.0, "location": 6.0, "end": 4.0}
"""Touches of a sphere may scatter by so many times what its scanned points do: the same arm takes
both, so what it errs by shows in both. Of 38 simulated arms with wrong links, the touches scattered
by at most 1.4, 3.9 and 1.7 times as much."""
DISPERSION_SDS = 3.92
"""Width of the shell that holds 95 % of the points, in their standard deviations."""
SEAT_TIMES = 6.0
"""A seat may scatter by so many times what the other two do: an arm errs more in the far one than
in the middle, but by less than that."""


def loose_bar_problems(
    spheres_mm: Mapping[int, Sequence[Floats]],
    reach_mm: float,
    test: Literal["lengths", "contact"],
    steady_um: float = inf,
) -> list[Text]:
    """Each place in which a ball bar gives way.

    Args:
        spheres_mm: tip centres (N, 3) on each sphere, by the place.
        reach_mm: radius of sphere and tip together.
        steady_um: of touches on what surely stands still.
    """
    found = {place: scatter_about_spheres_um(ends, reach_mm) for place, ends in spheres_mm.items()}
    known = {place: scatter for place, scatter in found.items() if scatter is not None}
    return [_say(one, test) for one in find_loose_places(known, steady_um)]


def loose_sphere_problems(spheres_mm: Sequence[Floats], steady_um: float) -> list[Text]:
    """Each measurement of a master sphere in which it gives way.

    Args:
        spheres_mm: tip centres (N, 3) of each, N > 4.
        steady_um: of touches on what surely stands still; infinite if there are none.
    """
    scatter_um: dict[int, float] = {}
    for number, tips in enumerate(spheres_mm, 1):
        with suppress(OperationError):  # all touches in one place
            scatter_um[number] = 1e3 * least_squares_sphere(tips).scatter_mm
    return [_say(one, "sphere") for one in find_loose_places(scatter_um, steady_um)]


def loose_test_sphere_problems(
    touches_mm: Mapping[str, Sequence[Floats]],
    reach_mm: float,
    dispersion_um: float,
    position: int,
) -> list[Text]:
    """Each part of the one-sphere test in which the touches scatter far more about the sphere than
    the points of the scans do: something gives way while it is touched.

    Args:
        touches_mm: groups of tip centres (N, 3) by the part of the test, a key of
            ``TIMES_OF_SCANS``.
        reach_mm: radius of sphere and tip together, as touched.
        dispersion_um: of the scanned points.
        position: of the sphere.
    """
    steady_um = dispersion_um / DISPERSION_SDS
    problems: list[Text] = []
    for part, groups in touches_mm.items():
        scatter_um = scatter_about_spheres_um(groups, reach_mm)
        if scatter_um is None or scatter_um <= max(TIMES_OF_SCANS[part] * steady_um, LEAST_UM):
            continue
        problems.append(
            message(
                "sphere-gives-way",
                position=position,
                part=part,
                scatter=quantity(scatter_um, "µm"),
                expected=quantity(steady_um, "µm", 1),
            )
        )
    return problems


def loose_seat_problems(seats_mm: Sequence[Floats]) -> list[Text]:
    """Each seat that moves while the tip is in it: it scatters far more than both others.

    Args:
        seats_mm: tip centres (N, 3) in each, N > 1.
    """
    scatter_um = [seat_articulation(tips).two_s_um / 2 for tips in seats_mm]
    problems: list[Text] = []
    for number, found_um in enumerate(scatter_um, 1):
        others = [*scatter_um[: number - 1], *scatter_um[number:]]
        if found_um <= max(SEAT_TIMES * max(others), LEAST_UM):
            continue
        problems.append(
            message(
                "seat-gives-way",
                seat=number,
                scatter=quantity(found_um, "µm"),
                expected=quantity(max(others), "µm", 1),
            )
        )
    return problems


def steady_scatter_um(seats_mm: Iterable[Floats]) -> float:
    """What touches on something that stands still scatter at most, by the tip (N, 3) in seats;
    infinite without seats."""
    two_s = [seat_articulation(tips).two_s_um for tips in seats_mm if len(tips) > 1]
    return STEADY_TIMES * max(two_s) / 2 / sqrt(3) if two_s else inf


def _say(place: RockingPlace, test: Literal["lengths", "contact", "sphere"]) -> Text:
    return message(
        "artefact-gives-way",
        test=test,
        place=place.place,
        scatter=quantity(place.scatter_um, "µm"),
        expected=quantity(place.expected_um, "µm", 1),
    )
