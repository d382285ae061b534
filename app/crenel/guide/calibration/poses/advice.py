"""Which pose to take next, as the journal keeps it, and how far a hold is from it. Pure."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass

import numpy as np
from pydantic import TypeAdapter

from crenel.guide.common.view import Segment
from crenel.messages.message import Text
from crenel.metrology.adjustment.planning.next_pose import PoseDelta, pose_delta
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import Floats, inverse

Matrix = Sequence[Sequence[float]]
# More poses are asked for while they bring so much, up to so many.
WORTH_IT = 0.93
ENOUGH_POSES, ENOUGH_OF_A_BOARD = 6, 10
FEWEST_POSES, FEWEST_OF_A_BOARD = 2, 8


@dataclass(frozen=True)
class Advice:
    """Hold the sensor there next: a point would then be known to ``then_um`` (k = 1).

    ``words`` states it against the newest pose's hold; ``outline`` is the object as the
    picture would show it from there; ``reading`` is the arm's in it: joint angles, or its pose.
    The matrices place any hold against it. At least ``fewest`` poses are asked for, and up to
    ``enough`` while they help.
    """

    poses: int
    now_um: float
    then_um: float
    words: Text
    outline: Sequence[Segment]
    reading: Sequence[float]
    T_obj_cam: Matrix
    T_arm_obj: Matrix
    T_flange_cam: Matrix
    fewest: int = FEWEST_POSES
    enough: int = ENOUGH_POSES

    @property
    def worth_it(self) -> bool:
        """Whether another pose is asked for, not only welcome."""
        if self.poses < self.fewest:
            return True
        return self.poses < self.enough and self.then_um < WORTH_IT * self.now_um


_ADAPTER = TypeAdapter(Advice)


def to_payload(advice: Advice) -> dict[str, object]:
    return asdict(advice)


def from_payload(payload: Mapping[str, object]) -> Advice:
    # rows of earlier versions name it by its unit
    return _ADAPTER.validate_python({"reading": payload.get("q_rad"), **payload})


def remaining(advice: Advice, T_arm_flange: Floats, item: CalibrationTarget) -> PoseDelta:
    """What is still to be moved from the present hold to the advised one."""
    T_arm_cam = T_arm_flange @ np.array(advice.T_flange_cam)
    present = inverse(np.array(advice.T_arm_obj)) @ T_arm_cam
    return pose_delta(np.array(advice.T_obj_cam), present, item)
