"""The fold: whatever the rows, the state follows from them and from nothing else."""

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from crenel.guide.calibration import state as state_module
from crenel.guide.calibration.state import CHANGES, ENDS, FORWARD, NOTES, STEPS
from crenel.guide.calibration.tasks import CONFIRMATIONS
from crenel.guide.common.journal import FORMER_NOTES
from tests.guide.builders import Row, capture_row, point_row, start_row, state_after

CONFIRMED = ("devices_confirmed", "setup_confirmed", "touch_confirmed", "place_confirmed")
TWO_POSES: list[Row] = [start_row("capture"), capture_row(), ("another_pose", {}), capture_row()]
RETAKEN: list[Row] = [start_row("capture"), capture_row(), ("retaken", {}), capture_row()]


def test_each_confirmation_leads_to_the_next_step() -> None:
    rows = [start_row()]
    for kind, step in zip(CONFIRMED, ("setup", "touch", "place", "capture"), strict=True):
        rows.append((kind, {}))
        assert state_after(*rows).step == step


def test_undoing_keeps_the_point_in_the_journal_and_its_number() -> None:
    touched = [start_row("touch"), point_row("crest")]
    state = state_after(*touched, point_row("crest"), ("point_voided", {"index": 1}))
    assert [c.index for c in state.counted] == [0]
    state = state_after(*touched, ("point_voided", {"index": 0}), point_row("front"))
    assert [(c.index, c.face) for c in state.counted] == [(1, "front")]


def test_points_that_were_taken_back_come_back_last_first_until_another_is_taken() -> None:
    rows = [start_row("touch"), point_row("crest"), point_row("crest"), point_row("floor")]
    rows += [("point_voided", {"index": index}) for index in (2, 0, 0)]
    assert state_after(*rows).undone == (2, 0)
    rows.append(("point_restored", {"index": 0}))
    state = state_after(*rows)
    assert [c.index for c in state.counted] == [0, 1]
    assert state.undone == (2,)
    assert state_after(*rows, point_row("front")).undone == ()


def test_points_of_another_object_do_not_count_until_it_is_chosen_again() -> None:
    rows = [start_row("touch"), point_row("crest"), ("chosen", {"field": "object", "id": "other"})]
    assert state_after(*rows).counted == ()
    rows.append(("chosen", {"field": "object", "id": "b"}))
    assert len(state_after(*rows).counted) == 1


def test_a_picture_of_another_sensor_does_not_count() -> None:
    rows = [start_row("capture"), capture_row()]
    assert state_after(*rows).picture is not None
    rows.append(("chosen", {"field": "sensor", "id": "other"}))
    assert state_after(*rows).picture is None


def test_going_back_keeps_everything_and_says_what_is_stale() -> None:
    rows = [start_row("touch"), point_row("crest"), ("touch_confirmed", {})]
    rows += [("place_confirmed", {}), capture_row(), ("went_back", {"to": "touch"})]
    state = state_after(*rows)
    assert state.step == "touch"
    assert state.reached == "solve"
    assert state.picture is not None
    assert len(state.counted) == 1


def test_a_result_is_stale_as_soon_as_an_input_changed() -> None:
    rows = [start_row("touch"), point_row("crest"), capture_row()]
    inputs = state_after(*rows).inputs
    rows.append(("solved", {"inputs": inputs, "outcome": {"total_um": 1.0}}))
    solved = state_after(*rows)
    assert solved.step == "review"
    assert solved.outcome == {"total_um": 1.0}
    for change in (
        ("point_voided", {"index": 0}),
        point_row("front"),
        ("retaken", {}),
        ("chosen", {"field": "arm", "id": "other"}),
        ("line_set", {"line": {"threshold": 9.0}}),
    ):
        assert state_after(*rows, change).outcome is None


def test_a_solve_that_was_overtaken_does_not_open_the_review() -> None:
    rows = [start_row("touch"), point_row("crest"), capture_row()]
    inputs = state_after(*rows).inputs
    rows += [("went_back", {"to": "touch"}), point_row("front")]
    state = state_after(*rows, ("solved", {"inputs": inputs, "outcome": {}}))
    assert state.step == "touch"
    assert state.outcome is None


