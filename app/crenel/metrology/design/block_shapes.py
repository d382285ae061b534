"""Shapes of blocks that can be cut, touched and seen as a whole, with the sizes that are given."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Message, message, rounded
from crenel.metrology.design.making_tolerance import MEASURED_MM
from crenel.metrology.design.stripe_sensor import StripeSensor, share_of_picture
from crenel.metrology.targets.crenellated_block import Crenellated

SPREAD = 0.4
"""The narrowest width is the mean less this share, the widest the mean and this share."""


def merlon_edges(width_mm: float, merlons: int, step_mm: float) -> tuple[float, ...] | None:
    """Left and right edges of merlons about x = 0, on a grid of sizes.

    Args:
        width_mm: of the block, at most.
        merlons: how many, 2 or more.
        step_mm: every width is a multiple of it.

    Returns:
        ``2 merlons`` ascending edges in mm; None where the grid is too coarse for so many
        different widths.

    Example:
        >>> merlon_edges(44.0, 3, 0.5)
        (-21.5, -9.5, 1.0, 9.5, 16.5, 21.5)
    """
    count = 2 * merlons - 1
    shares = np.linspace(1 + SPREAD, 1 - SPREAD, count)
    steps = np.floor(shares * width_mm / count / step_mm + 1e-9).astype(np.int64)
    if steps[-1] < 1 or (np.diff(steps) >= 0).any():
        return None
    edges = np.concatenate([[0], np.cumsum(steps)])
    edges = (edges - round(edges[-1] / 2)) * step_mm
    return tuple(round(float(x), 6) for x in edges)


FILL = 0.84
"""Share of the picture for the block: the rest is for a hand that holds the sensor."""
GROOVE_SHARES = (0.35, 0.5, 0.65, 0.8)
"""Depths of the grooves that are compared, as shares of the depth of field: crests and floors are
sharp, and so is what lies a little higher and lower while the sensor is tilted."""
LENGTH_SHARES = (0.25, 0.4, 0.6)
"""Lengths of the grooves that are compared, as shares of the block's width."""
FEWEST_MERLONS, MOST_MERLONS = 3, 5
STRIPE_MARGIN_MM, STRIPE_MARGIN_SHARE = 0.6, 0.2
"""The laser line stays so far from the ends of the grooves, and by this share of their depth, since
it wanders along them while the sensor is tilted."""
DEEPEST_SHARE = 0.5
"""Depth of a groove at most, as a share of the block's width, and in widths of the groove."""
DEEPEST_WIDTHS = 4.0
LARGEST_MM, SMALLEST_MM = 200.0, 6.0
"""Width of a block that a person can handle, and of one that a tip can touch."""
LEAST_LENGTH_MM, LEAST_HEIGHT_MM = 3.0, 5.0
"""The least sides that a tip touches in several places."""
LEAST_BASE_MM, MOST_BASE_MM = 3.0, 15.0
LEAST_WIDTH_PX, LEAST_WIDTH_MM = 24.0, 0.8
"""The least width of a merlon or a groove; less is not measured in a picture, and not cut by a
usual tool."""


@dataclass(frozen=True)
class GivenSizes:
    """Sizes of a block that are not to be proposed; None: the design chooses."""

    width_mm: float | None = None
    merlons: int | None = None
    groove_mm: float | None = None
    tolerance_mm: float | None = None


ANY_SIZES = GivenSizes()


def possible_blocks(sensor: StripeSensor, name: str, given: GivenSizes) -> list[Crenellated]:
    """The largest block of each shape that the picture shows as a whole.

    Args:
        sensor: what the block is for.
        name: of the blocks.
        given: sizes that every one of them has.

    Raises:
        OperationError: ``block-sizes``, if the given sizes contradict the sensor or each other;
            ``no-block-for-sensor``.
    """
    _refuse_contradictions(sensor, given)
    found = _every_shape(sensor, name, given)
    if found:
        return found
    anyway = _every_shape(sensor, name, ANY_SIZES)
    if not anyway:
        raise no_block_error()
    raise _sizes_error(_contradiction(sensor, given))


