"""A worn, bent or wrong tip shows in touches of a sphere."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.arm.kinematics import Arm, Tip, tip_centres
from app.metrology.gauges.tip_check import check_tip
from tests.guide.builders import REST_RAD, reach_tip
from tests.metrology.builders import six_axis_arm
from tests.metrology.numerics import on_sphere

RADIUS_MM = 12.5


@pytest.fixture(scope="module")
def arm() -> Arm:
    return six_axis_arm(encoder_sd_rad=1e-6)


def touches(arm: Arm, true: Tip, count: int = 9, noise_mm: float = 0.004) -> np.ndarray:
    """Contacts of the true tip all over the upper half, the wrist turned each time."""
    rng = np.random.default_rng(3)
    real = replace(arm, tip=true)
    centre = tip_centres(arm, REST_RAD[None])[0]
    outward = on_sphere(np.linspace(1.0, 0.1, count), 2.4 * np.arange(count))
    far = RADIUS_MM + true.radius_mm + rng.normal(0, noise_mm, count)
    found = []
    for place in centre + far[:, None] * outward:
        start = REST_RAD + np.append(rng.uniform(-0.2, 0.2, 3), rng.uniform(-0.9, 0.9, 3))
        found.append(reach_tip(real, place, start))
    return np.array(found)


def test_a_sound_tip_passes(arm: Arm) -> None:
    found = check_tip(arm, touches(arm, arm.tip), 2 * RADIUS_MM, limit_um=80)
    assert (found.decision, found.cause) == ("pass", "sound")
    assert abs(found.error_um) < found.expanded_uncertainty_um + 15
    assert found.scatter_um < 20


@pytest.mark.parametrize(
    ("true", "cause"),
    [
        (Tip(0.0, 0.0, 120.0, 5.8), "small"),
        (Tip(0.0, 0.0, 120.0, 6.2), "large"),
        (Tip(0.0, 0.0, 120.0, 3.0), "other-tip"),
        (Tip(0.5, 0.0, 120.0, 6.0), "bent"),
    ],
)
def test_what_is_wrong_with_it_is_named(arm: Arm, true: Tip, cause: str) -> None:
    found = check_tip(arm, touches(arm, true), 2 * RADIUS_MM, limit_um=80)
    assert (found.decision, found.cause) == ("fail", cause)
    if cause == "bent":
        assert found.bend_um == pytest.approx(500, rel=0.2)
    else:
        assert found.diameter_mm == pytest.approx(true.diameter_mm, abs=0.03)


def test_a_touch_beside_the_sphere_is_scatter_not_a_bend(arm: Arm) -> None:
    q = touches(arm, arm.tip)
    q[4] = reach_tip(arm, tip_centres(arm, q[4][None])[0] + [0.0, 0.0, 0.6], q[4])
    found = check_tip(arm, q, 2 * RADIUS_MM, limit_um=80)
    assert (found.decision, found.cause) == ("fail", "scatter")


def test_without_the_wrist_turned_no_bend_is_claimed(arm: Arm) -> None:
    q = touches(arm, arm.tip)[:5]
    assert check_tip(arm, q, 2 * RADIUS_MM, limit_um=80).bend_um is None


def test_without_a_limit_nothing_is_decided(arm: Arm) -> None:
    found = check_tip(arm, touches(arm, arm.tip), 2 * RADIUS_MM)
    assert (found.decision, found.cause) == ("none", "sound")
