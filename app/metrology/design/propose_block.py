"""The block for a sensor: size, number and widths of merlons, depth of the grooves."""

from dataclasses import dataclass, replace

import numpy as np

from app.errors import OperationError
from app.messages.message import Text, message
from app.metrology.arm.kinematics import Arm
from app.metrology.design.expected_accuracy import (
    POSES,
    ExpectedAccuracy,
    ExpectedSession,
    expect,
    plan_sessions,
)
from app.metrology.design.making_tolerance import (
    MEASURED_MM,
    ToleranceEffect,
    tolerance_effects,
    widest_tolerance_mm,
)
from app.metrology.design.merlon_widths import merlon_edges
from app.metrology.design.stripe_sensor import (
    StripeSensor,
    require_usable_sensor,
    share_of_picture,
)
from app.metrology.targets.crenellated_block import Crenellated
from app.progress import Progress, no_progress

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
LEAST_HEIGHT_MM, LEAST_BASE_MM, MOST_BASE_MM = 5.0, 3.0, 15.0
LEAST_WIDTH_PX, LEAST_WIDTH_MM = 24.0, 0.8
"""Of a merlon or a groove; less is not measured in a picture, and not cut by a usual tool."""
WORTH_CUTTING = 1.03
"""A block with more cuts has to be better by this factor."""


@dataclass(frozen=True)
class BlockDesign:
    """A block, and the accuracy that calibrations with it will have once it has been measured.

    ``tolerance_mm`` (±) is the widest with which it need not be measured; ``effects`` compares.
    """

    sensor: StripeSensor
    block: Crenellated
    one_pose: ExpectedAccuracy
    eight_poses: ExpectedAccuracy
    effects: tuple[ToleranceEffect, ...]
    tolerance_mm: float


def propose_block(
    sensor: StripeSensor, arm: Arm, name: str, progress: Progress = no_progress
) -> BlockDesign:
    """The block with which calibrations of a sensor are most accurate, among those to be made.

    Args:
        sensor: what the block is for.
        arm: the arm that carries the sensor and touches the block.
        name: of the block.
        progress: called with the share done, 0 to 1, and the current step.

    Returns:
        The block, whose sizes are round, with the accuracies to be expected.

    Raises:
        OperationError: ``sensor-numbers``; ``no-block-for-sensor``; ``arm-cannot-reach``.
    """
    require_usable_sensor(sensor)
    blocks = [
        block
        for groove_share in GROOVE_SHARES
        for length_share in LENGTH_SHARES
        if (block := _largest_block(sensor, name, FEWEST_MERLONS, groove_share, length_share))
    ]
    progress(0.0, message("design-plans-poses"))
    session = plan_sessions(sensor, blocks[0], arm)[0] if blocks else None
    best, least = None, np.inf
    for done, block in enumerate(blocks):
        progress(0.3 + 0.4 * done / len(blocks), message("design-compares-blocks"))
        worth = _worth_um(session, block) if session else np.inf
        if worth < least:
            best, least = block, worth
    if best is None or session is None:
        raise OperationError(
            "no-block-for-sensor",
            message("no-block-fits-sensor"),
            "",
            message("check-sensor-numbers"),
        )
    best = _with_more_merlons(session, best, least)

    def assessing(share: float, text: Text) -> None:
        progress(0.7 + 0.3 * share, text)

    return assess_block(sensor, best, arm, assessing)


def _with_more_merlons(session: ExpectedSession, best: Crenellated, least_um: float) -> Crenellated:
    """The block, or one of the same size with more merlons, where that is worth the cuts."""
    sensor, same = session.sensor, best
    for merlons in range(FEWEST_MERLONS + 1, MOST_MERLONS + 1):
        width = same.edges_x_mm[-1] - same.edges_x_mm[0] + 0.4
        edges = merlon_edges(width, merlons, round_step_mm(width))
        block = replace(same, edges_x_mm=edges) if edges else None
        if block is None or not _is_feasible(sensor, block):
            break
        worth = _worth_um(session, block)
        if WORTH_CUTTING * worth < least_um:
            best, least_um = block, worth
    return best