def no_block_error() -> OperationError:
    """The error if nothing that can be made and touched is seen by the sensor."""
    return OperationError(
        "no-block-for-sensor",
        message("no-block-fits-sensor"),
        "",
        message("check-sensor-numbers"),
    )


def _every_shape(sensor: StripeSensor, name: str, given: GivenSizes) -> list[Crenellated]:
    merlons = given.merlons or FEWEST_MERLONS
    return [
        block
        for groove_mm in _groove_depths(sensor, given)
        for length_share in LENGTH_SHARES
        if (block := _largest_block(sensor, name, given, merlons, groove_mm, length_share))
    ]


def _groove_depths(sensor: StripeSensor, given: GivenSizes) -> Iterator[float]:
    if given.groove_mm is not None:
        yield given.groove_mm
        return
    for share in GROOVE_SHARES:
        yield share * sensor.depth_of_field_mm


def _refuse_contradictions(sensor: StripeSensor, given: GivenSizes) -> None:
    """Refuses what needs no trial."""
    if given.groove_mm is not None and given.groove_mm > sensor.depth_of_field_mm:
        depth = rounded(sensor.depth_of_field_mm, "mm")
        groove = rounded(given.groove_mm, "mm")
        raise _sizes_error(message("groove-deeper-than-sharp", groove=groove, depth=depth))
    if given.width_mm is not None:
        widest = rounded(min(FILL * sensor.field_of_view_mm, LARGEST_MM), "mm")
        if given.width_mm > min(FILL * sensor.field_of_view_mm, LARGEST_MM):
            width = rounded(given.width_mm, "mm")
            raise _sizes_error(message("block-wider-than-view", width=width, most=widest))


def _contradiction(sensor: StripeSensor, given: GivenSizes) -> Message:
    """What of the given sizes leaves no block."""
    merlons = given.merlons or FEWEST_MERLONS
    width_mm = given.width_mm
    if width_mm is None:
        if given.groove_mm is None:
            return message("no-width-for-given-merlons", merlons=merlons)
        groove = rounded(given.groove_mm, "mm")
        return message("no-width-for-given-sizes", merlons=merlons, groove=groove)
    width = rounded(width_mm, "mm")
    edges = block_edges(width_mm, merlons, given)
    if edges is None:
        return message("merlons-would-be-mirror", merlons=merlons, width=width)
    widths = np.diff(edges)
    if not widths.min() >= _least_width_mm(sensor):
        least = rounded(round(_least_width_mm(sensor), 2), "mm")
        narrowest = rounded(round(float(widths.min()), 3), "mm")
        return message("merlons-too-narrow", merlons=merlons, narrowest=narrowest, least=least)
    if given.groove_mm is not None and given.groove_mm > DEEPEST_WIDTHS * widths[1::2].min():
        most = rounded(round(DEEPEST_WIDTHS * float(widths[1::2].min()), 2), "mm")
        return message("groove-too-deep-to-cut", groove=rounded(given.groove_mm, "mm"), most=most)
    return message("sizes-not-shown-as-a-whole", width=width)


def _sizes_error(text: Message) -> OperationError:
    return OperationError("block-sizes", text, "", message("give-other-sizes-or-leave-them"))


