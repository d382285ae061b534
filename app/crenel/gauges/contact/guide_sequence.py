"""In which order the contact test is touched. Pure."""

from collections.abc import Mapping

from crenel.gauges.contact.evaluate import (
    LEAST_BAR_TOUCHES,
    bar_feature,
    diameter_feature,
    seat_feature,
)
from crenel.gauges.contact.maths import (
    PLACEMENTS,
    SEAT_POINTS,
    SEATS,
    SPHERE_POINTS,
    SPHERES,
)

FEATURES: Mapping[str, tuple[str, ...]] = {
    "diameter": tuple(diameter_feature(i + 1) for i in range(SPHERES)),
    "seats": tuple(seat_feature(i + 1) for i in range(SEATS)),
    "bar": tuple(bar_feature(i + 1, end) for i in range(PLACEMENTS) for end in (0, 1)),
}
"""Groups of touches of each step, in their order."""
TOUCHES_EACH: Mapping[str, int] = {
    "diameter": SPHERE_POINTS,
    "seats": SEAT_POINTS,
    "bar": LEAST_BAR_TOUCHES,
}
"""Touches of a group."""


def features_of(step: str) -> tuple[str, ...]:
    """The groups of touches of a step."""
    return FEATURES[step]


def touches_of(step: str) -> int:
    """How many touches a step takes.

    Example:
        >>> touches_of("seats")
        30
    """
    return len(FEATURES[step]) * TOUCHES_EACH[step]


def next_feature(step: str, done: int) -> str:
    """The group that a touch (from 0) of a step belongs to; empty once all are done.

    Example:
        >>> next_feature("bar", 4)
        'b1-1'
    """
    group = done // TOUCHES_EACH[step]
    return FEATURES[step][group] if group < len(FEATURES[step]) else ""


def group_of(step: str, done: int) -> int:
    """The group (from 0) that is touched next; of the ball bar both ends are one placement.

    Example:
        >>> group_of("bar", 9), group_of("seats", 9), group_of("seats", 10)
        (1, 0, 1)
    """
    each = TOUCHES_EACH[step] * (2 if step == "bar" else 1)
    return done // each
