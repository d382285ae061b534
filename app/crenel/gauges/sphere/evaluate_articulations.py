"""Whether the articulations of a location test were held as wanted, and differ from one another."""

from typing import Literal

from crenel.gauges.sphere.maths_articulation import (
    HELD_DEG,
    LEAST_APART_DEG,
    angle_deg,
    nearest_pair,
)
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity
from crenel.metrology.transforms import Floats


def articulation_notes(
    directions: Floats, wanted: Floats, by: Literal["touch", "scan"], position: int
) -> list[Text]:
    """One sentence for each articulation that is further than ``HELD_DEG`` from the wanted one.

    Args:
        directions: (5, 3) of the stylus, or towards the camera.
        wanted: (5, 3).
        position: of the sphere.
    """
    notes: list[Text] = []
    for number, (held, meant) in enumerate(zip(directions, wanted, strict=True), 1):
        off_deg = angle_deg(held, meant)
        if off_deg <= HELD_DEG:
            continue
        off, most = quantity(off_deg, "°"), quantity(HELD_DEG, "°")
        where = {"position": position, "number": number}
        notes.append(
            message("articulation-touched-otherwise", off=off, most=most, **where)
            if by == "touch"
            else message("articulation-scanned-otherwise", off=off, most=most, **where)
        )
    return notes


def articulations_alike(directions: Floats) -> Text:
    """Why a location error over these articulations (N, 3) says nothing; empty if it does.

    Source:
        ISO 10360-12 and ASME B89.4.22 want distinct articulations; how distinct is a choice of
        this program.
    """
    first, second, apart_deg = nearest_pair(directions)
    if apart_deg >= LEAST_APART_DEG:
        return ""
    apart, least = beside_limit(apart_deg, LEAST_APART_DEG, "°")
    return message(
        "articulations-nearly-same",
        first=first + 1,
        second=second + 1,
        apart=apart,
        least=least,
    )
