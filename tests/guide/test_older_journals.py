"""Rows of journals of earlier versions are read as they were meant."""

from crenel.gauges.quick.guide import state as verify
from crenel.guide.arm import state as arm
from crenel.guide.calibration import state as calibration
from crenel.guide.calibration.outcome import from_payload as outcome_from
from crenel.guide.calibration.poses.advice import FEWEST_POSES
from crenel.guide.calibration.poses.advice import from_payload as advice_from
from crenel.guide.common.journal import FORMER_NOTES

UNTURNED = [[float(i == j) for j in range(4)] for i in range(4)]
ADVISED: dict[str, object] = {
    "poses": 1,
    "now_um": 40.0,
    "then_um": 39.9,
    "words": "tilt left 20°",
    "outline": [[0.0, 0.0, 9.0, 9.0]],
    "q_rad": [0.0] * 6,
    "T_obj_cam": UNTURNED,
    "T_arm_obj": UNTURNED,
    "T_flange_cam": UNTURNED,
}
LOOKED_AT: dict[str, object] = {
    "corners": [{"name": "crest:0:L:front", "u": 5.0, "v": 6.0, "residual_px": 0.1}],
    "outline": [[0.0, 0.0, 9.0, 9.0]],
    "stripe": [[1.0, 2.0]],
    "findings": [],
    "result": None,
}


def test_advice_was_for_a_block() -> None:
    assert advice_from(ADVISED).worth_it
    assert not advice_from({**ADVISED, "poses": FEWEST_POSES}).worth_it


def test_what_was_found_has_no_points_of_its_own() -> None:
    outcome = outcome_from(LOOKED_AT)
    assert outcome.points == ()
    assert outcome.corners[0].name == "crest:0:L:front"


def test_the_simulated_operator_had_another_name() -> None:
    assert FORMER_NOTES
    for handled in (calibration.NOTES, arm.CHANGES, verify.CHANGES):
        assert set(FORMER_NOTES) <= {*handled}