def _largest_block(
    sensor: StripeSensor,
    name: str,
    given: GivenSizes,
    merlons: int,
    groove_mm: float,
    length_share: float,
) -> Crenellated | None:
    """The largest block of a shape that the picture shows as a whole, with round sizes."""

    def shape(width_mm: float) -> Crenellated | None:
        return _shape(sensor, name, given, width_mm, merlons, groove_mm, length_share)

    if given.width_mm is not None:
        found = shape(given.width_mm)
        if found is None or share_of_picture(sensor, found) > FILL:
            return None
        return found if is_feasible(sensor, found) else None
    low, high = SMALLEST_MM, min(1.2 * sensor.field_of_view_mm, LARGEST_MM)
    found = None
    while high - low > 0.01 * high:
        middle = (low + high) / 2
        block = shape(middle)
        if block is not None and share_of_picture(sensor, block) <= FILL:
            found, low = block, middle
        elif block is None and found is None and middle <= FILL * sensor.field_of_view_mm:
            low = middle  # too small for so many merlons, or for so deep grooves
        else:
            high = middle
    return found if found is not None and is_feasible(sensor, found) else None


def _shape(
    sensor: StripeSensor,
    name: str,
    given: GivenSizes,
    width_mm: float,
    merlons: int,
    groove_mm: float,
    length_share: float,
) -> Crenellated | None:
    step = round_step_mm(width_mm)
    edges = block_edges(width_mm, merlons, given)
    if edges is None:
        return None
    narrowest = min(b - a for a, b in zip(edges[1:-1:2], edges[2::2], strict=True))
    if given.groove_mm is None:
        groove = min(groove_mm, DEEPEST_SHARE * width_mm, DEEPEST_WIDTHS * narrowest)
        groove = _floor(groove, step)
    elif groove_mm <= DEEPEST_WIDTHS * narrowest:
        groove = groove_mm
    else:
        return None
    base = min(max(0.25 * width_mm, LEAST_BASE_MM, LEAST_HEIGHT_MM - groove), MOST_BASE_MM)
    base = _floor(base + step / 2, step)
    length = max(_floor(length_share * width_mm, step), LEAST_LENGTH_MM)
    if groove < step:
        return None
    # the middle of what the picture shows of the block lies on the camera's axis
    back = _floor(length / 2 + base / 2 * np.tan(np.radians(sensor.angle_deg)), step)
    margin = STRIPE_MARGIN_MM + STRIPE_MARGIN_SHARE * groove
    if length < 2 * margin:
        return None
    front = round(min(max(back - length, margin - length), -margin), 6)
    front = _floor(front, step)
    return Crenellated(
        name, "", edges, front, round(front + length, 6), groove, 0.0, -base, MEASURED_MM
    )


def block_edges(width_mm: float, merlons: int, given: GivenSizes) -> tuple[float, ...] | None:
    """``merlon_edges`` of a block; as wide as given, what rounding leaves is the first merlon's."""
    step = round_step_mm(width_mm)
    edges = merlon_edges(width_mm, merlons, step)
    if edges is None or given.width_mm is None:
        return edges
    x = np.array([edges[-1] - given.width_mm, *edges[1:]])
    x -= step * np.round((x[0] + x[-1]) / 2 / step)
    return tuple(round(float(one), 6) for one in x)


def round_step_mm(width_mm: float) -> float:
    """Sizes of a block are multiples of this."""
    steps = ((100, 1.0), (30, 0.5), (12, 0.2))
    return next((step for least, step in steps if width_mm >= least), 0.1)


def _floor(value_mm: float, step_mm: float) -> float:
    return round(float(np.floor(value_mm / step_mm + 1e-9)) * step_mm, 6)


def is_feasible(sensor: StripeSensor, block: Crenellated) -> bool:
    """Whether merlons and grooves can be cut, and show enough of crests and floors."""
    widths = np.diff(block.edges_x_mm)
    depth = block.crest_z_mm - block.floor_z_mm
    # at the block's ends, a wall hides so much of the floor from camera and laser
    hidden = depth * block.edges_x_mm[-1] / sensor.standoff_mm
    least = _least_width_mm(sensor)
    return bool(widths.min() >= least and widths[1::2].min() >= hidden + least)


def _least_width_mm(sensor: StripeSensor) -> float:
    return max(LEAST_WIDTH_MM, LEAST_WIDTH_PX * sensor.pixel_mm)
