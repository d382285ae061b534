"""The block for a sensor: size, number and widths of merlons, depth of the grooves."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.design.block_shapes import (
    ANY_SIZES,
    FEWEST_MERLONS,
    MOST_MERLONS,
    GivenSizes,
    block_edges,
    is_feasible,
    no_block_error,
    possible_blocks,
)
from crenel.metrology.design.expected_accuracy import (
    POSES,
    ExpectedAccuracy,
    ExpectedSession,
    expect,
    plan_sessions,
)
from crenel.metrology.design.making_tolerance import (
    MEASURED_MM,
    ToleranceEffect,
    tolerance_effects,
    widest_tolerance_mm,
)
from crenel.metrology.design.stripe_sensor import StripeSensor, require_usable_sensor
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.progress import Progress, no_progress

WORTH_CUTTING = 1.03
"""A block with more cuts has to be better by this factor."""


@dataclass(frozen=True)
class BlockDesign:
    """A block, and the accuracy that calibrations with it will have once it has been measured.

    ``tolerance_mm`` (±) is the one that is given, or the widest with which it need not be measured;
    ``effects`` compares.
    """

    sensor: StripeSensor
    block: Crenellated
    one_pose: ExpectedAccuracy
    eight_poses: ExpectedAccuracy
    effects: tuple[ToleranceEffect, ...]
    tolerance_mm: float


def propose_block(
    sensor: StripeSensor,
    arm: Arm,
    name: str,
    progress: Progress = no_progress,
    given: GivenSizes = ANY_SIZES,
) -> BlockDesign:
    """The block with which calibrations of a sensor are most accurate, among those to be made.

    Args:
        sensor: what the block is for.
        arm: the arm that carries the sensor and touches the block.
        name: of the block.
        progress: called with the share done, 0 to 1, and the current step.
        given: sizes that are kept.

    Returns:
        The block, whose other sizes are round, with the accuracies to be expected.

    Raises:
        OperationError: ``sensor-numbers``; ``arm-cannot-reach``; as ``possible_blocks``.
    """
    require_usable_sensor(sensor)
    blocks = possible_blocks(sensor, name, given)
    progress(0.0, message("design-plans-poses"))
    (session,) = plan_sessions(sensor, blocks[0], arm, 1)
    worths = []
    for done, block in enumerate(blocks):
        progress(0.3 + 0.4 * done / len(blocks), message("design-compares-blocks"))
        worths.append(_worth_um(session, block))
    if not np.isfinite(min(worths)):
        raise no_block_error()
    best = blocks[int(np.argmin(worths))]
    if given.merlons is None:
        best = _with_more_merlons(session, best, min(worths), given)

    def assessing(share: float, text: Text) -> None:
        progress(0.7 + 0.3 * share, text)

    return assess_block(sensor, best, arm, assessing, given.tolerance_mm)


def _with_more_merlons(
    session: ExpectedSession, best: Crenellated, least_um: float, given: GivenSizes
) -> Crenellated:
    """The block, or one of the same size with more merlons, where that is worth the cuts."""
    sensor, same = session.sensor, best
    for merlons in range(FEWEST_MERLONS + 1, MOST_MERLONS + 1):
        width = same.edges_x_mm[-1] - same.edges_x_mm[0] + 0.4
        edges = block_edges(given.width_mm or width, merlons, given)
        block = replace(same, edges_x_mm=edges) if edges else None
        if block is None or not is_feasible(sensor, block):
            break
        worth = _worth_um(session, block)
        if WORTH_CUTTING * worth < least_um:
            best, least_um = block, worth
    return best


def assess_block(
    sensor: StripeSensor,
    block: Crenellated,
    arm: Arm,
    progress: Progress = no_progress,
    tolerance_mm: float | None = None,
) -> BlockDesign:
    """The accuracies to be expected with a given block, made to a tolerance if that is given.

    Raises:
        OperationError: ``arm-cannot-reach``; ``adjustment-failed``, where the block does not
            determine the sensor.
    """
    progress(0.0, message("design-predicts-accuracy"))
    sessions = plan_sessions(sensor, block, arm)
    one, eight = expect(sessions, 1), expect(sessions, POSES)
    measured = one.accuracy(MEASURED_MM), eight.accuracy(MEASURED_MM)
    effects = tolerance_effects((one, eight), measured, tolerance_mm, progress)
    return BlockDesign(
        sensor,
        replace(block, standard_uncertainty_mm=MEASURED_MM),
        *measured,
        effects,
        tolerance_mm or widest_tolerance_mm(effects),
    )


def _worth_um(session: ExpectedSession, block: Crenellated) -> float:
    """What a block is worth: the geometric mean of the accuracies with one pose and with all."""
    try:
        own = (session.with_block(block),)
        one, eight = (expect(own, poses).accuracy(MEASURED_MM).total_um for poses in (1, POSES))
    except OperationError:
        return np.inf
    return float(np.sqrt(one * eight))
