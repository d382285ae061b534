"""The guided calibration on a chessboard: views planned, touching left to the operator."""

from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import arm_document
from crenel.guide.calibration.flow import build_view
from crenel.guide.calibration.live import CameraCalibration, ConnectedArm, SelectedDatasheets
from crenel.guide.calibration.outcome import to_payload
from crenel.guide.calibration.poses.board_views import VIEWS, next_view, plan_view, still_missing
from crenel.guide.calibration.poses.detection import detect_in_capture
from crenel.guide.calibration.rules import RULES
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.guide.calibration.state import CalibrationState
from crenel.guide.calibration.steps.first_pose import first_outline
from crenel.guide.calibration.steps.poses import pose_pictures
from crenel.guide.calibration.touch.board import WANTED, suggest_board_places
from crenel.guide.calibration.touch.report import face_in_use, face_names
from crenel.guide.common.view import (
    BoardGeometry,
    Busy,
    CameraPicture,
    ChoicesPicture,
    ObjectPicture,
    StillPicture,
)
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.planning.next_pose import PoseDelta
from crenel.metrology.arm.kinematics import RobotArm, tip_centres
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import FACES
from crenel.station.devices.capture import Capture, Lighting
from crenel.station.devices.reading_buffer import ReadingMean
from crenel_hardware.interfaces import Frame
from tests.guide.builders import (
    ARM,
    BLOCK,
    REST_RAD,
    SENSOR,
    Row,
    action,
    capture_row,
    make_live,
    point_row,
    reach_tip,
    start_row,
    state_after,
    view_of,
)
from tests.metrology.boards import BOARD as RENDERED_BOARD
from tests.metrology.boards import POSES, Look
from tests.metrology.boards import picture as board_picture

BOARD = Chessboard("board 7", "C-7", (7, 6), 10.0, 0.05, 0.05)
SEEN: dict[str, object] = {"corners": [{"name": "0,0", "u": 5.0, "v": 5.0, "residual_px": 0.1}]}
NOTHING: dict[str, object] = {"corners": []}
AT_REST = ReadingMean(REST_RAD, REST_RAD, 10, 0, 1)
CHOSEN = SelectedDatasheets(ARM, RENDERED_BOARD, SENSOR.model_copy(update={"stripe_axis": "v"}))


def touched_at(x_mm: float, y_mm: float, z_mm: float) -> Row:
    origin = tip_centres(ARM, REST_RAD[None])[0]
    return point_row("board", reach_tip(ARM, origin + [x_mm, y_mm, z_mm], REST_RAD))


def pictures(count: int, seen: dict[str, object]) -> list[Row]:
    outcome = {"outline": [], "stripe": [], "findings": [], "result": None, **seen}
    return [capture_row(outcome=outcome)] * count


def at(step: str, *rows: Row) -> CalibrationState:
    back = [] if step == "touch" else [("went_back", {"to": step})]
    return state_after(start_row("touch"), *rows, *back)


def test_a_board_is_drawn_from_its_certificate() -> None:
    setup = state_after(start_row("setup"))
    picture = view_of(setup, BOARD).picture
    assert isinstance(picture, ChoicesPicture)
    assert picture.object == BoardGeometry((7, 6), 10.0)


def test_a_board_need_not_be_touched() -> None:
    state = at("touch")
    view = view_of(state, BOARD)
    assert isinstance(view.picture, ObjectPicture)
    (face,) = view.picture.faces
    assert (face.face, face.taken, face.wanted, face.selected) == ("board", 0, WANTED, True)
    go_on = action(view, "confirm_touch")
    assert go_on.enabled
    assert go_on.primary
    assert face_names(BOARD) == ("board",)
    assert face_in_use("crest", BOARD) == "board"


def test_a_block_is_touched_after_a_board_was() -> None:
    """A point of the board that was undone leaves its face selected, which a block has not."""
    state = at("touch", ("face_selected", {"face": "board"}))
    view = view_of(state, BLOCK)
    assert isinstance(view.picture, ObjectPicture)
    assert [one.face for one in view.picture.faces if one.selected] == [face_in_use("board", BLOCK)]
    assert str(view.instruction).startswith("Touch the")


