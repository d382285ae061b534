"""The calibration on the sample of eight poses: accuracy, and what is said of bad input."""

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import read_session
from crenel.metrology.adjustment.block.calibrate import BlockCalibration, calibrate_block
from crenel.metrology.adjustment.block.problem import BlockInputs
from crenel.metrology.adjustment.core.observations import FailedPose
from crenel.metrology.adjustment.planning.next_pose import next_poses, pose_delta
from crenel.metrology.adjustment.planning.next_touches import next_touches
from crenel.metrology.calibration.findings import CalibrationFinding
from crenel.metrology.limits import Limits
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import Stripe, empty_stripe
from crenel.metrology.transforms import Floats, apply
from crenel.workflows.calibrate import joint_inputs
from tests.metrology.refusals import refusal_of
from tests.metrology.true_points import Truth
from tests.present import present
from tests.running.usual import usual

pytestmark = pytest.mark.slow


def first_poses(inputs: BlockInputs, count: int) -> BlockInputs:
    return replace(inputs, observations=inputs.observations[:count], q_rad=inputs.q_rad[:count])


@pytest.fixture(scope="module")
def alone(inputs: BlockInputs) -> BlockCalibration:
    """With the first pose alone."""
    return calibrate_block(first_poses(inputs, 1))


def codes(result: BlockCalibration) -> set[str]:
    return {finding.code for finding in result.findings}


def test_points_lie_where_the_truth_has_them(found: BlockCalibration, samples: Path) -> None:
    truth = Truth(samples / "many-poses")
    assert truth.sensor_rms_um(found) < 2.0
    # the arm's own errors are in the claim, so that it holds
    assert truth.flange_rms_um(found) < 2.0 * found.uncertainty.total_um
    assert all(pose.used for pose in found.poses)
    # the one contact that the sample has wrong
    worst = next(point for point in found.worst if point.kind == "contact")
    assert (worst.face, worst.contact, str(worst.name)) == ("crest", 9, "crest 10")


def test_swapped_poses_are_left_out_with_the_pose_that_they_fit(inputs: BlockInputs) -> None:
    q = inputs.q_rad.copy()
    q[[2, 5]] = q[[5, 2]]
    result = calibrate_block(replace(inputs, q_rad=q))
    out = {pose.number: str(pose.reason) for pose in result.poses if not pose.used}
    assert [*out] == [2, 5]
    assert "fits the joint angles of pose 5" in out[2]
    assert "pose-left-out" in codes(result)


def test_a_slightly_wrong_pose_is_left_out(inputs: BlockInputs, found: BlockCalibration) -> None:
    q = inputs.q_rad.copy()
    q[2, 2] += np.radians(0.05)
    result = calibrate_block(replace(inputs, q_rad=q))
    (out,) = [pose for pose in result.poses if not pose.used]
    assert out.number == 2
    assert "fits the joint angles" not in str(out.reason)
    assert result.uncertainty.total_um < 1.2 * found.uncertainty.total_um


def test_one_outlier_of_few_is_left_out_though_it_draws_others_along(inputs: BlockInputs) -> None:
    q = inputs.q_rad[:4].copy()
    q[1, 2] += np.radians(0.1)
    result = calibrate_block(replace(first_poses(inputs, 4), q_rad=q))
    assert [pose.number for pose in result.poses if not pose.used] == [1]
    assert "arm-scatter" not in codes(result)


def test_poses_that_agree_with_none_are_refused(inputs: BlockInputs) -> None:
    rng = np.random.default_rng(1)
    q = inputs.q_rad + rng.uniform(-0.05, 0.05, inputs.q_rad.shape)
    assert refusal_of(calibrate_block, replace(inputs, q_rad=q)).code == "poses-contradict"


def test_a_pose_that_shows_nothing_is_reported_with_its_own_remedy(inputs: BlockInputs) -> None:
    dark = OperationError("no-contrast", "the picture shows no contrast", "", "turn up the light")
    failed = FailedPose(inputs.observations[0].number, dark)
    some = replace(inputs, observations=inputs.observations[1:], q_rad=inputs.q_rad[1:])
    result = calibrate_block(replace(some, failed_poses=(failed,)))
    (said,) = [finding for finding in result.findings if finding.code == "pose-left-out"]
    assert str(said.text).endswith("picture shows no contrast. Turn up the light.")
    assert not said.remedy


def test_poses_all_alike_are_reported(inputs: BlockInputs) -> None:
    seen = inputs.observations[0]
    few = replace(inputs, observations=(seen, replace(seen, number=9)), q_rad=inputs.q_rad[[0, 0]])
    assert "poses-alike" in codes(calibrate_block(few))


