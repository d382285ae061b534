"""The figures of a sphere in a performance test: its 25 places, and its centres."""

from collections.abc import Collection, Sequence

import numpy as np

from crenel.formats.json_document import Vector3
from crenel.gauges.judgement.document import ImpliedOffsetPart, SphereMeasurement
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.sphere.maths_location import smallest_enclosing_sphere
from crenel.gauges.sphere.maths_pattern import RINGS
from crenel.messages.message import Text, message, quantity, rounded, signed
from crenel.report.figure import (
    BLUE,
    FAINT,
    GROUND,
    INK,
    INSIDE,
    LINE,
    OUTSIDE,
    RED,
    SOFT,
    WHITE,
    Dot,
    Figure,
    Point,
    magnification,
)
from crenel.report.formatting import micrometres, plus_minus

SIDE = 250.0
RIM = 100.0
"""Radius of the drawn hemisphere."""
LARGEST_DOT, LEAST_DOT = 8.0, 1.2
CENTRES = 88.0
"""Radius of the field about the drawn centres."""


def pattern_places() -> list[Point]:
    """Where the 25 places lie about the pole, as seen from it; the rim has the radius 1."""
    places = []
    for tilt_deg, count, turn_deg in RINGS:
        for i in range(count):
            turn = np.radians(turn_deg + 360.0 * i / count)
            reach = tilt_deg / 90.0
            places.append((float(reach * np.cos(turn)), float(reach * np.sin(turn))))
    return places


def hemisphere_figure(
    deviations_um: Sequence[float | None], title: Text
) -> tuple[Figure[Text], Text]:
    """The deviations of the 25 places on the hemisphere, blue inside and orange outside.

    Args:
        deviations_um: of each place, in the order of the pattern; None of a place without a value.
    """
    figure = Figure[Text](SIDE, 2 * RIM + 32, title)
    centre = (SIDE / 2, RIM + 14)
    for tilt_deg, *_ in reversed(RINGS[1:]):
        fill = GROUND if tilt_deg == 90.0 else ""
        figure.items.append(Dot(centre, RIM * tilt_deg / 90.0, fill, LINE, 0.5))
    known = [abs(value) for value in deviations_um if value is not None]
    largest = max(known, default=0.0)
    for (x, y), value in zip(pattern_places(), deviations_um, strict=False):
        at = (centre[0] + RIM * x, centre[1] - RIM * y)
        if value is None:
            figure.items.append(Dot(at, 2.5, "", RED, 0.8))
            continue
        share = abs(value) / largest if largest else 0.0
        radius = LEAST_DOT + share * (LARGEST_DOT - LEAST_DOT)
        figure.items.append(Dot(at, radius, OUTSIDE if value >= 0 else INSIDE, WHITE, 0.5))
        figure.label((at[0], at[1] - radius - 1.5), signed(value, decimals=1), 6.5, INK, "middle")
    return figure, message(
        "places-of-hemisphere", title=title, largest=micrometres(largest), count=len(known)
    )


def centres_figure(
    centres_mm: Sequence[Vector3], title: Text, others_mm: Sequence[Vector3] = ()
) -> tuple[Figure[Text], Text]:
    """Centres of the articulations from above and from the side, with the sphere about them.

    Args:
        centres_mm: found with a free diameter; at least one.
        others_mm: the same with the calibrated diameter, drawn faintly.
    """
    points = np.array(centres_mm)
    found = smallest_enclosing_sphere(points)
    off_mm = points - found.centre_mm
    others = np.array(others_mm).reshape(-1, 3) - found.centre_mm
    reach = max(float(np.abs(part).max()) for part in (off_mm, others) if len(part))
    factor = magnification(max(reach, found.diameter_mm / 2), CENTRES - 12)
    figure = Figure[Text](520, 2 * CENTRES + 22, title)
    for left, axes, names in ((40.0, (0, 1), "xy"), (300.0, (0, 2), "xz")):
        middle = (left + CENTRES, CENTRES + 2)
        figure.box((left, 2), 2 * CENTRES, 2 * CENTRES, GROUND)
        figure.items.append(Dot(middle, found.diameter_mm / 2 * factor, WHITE, FAINT, 0.8))

        def at(row: np.ndarray, axes: tuple[int, int] = axes, middle: Point = middle) -> Point:
            across, up = row[list(axes)] * factor
            return float(middle[0] + across), float(middle[1] - up)

        for row in others:
            figure.items.append(Dot(at(row), 2.6, "", FAINT, 0.7))
        for number, row in enumerate(off_mm, 1):
            x, y = at(row)
            figure.items.append(Dot((x, y), 2.4, BLUE, WHITE, 0.4))
            figure.label((x + 4, y - 3), str(number), 7, INK)
        figure.label((left + CENTRES, 2 * CENTRES + 13), names[0], 7.5, SOFT, "middle")
        figure.label((left - 8, CENTRES + 4), names[1], 7.5, SOFT, "end")
    return figure, message(
        "centres-of-articulations-or-none",
        title=title,
        count=len(points),
        diameter=micrometres(1e3 * found.diameter_mm),
        factor=rounded(factor),
        others="yes" if len(others) else "no",
    )