def test_touches_of_a_board_are_judged_by_the_plane_through_them() -> None:
    places = [(x, y, 0.0) for x, y, _ in suggest_board_places(BOARD)]
    good = [touched_at(*place) for place in places]
    state = at("touch", *good)
    view = view_of(state, BOARD)
    assert isinstance(view.picture, ObjectPicture)
    assert view.progress is not None
    assert str(view.progress.text) == f"{WANTED} of {WANTED} points"
    assert all(abs(one.residual_um or 0.0) < 1.0 for one in view.picture.points)
    assert not view.findings

    state = at("touch", *good, touched_at(30.0, 25.0, 1.0))
    view = view_of(state, BOARD)
    assert isinstance(view.picture, ObjectPicture)
    assert [one.outlier for one in view.picture.points] == [False] * WANTED + [True]
    assert "Point 7 is +1000 µm off the plane" in str(view.findings[0].text)
    assert any(one.name == "void_point" and one.args == {"index": 6} for one in view.actions)
    # a board that bends by half a millimetre has slipped no point
    bent = Chessboard("bent", "", (7, 6), 10.0, 0.05, 0.6)
    assert not view_of(state, bent).findings


def test_the_first_views_are_planned_and_shown() -> None:
    outlines = set()
    for taken, view in enumerate(VIEWS):
        state = at("place", *pictures(taken, SEEN))
        shown = view_of(state, BOARD, corners_detected=0)
        assert isinstance(shown.picture, CameraPicture)
        outlines.add(tuple(shown.picture.target))
        assert plan_view(state.listed) == view
        expected = str(view.words) if taken else "straight above"
        assert expected in str(shown.instruction)
        assert any(
            "laser line must cross the chessboard in at least 2" in str(one.text)
            for one in shown.findings
        )
    assert len(outlines) == len(VIEWS)
    assert plan_view(at("place", *pictures(len(VIEWS), SEEN)).listed) is None


def test_a_view_that_was_set_aside_is_asked_for_again() -> None:
    def wanted(*rows: Row) -> int | None:
        return next_view(at("place", *rows).listed)

    def aside(number: int) -> Row:
        return "pose_voided", {"number": number}

    three, all_views = pictures(3, SEEN), pictures(len(VIEWS), SEEN)
    assert wanted(*three, aside(2)) == 3
    assert wanted(*three, aside(2), *pictures(2, SEEN)) == 1
    assert wanted(*all_views, aside(2)) == 1
    again = [*all_views, aside(2), *pictures(1, SEEN)]
    assert wanted(*again) is None
    assert wanted(*again, aside(4)) == 3
    assert wanted(*again, aside(6)) == 1
    assert wanted(*three, ("retaken", {})) == 2


def test_a_planned_view_looks_as_described() -> None:
    """Tilted to the right, the camera is nearer to the board's right side, which looks larger."""
    size = (1280, 1024)

    def sides(tilt_right_deg: float, tilt_back_deg: float) -> np.ndarray:
        view = next(
            one
            for one in VIEWS
            if np.sign(one.tilt_right_deg) == tilt_right_deg
            and np.sign(one.tilt_back_deg) == tilt_back_deg
        )
        lines = np.array(first_outline(BOARD, *size, True, view))[:4].reshape(-1, 2, 2)
        return np.asarray(np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1))

    # the sides are the near, right, far and left ones
    for right, back, larger, smaller in ((1, 0, 1, 3), (-1, 0, 3, 1), (0, 1, 2, 0), (0, -1, 0, 2)):
        lengths_px = sides(right, back)
        assert lengths_px[larger] > 1.05 * lengths_px[smaller]
    straight = np.array(first_outline(BOARD, *size, True, VIEWS[0]))
    assert straight.min() >= 0
    assert straight[:, [0, 2]].max() < size[0]
    assert straight[:, [1, 3]].max() < size[1]


@pytest.mark.parametrize("corners", [(7, 6), (6, 7)])
@pytest.mark.parametrize("size", [(1280, 1024), (1024, 1280)])
@pytest.mark.parametrize("upright", [True, False])
def test_a_board_fills_the_picture_and_tilts_as_it_shows(
    corners: tuple[int, int], size: tuple[int, int], upright: bool
) -> None:
    """Whichever way the stripe runs: what is right in the picture is right."""
    board = Chessboard("board", "", corners, 10.0, 0.05, 0.05)

    def ends(view: PoseDelta) -> np.ndarray:
        return np.array(first_outline(board, *size, upright, view))[:4].reshape(-1, 2)

    wide, high = np.ptp(ends(VIEWS[0]), axis=0)
    assert (wide > high) == (size[0] > size[1])
    tilted = ends(PoseDelta(20.0, 0.0, 0.0, 0.0))
    right = tilted[tilted[:, 0] > size[0] / 2, 1]
    left = tilted[tilted[:, 0] < size[0] / 2, 1]
    assert np.ptp(right) > 1.05 * np.ptp(left)


