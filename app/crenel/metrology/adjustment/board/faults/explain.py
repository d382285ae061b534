"""What the poses of another program are, if they do not agree with the pictures as they are given.

Explanations compete by how many poses they make agree with the pictures. Of those that explain
nearly as many as the best, about as closely, the simplest is named: a unit or an inverted pose
before pictures and poses that slipped, these before rotations that were read by another convention,
then a change midway, and a certificate that is wrong only if nothing else explains the poses.
"""

from dataclasses import replace
from typing import get_args

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.board.faults.agreement import SeenBoard, mounting_of
from crenel.metrology.adjustment.board.faults.changed_midway import FEWEST_AFTER, ChangeFault
from crenel.metrology.adjustment.board.faults.readings import (
    Convention,
    OtherReading,
    list_other_readings,
)
from crenel.metrology.adjustment.board.initial_guess import board_camera
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.arm_readings import flange_motion
from crenel.metrology.adjustment.core.hand_eye import (
    CONTRADICTS_MM,
    Mounting,
    refuse_contradictions,
)
from crenel.metrology.robust import median

POSE_CODES = frozenset(
    {
        "poses-contradict",
        "poses-in-other-unit",
        "poses-reversed",
        "square-size",
        "board-ambiguous",
    }
)
"""Refusals whose cause may be one of these faults."""
CLOSER, EQUAL_MM = 3.0, 0.2
"""A reading is better if the poses agree this many times as closely, and not only by this."""
MOST_AGREEING = 0.7
"""If a larger share of the poses agrees as it is, the others are left out, and named."""
RANKS: dict[str, int] = {
    **dict.fromkeys(("mirrored", "unit", *get_args(Convention)), 0),
    **dict.fromkeys(("before", "after", "reversed", "sorted"), 1),
    **dict.fromkeys(("late", "early", "swapped"), 2),
    "rotations": 3,
    **dict.fromkeys(get_args(ChangeFault), 4),
    "mixed": 5,
    "certificate": 6,
}
"""The simplest first."""


def explain_poses(inputs: BoardInputs, error: OperationError) -> OperationError:
    """The error with the fault of the poses that explains it, or the same error if none does.

    A certificate is doubted only if the poses agree with squares of another size.

    Args:
        inputs: as they were given.
        error: why they were refused.
    """
    if error.code not in POSE_CODES:
        return error
    other = find_other_reading(inputs)
    if other is not None and other.fault != "certificate":
        return _read_otherwise(inputs, other)
    if other is None and error.code == "square-size":
        return _contradiction(inputs) or error
    return error


def refuse_misread_poses(inputs: BoardInputs, mounting: Mounting) -> None:
    """Refuses poses of which some agree with the pictures, if all do when they are read otherwise.

    Pictures that are only tilted about the middle of the board nearly agree with inverted poses.

    Args:
        inputs: as they were given.
        mounting: what they agree on, without pictures whose corners nothing numbers.

    Raises:
        OperationError: ``poses-read-otherwise``.
    """
    apart_mm, agree = median(mounting.off_mm), int(np.sum(~mounting.contradicts))
    count = len(inputs.observations)
    if agree == count and apart_mm < CONTRADICTS_MM:
        return
    other = find_other_reading(inputs)
    if other is None or other.fault == "certificate":
        return
    if other.fault in get_args(ChangeFault):
        if other.agree >= agree + FEWEST_AFTER:
            raise _read_otherwise(inputs, other)
        return
    closer = other.agree > agree and other.apart_mm * CLOSER < apart_mm
    few = agree < MOST_AGREEING * count
    if closer or (few and other.pairing is not None and other.agree >= agree + 2):
        raise _read_otherwise(inputs, other)


def find_other_reading(inputs: BoardInputs) -> OtherReading | None:
    """The reading of the poses that agrees best with the pictures, if any other does."""
    T_arm_flange = flange_motion(inputs.arm, inputs.readings).T_arm_flange
    try:
        camera, _ = board_camera(inputs.observations, inputs.board, inputs.size_px)
    except OperationError:
        return None
    seen = SeenBoard(inputs.board, inputs.observations, camera)
    found: list[OtherReading] = []
    for readings in list_other_readings(inputs, seen, T_arm_flange):
        found += readings
        if any(_explains_all(one, len(T_arm_flange)) for one in found):
            break
    if not found:
        return None
    most, closest = max(one.agree for one in found), min(one.apart_mm for one in found)
    good = [
        one
        for one in found
        if one.agree >= most - _count_left_out(one, len(T_arm_flange))
        and one.apart_mm <= max(CLOSER * closest, closest + EQUAL_MM)
    ]
    return min(
        good or found,
        key=lambda one: (RANKS[one.fault], -one.agree, one.apart_mm),
    )


def _explains_all(one: OtherReading, count: int) -> bool:
    """Whether all pictures agree that have a pose, so that nothing less simple is looked for."""
    covered = count if one.pairing is None else len(one.pairing.picture)
    return one.agree == covered and one.apart_mm < CONTRADICTS_MM


def _count_left_out(one: OtherReading, count: int) -> int:
    """Poses by which a reading may explain fewer than the best: those that it leaves no picture."""
    return 1 if one.pairing is None else count - len(one.pairing.picture)


def _read_otherwise(inputs: BoardInputs, other: OtherReading) -> OperationError:
    pairing = other.pairing
    pairs = ""
    if pairing is not None and other.fault == "mixed":
        numbers = [one.number for one in inputs.observations]
        pairs = ", ".join(
            f"{numbers[picture]}: {numbers[pose]}"
            for picture, pose in zip(pairing.picture, pairing.pose, strict=True)
            if picture != pose
        )
    return OperationError(
        "poses-read-otherwise",
        message(
            "poses-agree-read-otherwise",
            name=inputs.board.name,
            fault=other.fault,
            agree=other.agree,
            count=len(inputs.observations),
            apart=quantity(other.apart_mm, "mm", 1),
            right=other.rotations.right,
            first=other.first,
            other=other.other,
            rows=0 if pairing is None else pairing.rows,
            unit=other.unit,
        ),
        message(
            "so-poses-are-not-what-is-expected",
            fault=other.fault,
            given=other.rotations.given,
            pairs=pairs,
        ),
        message(
            "convert-poses-read-otherwise",
            fault=other.fault,
            controllers=", ".join(other.rotations.controllers),
            first=other.first,
        ),
    )


def _contradiction(inputs: BoardInputs) -> OperationError | None:
    """That the poses contradict each other, where no size of the squares makes them agree."""
    T_arm_flange = flange_motion(inputs.arm, inputs.readings).T_arm_flange
    camera, _ = board_camera(inputs.observations, inputs.board, inputs.size_px)
    given = mounting_of(SeenBoard(inputs.board, inputs.observations, camera), T_arm_flange)
    if given is None:
        return None
    none_agrees = replace(given, contradicts=np.ones_like(given.contradicts))
    try:
        refuse_contradictions(none_agrees, [one.number for one in inputs.observations], "board")
    except OperationError as error:
        return error
    return None
