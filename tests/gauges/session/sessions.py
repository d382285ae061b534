"""Sessions of performance tests in memory, with an arm that reports poses and a ball bar."""

from functools import partial
from typing import TypeVar

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.gauges.guide_state import apply_row
from crenel.gauges.kinds import KINDS
from crenel.gauges.plan.document_length_standard import LengthPart, LengthStandardFile
from crenel.gauges.session.state import PerformanceState
from crenel.gauges.sphere.guide_state import SphereState
from crenel.guide.common.journal import fold
from crenel.metrology.arm.kinematics import RobotArm, Tip
from crenel.metrology.transforms import Floats
from tests.guide.builders import Row, journal_of

State = TypeVar("State", bound=PerformanceState)
STATES = {name: kind.state for name, kind in KINDS.items()}
ROBOT = RobotArm("Robot", "R-1", Tip(0.0, 0.0, 0.0, 4.0))


def ball_bar(*lengths_mm: float) -> LengthStandardFile:
    lengths = tuple(LengthPart(length_mm=mm, standard_uncertainty_um=0.5) for mm in lengths_mm)
    return LengthStandardFile(name="Bar", sphere_diameter_mm=20.0, lengths=lengths)


def started(test: str, **changes: object) -> Row:
    payload = {"test": test, "calibration_id": "c", "positions": 1, "limits": {}}
    return "started", {**payload, "gauge": "bar", **changes}


def state_after(kind: type[State], *rows: Row, before: State | None = None) -> State:
    """The state of a test of a kind."""
    begun: PerformanceState = before or SphereState()
    found = fold(journal_of(*rows), begun, partial(apply_row, STATES))
    assert isinstance(found, kind)
    return found


def reading(tip_mm: Floats, turn_deg: float = 0.0) -> Floats:
    """Of an arm that reports poses, turned about the vertical."""
    return np.array([*tip_mm, *Rotation.from_euler("z", turn_deg, degrees=True).as_quat()])


def touched(state: State, of_arm: Floats) -> State:
    row = {"feature": state.feature, "place": 0, "reading": of_arm.tolist()}
    return state_after(type(state), ("touched", row), before=state)
