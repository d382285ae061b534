"""Laser pictures that are not their poses' own: named and left out, or refused; never believed."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest

from app.metrology.adjustment.block.calibrate import BlockCalibration, calibrate_block
from app.metrology.adjustment.block.problem import BlockInputs
from app.metrology.calibration.findings import CalibrationFinding
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.stripe import Stripe, empty_stripe
from app.metrology.transforms import apply
from tests.metrology.refusals import refusal_of
from tests.running.usual import usual

pytestmark = pytest.mark.slow

# Points of the picture that are rebuilt with two calibrations and compared.
PIXELS = np.array([[u, v] for u in (200.0, 640.0, 1080.0) for v in (400.0, 500.0, 600.0)])


def with_stripes(inputs: BlockInputs, stripes: Mapping[int, Stripe]) -> BlockInputs:
    """The same with other lines in the poses at these places."""
    seen = (
        replace(pose, stripe=stripes.get(place, pose.stripe))
        for place, pose in enumerate(inputs.observations)
    )
    return replace(inputs, observations=tuple(seen))


def shifted(inputs: BlockInputs, by_px: Mapping[int, float]) -> BlockInputs:
    """The laser seen so far across, as if the sensor had been bumped between the pictures."""
    stripes = {place: inputs.observations[place].stripe for place in by_px}
    moved = {place: replace(one, v=one.v + by_px[place]) for place, one in stripes.items()}
    return with_stripes(inputs, moved)


def apart_um(a: BlockCalibration, b: BlockCalibration) -> float:
    """Largest distance, in the flange's frame, of points rebuilt by two calibrations."""
    one, other = (
        apply(k.T_flange_sensor, sensor_points(k.camera, k.plane, PIXELS)) for k in (a, b)
    )
    return 1e3 * float(np.max(np.linalg.norm(one - other, axis=1)))


def about(result: BlockCalibration, code: str) -> list[CalibrationFinding]:
    return [finding for finding in result.findings if finding.code == code]


# The adjustment starts from the third.
@pytest.mark.parametrize("place", usual(range(8), {2, 5}, pytest.mark.soak))
def test_one_line_off_the_others_plane_is_named_and_left_out(
    inputs: BlockInputs, found: BlockCalibration, place: int
) -> None:
    result = calibrate_block(shifted(inputs, {place: 3.0}))
    (said,) = about(result, "laser-moved")
    assert (said.quality, said.pose) == ("attention", inputs.observations[place].number)
    of_pose = next(pose for pose in result.poses if pose.number == said.pose)
    assert of_pose.used
    assert "its laser line was excluded" in str(of_pose.reason)
    assert of_pose.stripe_points == 0
    assert apart_um(result, found) < found.uncertainty.total_um
    assert about(result, "laser-plane")[0].quality == "good"


def test_no_line_is_named_where_all_agree(found: BlockCalibration) -> None:
    assert not about(found, "laser-moved")
    assert about(found, "laser-plane")[0].quality == "good"


def test_a_picture_without_a_line_is_named(inputs: BlockInputs, found: BlockCalibration) -> None:
    seen = inputs.observations[3]
    result = calibrate_block(with_stripes(inputs, {3: empty_stripe(seen.stripe.axis)}))
    (said,) = about(result, "line-missing")
    assert (said.quality, said.pose) == ("attention", seen.number)
    assert "the laser was on" in str(said.remedy)
    of_pose = next(pose for pose in result.poses if pose.number == said.pose)
    assert of_pose.used
    assert str(of_pose.reason) == "its picture shows no laser line on the object"
    assert apart_um(result, found) < found.uncertainty.total_um
    assert not about(found, "line-missing")


def test_laser_pictures_exchanged_are_named(inputs: BlockInputs, found: BlockCalibration) -> None:
    third, sixth = inputs.observations[2].stripe, inputs.observations[5].stripe
    result = calibrate_block(with_stripes(inputs, {2: sixth, 5: third}))
    assert {said.pose for said in about(result, "laser-moved")} == {2, 5}
    assert apart_um(result, found) < found.uncertainty.total_um


def test_lines_in_two_planes_are_refused(inputs: BlockInputs) -> None:
    refusal = refusal_of(calibrate_block, shifted(inputs, dict.fromkeys((4, 5, 6, 7), 30.0)))
    assert refusal.code == "lines-contradict"
    assert "each laser picture belongs to its pose" in str(refusal.remedy)


def test_a_laser_that_drifts_is_said_not_to_lie_in_one_plane(inputs: BlockInputs) -> None:
    result = calibrate_block(shifted(inputs, {place: 2.0 * place for place in range(8)}))
    (said,) = about(result, "laser-plane")
    assert said.quality == "attention"
    assert "the laser is mounted firmly" in str(said.remedy)