@pytest.mark.parametrize(
    ("usable", "unusable", "more"), [(1, 0, "2 more pictures"), (2, 2, "one more picture")]
)
def test_too_few_pictures_are_not_solved(usable: int, unusable: int, more: str) -> None:
    state = at("solve", *pictures(unusable, NOTHING), *pictures(usable, SEEN))
    view = view_of(state, BOARD)
    solve = action(view, "solve")
    assert not solve.enabled
    assert more in str(solve.why_not)
    assert still_missing(3) == ""


def test_another_pose_is_asked_for_until_the_plan_is_through() -> None:
    state = at("solve", *pictures(2, SEEN))
    view = view_of(state, BOARD)
    assert str(VIEWS[2].words) in str(view.instruction)
    primary = [action.name for action in view.actions if action.primary]
    assert primary == ["another_pose"]


def test_what_was_found_in_a_refused_picture_is_drawn_and_can_be_saved() -> None:
    T = POSES[1].copy()
    T[0, 3] += 45.0  # partly out of the picture
    image = board_picture(T, Look(laser=False))
    taken = Capture(Frame(0, 0, image, 5000.0, False), None, "both", AT_REST)
    seen, refusal = detect_in_capture(taken, CHOSEN, 1)
    assert isinstance(refusal, OperationError)
    assert seen.fault == "framing"
    assert "partly out of the picture" in str(seen.findings[0].text)
    assert len(seen.marks) > 30
    state = at("solve", capture_row(outcome=to_payload(seen)), *pictures(1, SEEN))
    refused, good = pose_pictures(state, make_live(state, RENDERED_BOARD))
    assert refused.marks == seen.marks
    assert "framing" in str(refused.note)
    assert refused.bundle_url == "/api/flow/picture/1.zip?session=s1"
    assert (good.note, good.bundle_url) == ("", "")
    aside = at("touch", capture_row(outcome=to_payload(seen)), ("pose_voided", {"number": 1}))
    (gone,) = pose_pictures(aside, make_live(aside, RENDERED_BOARD))
    assert gone.bundle_url == ""


def test_a_picture_without_the_line_is_kept_and_named() -> None:
    """Of a sensor that switches its laser, and of one that does not."""
    unlit = board_picture(POSES[0], Look(laser=False))
    dark = np.random.default_rng(0).normal(3, 1, unlit.shape).clip(0, 255).astype(np.uint8)
    lit = Frame(1, 0, dark, 5000.0, True)
    captures: list[tuple[Frame | None, Lighting]] = [(None, "both"), (lit, "pair")]
    for laser, lighting in [*captures, (None, "ambient")]:
        taken = Capture(Frame(0, 0, unlit, 5000.0, False), laser, lighting, AT_REST)
        seen, pose = detect_in_capture(taken, CHOSEN, 1)
        assert isinstance(pose, BoardObservation)
        assert len(seen.corners) == 42
        (finding,) = (one for one in seen.findings if "camera and mounting" in str(one.text))
        assert not [one for one in seen.findings if one.quality == "bad"]
        assert finding.quality == "attention"
        assert "determines only camera and mounting" in str(finding.text)
        assert ("did not switch on" in str(finding.text)) == (lighting == "ambient")


def test_what_the_line_is_like_can_be_said_where_it_was_not_found() -> None:
    lined: dict[str, object] = {**SEEN, "stripe": [(1.0, 2.0)]}
    state = at("solve", *pictures(1, SEEN), *pictures(1, lined))
    form = still_picture(state).line
    assert form is not None
    assert (form.refused, form.threshold, form.action.enabled) == ((1,), None, True)
    widths = {"min_width_px": 9.0, "max_width_px": 2.0}
    reason = RULES.rejection_reason(state, make_live(state, BOARD), "set_line", widths)
    assert "must exceed" in str(reason)
    looked_again = ("looked_again", {"number": 1, "outcome": pictures(1, lined)[0][1]["outcome"]})
    found = at(
        "solve", *pictures(1, SEEN), ("line_set", {"line": {"threshold": 9.0}}), looked_again
    )
    again = still_picture(found).line
    assert again is not None
    assert (again.refused, again.threshold) == ((), 9.0)
    assert still_picture(at("solve", *pictures(1, lined))).line is None


def still_picture(state: CalibrationState) -> StillPicture:
    picture = view_of(state, BOARD).picture
    assert isinstance(picture, StillPicture)
    return picture