def assess_block(
    sensor: StripeSensor, block: Crenellated, arm: Arm, progress: Progress = no_progress
) -> BlockDesign:
    """The accuracies to be expected with a given block.

    Raises:
        OperationError: ``arm-cannot-reach``; ``adjustment-failed``, where the block does not
            determine the sensor.
    """
    progress(0.0, message("design-predicts-accuracy"))
    sessions = plan_sessions(sensor, block, arm)
    one_pose, eight_poses = expect(sessions, 1), expect(sessions, POSES)
    effects = tolerance_effects(one_pose, eight_poses, progress)
    return BlockDesign(
        sensor,
        replace(block, standard_uncertainty_mm=MEASURED_MM),
        one_pose.accuracy(MEASURED_MM),
        eight_poses.accuracy(MEASURED_MM),
        effects,
        widest_tolerance_mm(effects),
    )


def _worth_um(session: ExpectedSession, block: Crenellated) -> float:
    """What a block is worth: the geometric mean of the accuracies with one pose and with all."""
    try:
        own = (session.with_block(block),)
        one, eight = (expect(own, poses).accuracy(MEASURED_MM).total_um for poses in (1, POSES))
    except OperationError:
        return np.inf
    return float(np.sqrt(one * eight))


def _largest_block(
    sensor: StripeSensor, name: str, merlons: int, groove_share: float, length_share: float
) -> Crenellated | None:
    """The largest block of a shape that the picture shows as a whole, with round sizes."""
    low, high = SMALLEST_MM, min(1.2 * sensor.field_of_view_mm, LARGEST_MM)
    found = None
    while high - low > 0.01 * high:
        middle = (low + high) / 2
        block = _shape(sensor, name, middle, merlons, groove_share, length_share)
        if block is not None and share_of_picture(sensor, block) <= FILL:
            found, low = block, middle
        elif block is None and found is None and share_of_width(sensor, middle) <= FILL:
            low = middle  # too small for so many merlons
        else:
            high = middle
    return found if found is not None and _is_feasible(sensor, found) else None


def share_of_width(sensor: StripeSensor, width_mm: float) -> float:
    """Share of the field of view that a block of a width takes."""
    return width_mm / sensor.field_of_view_mm


def _shape(
    sensor: StripeSensor,
    name: str,
    width_mm: float,
    merlons: int,
    groove_share: float,
    length_share: float,
) -> Crenellated | None:
    step = round_step_mm(width_mm)
    edges = merlon_edges(width_mm, merlons, step)
    if edges is None:
        return None
    groove = min(groove_share * sensor.depth_of_field_mm, DEEPEST_SHARE * width_mm)
    narrowest = min(b - a for a, b in zip(edges[1:-1:2], edges[2::2], strict=True))
    groove = _floor(min(groove, DEEPEST_WIDTHS * narrowest), step)
    base = min(max(0.25 * width_mm, LEAST_BASE_MM, LEAST_HEIGHT_MM - groove), MOST_BASE_MM)
    base = _floor(base + step / 2, step)
    length = _floor(length_share * width_mm, step)
    if min(groove, length) < step:
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


def round_step_mm(width_mm: float) -> float:
    """Sizes of a block are multiples of this."""
    steps = ((100, 1.0), (30, 0.5), (12, 0.2))
    return next((step for least, step in steps if width_mm >= least), 0.1)


def _floor(value_mm: float, step_mm: float) -> float:
    return round(float(np.floor(value_mm / step_mm + 1e-9)) * step_mm, 6)


def _is_feasible(sensor: StripeSensor, block: Crenellated) -> bool:
    """Whether merlons and grooves can be cut, and show enough of crests and floors."""
    widths = np.diff(block.edges_x_mm)
    depth = block.crest_z_mm - block.floor_z_mm
    # at the block's ends, a wall hides so much of the floor from camera and laser
    hidden = depth * block.edges_x_mm[-1] / sensor.standoff_mm
    least = max(LEAST_WIDTH_MM, LEAST_WIDTH_PX * sensor.pixel_mm)
    return bool(widths.min() >= least and widths[1::2].min() >= hidden + least)