# A tenth of a millimetre hides in the noise that it makes the arm seem to have.
@pytest.mark.parametrize("by_mm", usual([-0.1, 1.0, 0.1, -1.0], 2, pytest.mark.soak))
def test_a_wrong_tip_is_seen_and_its_diameter_estimated(inputs: BlockInputs, by_mm: float) -> None:
    tip = inputs.arm.tip
    other = replace(inputs.arm, tip=replace(tip, diameter_mm=tip.diameter_mm + by_mm))
    result = calibrate_block(replace(inputs, arm=other))
    reported = [finding for finding in result.findings if finding.code == "tip-diameter"]
    assert reported
    assert reported[0].remedy
    stated = re.search(r"a tip diameter of ([0-9.]+) mm \(± ([0-9.]+)", str(reported[0].text))
    assert stated
    found_mm, twice_sd_mm = map(float, stated.groups())
    assert found_mm == pytest.approx(tip.diameter_mm, abs=twice_sd_mm)
    assert twice_sd_mm < 0.05


def test_the_right_tip_is_not_doubted(found: BlockCalibration) -> None:
    assert "tip-diameter" not in codes(found)


def test_one_pose_is_the_special_case(found: BlockCalibration, alone: BlockCalibration) -> None:
    assert "one-pose" in codes(alone)
    assert alone.uncertainty.total_um > found.uncertainty.total_um


def test_the_verdict_goes_by_the_users_limits(inputs: BlockInputs) -> None:
    strict = calibrate_block(replace(inputs, limits=Limits(good_um=5.0, usable_um=10.0)))
    assert strict.findings[0].quality == "bad"
    assert "the limit is 10 µm" in str(strict.findings[0].text)


def test_the_advised_pose_helps_the_most(inputs: BlockInputs, alone: BlockCalibration) -> None:
    advice = next_poses(alone.adjustment, inputs.arm, inputs.block, inputs.q_rad[:1])
    assert advice[0].total_um < advice[-1].total_um <= alone.uncertainty.total_um * 1.02
    assert advice[0].total_um < 0.9 * alone.uncertainty.total_um
    move = pose_delta(advice[0].T_obj_cam, advice[-1].T_obj_cam, inputs.block)
    assert "°" in str(move.words)
    none = pose_delta(advice[0].T_obj_cam, advice[0].T_obj_cam, inputs.block)
    assert str(none.words) == "keep this pose"


def test_touches_are_advised_up_to_the_target(inputs: BlockInputs, found: BlockCalibration) -> None:
    now = next_touches(found.alignment, inputs.features, inputs.block, np.inf).now_um
    advice = next_touches(found.alignment, inputs.features, inputs.block, 0.8 * now)
    assert advice.reaches
    assert advice.now_um == pytest.approx(now)
    assert advice.then_um <= 0.8 * now
    assert "more on the" in str(advice.words)
    assert next_touches(found.alignment, inputs.features, inputs.block, 2 * now).more == ()


@pytest.mark.parametrize("times", usual([0.997, 1.02], 1, pytest.mark.soak))
def test_another_size_is_found_by_motion(samples: Path, inputs: BlockInputs, times: float) -> None:
    session = read_session(samples / "many-poses")
    block = session.block
    lengths = ("front_y_mm", "back_y_mm", "crest_z_mm", "floor_z_mm", "base_z_mm")
    other = replace(
        block,
        edges_x_mm=tuple(times * x for x in block.edges_x_mm),
        **{name: times * getattr(block, name) for name in lengths},
    )
    # its pictures show the same edges of a block in proportion, as the first of them confirms
    first = joint_inputs(replace(session, block=other, poses=session.poses[:1]))
    seen = (*first.observations, *inputs.observations[1:])
    found = calibrate_block(replace(inputs, block=other, observations=seen))
    (said,) = [one for one in found.findings if one.code == "object-size"]
    assert said.quality == "bad"
    percent = float(str(said.text).split("object is ")[1].split(" %")[0])
    assert percent == pytest.approx(100 * abs(1 / times - 1), abs=0.15)
    assert ("smaller" if times > 1 else "larger") in str(said.text)


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


def rebuilt(found: BlockCalibration) -> Floats:
    return apply(found.T_flange_sensor, sensor_points(found.camera, present(found.plane), PIXELS))


def apart_um(a: BlockCalibration, b: BlockCalibration) -> float:
    """Largest distance, in the flange's frame, of points rebuilt by two calibrations."""
    off_mm = rebuilt(a) - rebuilt(b)
    return 1e3 * float(np.max(np.linalg.norm(off_mm, axis=1)))


def about(result: BlockCalibration, code: str) -> list[CalibrationFinding]:
    return [finding for finding in result.findings if finding.code == code]


# The adjustment starts from the third.
@pytest.mark.parametrize("place", usual(range(8), {2, 5}, pytest.mark.soak))
def test_a_line_off_is_left_out(inputs: BlockInputs, found: BlockCalibration, place: int) -> None:
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