def test_pictures_are_listed_as_they_were_lit(tmp_path: Path) -> None:
    """Rows of earlier versions name no lighting."""
    folder = SessionFolder(tmp_path)
    arm_document(ARM).write(tmp_path / "arm.json")
    lightings = [{"lighting": lighting} for lighting in ("both", "ambient")]
    taken = [capture_row(), *(capture_row(laser=None, **one) for one in ({}, *lightings))]
    folder.keep_images(at("solve", *taken).pictures)
    rows = (tmp_path / "images.csv").read_text().splitlines()[1:]
    lit = [row.split(",")[2] for row in rows]
    assert lit == ["ambient", "laser", "both", "both", "ambient"]


def test_another_pose_is_asked_for_where_only_lines_are_missing() -> None:
    """The pictures taken serve camera and mounting: none is to be taken again."""
    taken = at("solve", *pictures(6, SEEN))
    error = {"code": "stripe-not-found", "what": "one line", "why": "two needed", "remedy": "more"}
    row: Row = ("solve_refused", {"inputs": taken.inputs, **error})
    state = at("solve", *pictures(6, SEEN), row)
    view = view_of(state, BOARD)
    assert [action.name for action in view.actions if action.primary] == ["another_pose"]
    assert [(one.quality, str(one.text)) for one in view.findings] == [
        ("attention", "One line: two needed.")
    ]
    of_block = view_of(state, BLOCK)
    assert [action.name for action in of_block.actions if action.primary] == ["retake"]


def test_the_laser_is_added_to_a_calibration_without_it() -> None:
    """Chosen in the set-up for the same devices and a board; nothing is touched then, and what was
    kept is an input of the result."""
    kept = CameraCalibration("s0", "calibration 0", "A-1", "S-1")
    setup = state_after(start_row("setup"), ("chosen", {"field": "camera", "id": "s0"}))
    shown = view_of(setup, BOARD, without_laser=kept).picture
    assert isinstance(shown, ChoicesPicture)
    choice = next(one for one in shown.choices if one.field == "camera")
    assert ([one.id for one in choice.options], choice.selected) == (["", "s0"], "s0")
    for item, known, enabled in ((BOARD, kept, True), (BLOCK, kept, False), (BOARD, None, False)):
        view = view_of(setup, item, without_laser=known)
        assert action(view, "confirm_setup").enabled is enabled
        one = make_live(setup, item, without_laser=known)
        args = {"field": "camera", "id": "s0"}
        assert (not RULES.rejection_reason(setup, one, "choose", args)) is (known is not None)
    changed = state_after(
        start_row("setup"),
        ("chosen", {"field": "camera", "id": "s0"}),
        ("chosen", {"field": "sensor", "id": "other"}),
    )
    assert "camera" not in changed.choices
    assert setup.inputs != state_after(start_row("setup")).inputs


def test_a_block_keeps_its_faces() -> None:
    assert face_names(BLOCK) == FACES
    assert face_in_use("floor", BLOCK) == "floor"
    assert asdict(BoardGeometry((7, 6), 10.0))["kind"] == "board"


ROBOT = SelectedDatasheets(RobotArm("robot", "R-1"), BOARD, SENSOR)


def test_pictures_by_themselves_are_for_a_robot_and_a_board() -> None:
    setup, place = state_after(start_row("setup")), at("place")
    for state, name in ((setup, "setup_and_poses"), (place, "take_poses")):
        live = replace(make_live(state, BOARD), arm=ConnectedArm("R-1", 6, "pose"), chosen=ROBOT)
        assert action(build_view(state, live), name).enabled
    for state in (setup, place):
        names = {one.name for one in view_of(state, BOARD).actions}
        assert not names & {"setup_and_poses", "take_poses"}
    reason = RULES.rejection_reason(place, make_live(place, BOARD), "take_poses", {})
    assert "with a robot without a tip" in str(reason)


def test_pictures_by_themselves_can_be_ended_while_they_are_taken() -> None:
    place, busy = at("place"), Busy("Pictures by themselves", 0.1)
    taking = view_of(place, BOARD, chosen=ROBOT, taking_poses=True, busy=busy)
    assert action(taking, "stop_poses").enabled
    assert not action(taking, "confirm_place").enabled
    assert not any(one.name == "take_poses" for one in taking.actions)
    live = make_live(place, BOARD, chosen=ROBOT)
    assert RULES.rejection_reason(place, live, "stop_poses", {})