def test_every_capture_has_a_number_of_its_own_and_a_retaken_one_is_not_offered_again() -> None:
    state = state_after(*RETAKEN)
    assert state.picture is not None
    assert state.picture.number == 2
    assert len(state_after(*RETAKEN, ("retaken", {})).captures) == 2
    # and a retaken one is not offered again
    state = state_after(*RETAKEN, ("pose_restored", {"number": 1}))
    assert [picture.number for picture in state.listed] == [2]


def test_poses_add_up_and_one_can_be_set_aside() -> None:
    state = state_after(*TWO_POSES)
    assert state.step == "solve"
    assert [picture.number for picture in state.pictures] == [1, 2]
    fewer = state_after(*TWO_POSES, ("pose_voided", {"number": 1}))
    assert [picture.number for picture in fewer.pictures] == [2]
    assert fewer.inputs != state.inputs
    none = state_after(*TWO_POSES, ("pose_voided", {"number": 1}), ("pose_voided", {"number": 2}))
    assert none.picture is None
    assert none.step == "place"


def test_a_pose_taken_back_brings_its_result_back_with_it() -> None:
    inputs = state_after(*TWO_POSES).inputs
    solved = ("solved", {"inputs": inputs, "outcome": {"total_um": 1.0}})
    rows = [*TWO_POSES, solved, ("pose_voided", {"number": 1})]
    aside = state_after(*rows)
    assert aside.step == "review"
    assert aside.outcome is None
    assert [picture.number for picture in aside.listed] == [1, 2]
    back = state_after(*rows, ("pose_restored", {"number": 1}))
    assert back.inputs == inputs
    assert back.outcome == {"total_um": 1.0}
    refused = {"inputs": aside.inputs, "code": "c", "what": "w", "why": "", "remedy": ""}
    # that solve took the calibration's file with it
    gone = state_after(*rows, ("solve_refused", refused), ("pose_restored", {"number": 1}))
    assert gone.step == "solve"
    assert gone.outcome is None


def test_a_row_of_an_unknown_kind_is_not_passed_over() -> None:
    with pytest.raises(ValueError, match="unknown kind: conjured"):
        state_after(start_row(), ("conjured", {}))


def test_every_row_that_is_written_is_known() -> None:
    folder = Path(state_module.__file__).parent
    common = [folder.parent / "common" / name for name in ("commands.py", "guided_session.py")]
    source = "".join(path.read_text() for path in [*sorted(folder.rglob("*.py")), *common])
    row = r'(?:append|record|_change_pose,)\(?\s*"(\w+)"'
    written = set(re.findall(row, source)) | set(CONFIRMATIONS.values())
    known = {*FORWARD, *ENDS, *NOTES, *CHANGES}
    assert written | {"accepted"} == known - set(FORMER_NOTES)


SOME_ROWS = st.sampled_from(
    [
        *((kind, {}) for kind in CONFIRMED),
        point_row("crest"),
        point_row("front"),
        ("point_voided", {"index": 0}),
        ("point_voided", {"index": 7}),
        ("face_selected", {"face": "left"}),
        capture_row(),
        ("retaken", {}),
        ("another_pose", {}),
        ("pose_voided", {"number": 1}),
        ("pose_restored", {"number": 1}),
        ("solve_started", {}),
        ("capture_kept", {}),
        ("went_back", {"to": "touch"}),
        ("chosen", {"field": "object", "id": "other"}),
    ]
)


@given(st.lists(SOME_ROWS, max_size=30))
def test_whatever_happened_the_state_is_whole(rows: list[Row]) -> None:
    state = state_after(start_row(), *rows)
    assert state.step in STEPS
    assert STEPS.index(state.reached) >= STEPS.index(state.step)
    assert state.rev == len(rows) + 1
    assert [c.index for c in state.contacts] == list(range(len(state.contacts)))
    assert len(state.contacts) == sum(kind == "point_taken" for kind, _ in rows)