def offset_figure(offset: ImpliedOffsetPart) -> tuple[Figure[Text], Text]:
    """The error of the probe matrix in the sensor's frame, with twice its standard uncertainty."""
    values_um = [1e3 * value for value in offset.offset_mm]
    spreads_um = [2e3 * value for value in offset.standard_uncertainty_mm]
    pairs = list(zip("xyz", values_um, spreads_um, strict=True))
    reach = max(abs(value) + spread for _, value, spread in pairs)
    scale = 150.0 / max(reach, 0.1)
    figure = Figure[Text](520, 24.0 * len(pairs) + 8, message("implied-offset"))
    zero = 240.0
    for row, (name, value, spread) in enumerate(pairs):
        y = 24.0 * row + 14
        figure.box((zero - 160, y - 7), 320, 14, GROUND)
        at = zero + value * scale
        figure.line((zero, y), (at, y), stroke=BLUE, width=4)
        figure.line((at - spread * scale, y), (at + spread * scale, y), stroke=INK, width=1)
        figure.label((zero - 168, y + 3), name, 8, SOFT, "end")
        figure.label(
            (zero + 168, y + 3),
            message(
                "value-with-spread",
                value=signed(value, "µm", 1),
                spread=plus_minus(micrometres(spread)),
            ),
            8,
            INK,
        )
    figure.line((zero, 4), (zero, 24.0 * len(pairs) + 4), stroke=FAINT)
    size_um = float(np.linalg.norm(values_um))
    return figure, message(
        "implied-offset-caption",
        size=micrometres(size_um),
        left=micrometres(offset.left_um),
        significant="yes" if offset.significant else "no",
    )


def sphere_pictures(sphere: SphereMeasurement) -> list[tuple[Figure[Text], Text]]:
    """The hemispheres of one position: touched, and scanned."""
    place = quantity(sphere.position)
    found = []
    if sphere.touch_deviations_um:
        title = message("touched-places-of-position", position=place)
        found.append(hemisphere_figure(sphere.touch_deviations_um, title))
    if any(patch.deviation_um is not None for patch in sphere.patches):
        title = message("scanned-places-of-position", position=place)
        found.append(hemisphere_figure([one.deviation_um for one in sphere.patches], title))
    return found


def centre_pictures(
    sphere: SphereMeasurement, stated: Collection[Quantity]
) -> list[tuple[Figure[Text], Text]]:
    """The centres of one position's articulations: by touch, and by scan.

    Args:
        stated: the quantities that have a value; the diameter of the sphere about the centres is
            one.
    """
    place = quantity(sphere.position)
    found = []
    if sphere.tactile_centres_mm and "location-touch" in stated:
        title = message("touched-centres-of-position", position=place)
        found.append(centres_figure(sphere.tactile_centres_mm, title))
    if sphere.scan_centres_mm and "location-scan" in stated:
        title = message("scanned-centres-of-position", position=place)
        found.append(centres_figure(sphere.scan_centres_mm, title, sphere.fixed_centres_mm))
    return found
