"""A block and an arm."""

import numpy as np
import pytest

from app.metrology.arm.kinematics import Arm, Joint, Tip
from app.metrology.targets.crenellated_block import Crenellated


@pytest.fixture(scope="session")
def block() -> Crenellated:
    edges = (-22.0, -14.0, -7.0, -2.0, 5.0, 10.0, 17.0, 22.0)
    return Crenellated("block", "B-1", edges, -12.0, 12.0, 15.0, 0.0, -12.0, 0.002)


@pytest.fixture(scope="session")
def arm() -> Arm:
    """A six-axis arm with a long reach."""
    shape = [(0, -90, 280), (450, 0, 0), (60, -90, 0), (0, 90, 400), (0, -90, 0), (0, 0, 90)]
    joints = tuple(
        Joint(f"J{i + 1}", a, np.radians(alpha), d, 0.0, encoder_sd_rad=1e-5)
        for i, (a, alpha, d) in enumerate(shape)
    )
    return Arm("test arm", "A-1", joints, Tip(0.0, 0.0, 120.0, 6.0))
