"""From a session's folder to the result that is shown, on sessions that the simulation renders."""

import json
import shutil
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.images import read_grey, write_png
from crenel.formats.results.calibration_builder import joint_document
from crenel.formats.session.calibration_session import read_session
from crenel.guide.calibration.comparison import compare
from crenel.guide.calibration.live import SelectedDatasheets
from crenel.guide.calibration.outcome import CalibrationOutcome
from crenel.guide.calibration.poses.detection import detect_in_capture
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.guide.calibration.solve import solve
from crenel.guide.common.result_view import Comparison
from crenel.messages.message import Text
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.metrology.adjustment.core.observations import BlockObservation
from crenel.metrology.limits import LIMITS
from crenel.station.devices.capture import Capture
from crenel.station.devices.reading_buffer import ReadingMean
from crenel.workflows.calibrate import calibration_origin, joint_inputs
from crenel_hardware.interfaces import Frame
from crenel_hardware.simulator.session import SessionPlan, render_session
from tests.present import present

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class InUse:
    """A calibration that was accepted before."""

    name: str
    file: Path
    id: str = "c1"
    accepted_at: str = "2026-01-01T00:00:00Z"


def quiet(text: Text, share: float) -> None:
    assert text
    assert 0 <= share <= 1


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> SessionFolder:
    path = tmp_path_factory.mktemp("session")
    render_session(path, 11, SessionPlan(contacts_per_face=9))
    return SessionFolder(path)


@pytest.fixture(scope="module")
def first(folder: SessionFolder) -> CalibrationOutcome:
    return solve(folder, None, quiet, {}, LIMITS, range(100, 145))


def test_a_session_is_solved_as_it_is_shown(first: CalibrationOutcome) -> None:
    assert first.result is not None
    assert first.result.verdict == "good"
    assert first.result.comparison is None
    assert first.result.worst
    total_um = np.linalg.norm([row.value_um for row in first.result.budget])
    assert first.result.total_um == pytest.approx(total_um)
    assert (first.result.good_um, first.result.usable_um) == (LIMITS.good_um, LIMITS.usable_um)
    (pose,) = first.poses
    assert pose.number == first.result.shown_pose
    assert len(pose.corners) >= 8
    assert all(corner.residual_px is not None for corner in pose.corners)
    assert pose.outline
    assert 50 < len(pose.stripe) <= 300


def test_what_is_graver_than_uncertainty_is_said(folder: SessionFolder, tmp_path: Path) -> None:
    shutil.copytree(folder.path, tmp_path / "slipped")
    probing = tmp_path / "slipped" / "probing.csv"
    head, *rows = probing.read_text().splitlines()
    joint, cells = head.split(",").index("q2_deg"), rows[3].split(",")
    cells[joint] = str(float(cells[joint]) + 0.05)
    rows[3] = ",".join(cells)
    probing.write_text("\n".join([head, *rows]) + "\n")
    solved = solve(SessionFolder(tmp_path / "slipped"), None, quiet, {}, LIMITS, range(45))
    assert solved.result is not None
    assert solved.result.verdict == "attention"
    assert "1 of 27 contact points contradicts" in str(solved.findings[0].text)
    texts = [str(one.text) for one in solved.findings]
    (known,) = (text for text in texts if text.startswith("Standard uncertainty of a"))
    assert str(solved.result.verdict_text).startswith(known)
    assert str(solved.result.verdict_text).endswith("the items marked below need attention.")


def test_the_worst_points_have_their_place(first: CalibrationOutcome) -> None:
    """Contacts by the touched point's own index, the others in the picture of their pose."""
    (pose,) = first.poses
    corners = {(corner.u, corner.v) for corner in pose.corners}
    along = {round(u) for u, _ in pose.stripe}
    for point in present(first.result).worst:
        if point.kind == "contact":
            assert point.point is not None
            assert str(point.name).endswith(f", point {point.point + 1}")
            assert point.point >= 100
        else:
            assert point.pose == pose.number
            assert point.at_px is not None
            on_stripe = min(along) <= point.at_px[0] <= max(along)
            assert point.at_px in corners if point.kind == "corner" else on_stripe


def test_it_is_compared_with_the_calibration_in_use(folder: SessionFolder, tmp_path: Path) -> None:
    session = read_session(folder.path)
    result = calibrate_block(joint_inputs(session))
    document = joint_document(result, calibration_origin(session, session.poses, ""))
    volume_px = result.uncertainty.volume.uv_px
    in_use = InUse("the first", tmp_path / "calibration.json")

    def compared(**changes: object) -> Comparison | None:
        changed = {**json.loads(document.model_dump_json()), **changes}
        in_use.file.write_text(json.dumps({"format": "crenel/calibration", "version": 1} | changed))
        return compare(document, volume_px, in_use)

    same = present(compared())
    assert same.with_name == "the first"
    assert same.max_um == pytest.approx(0.0, abs=1e-6)
    assert len(same.map) > 20
    moved = np.array(document.probe_matrix)
    moved[2, 3] += 0.1
    shifted = present(compared(probe_matrix=moved.tolist()))
    assert shifted.rms_um == pytest.approx(100.0, rel=1e-6)
    assert shifted.max_um == pytest.approx(100.0, rel=1e-6)
    assert {point.moved_um for point in shifted.map} == {100.0}
    turned = np.array(document.probe_matrix)
    turned[:3, :3] @= cv2.Rodrigues(np.array([0.0, 0.0, 1e-3]))[0]
    tilted = present(compared(probe_matrix=turned.tolist()))
    drawn = zip(tilted.map, present(result.uncertainty.map).calibrated, strict=True)
    assert tilted.max_um > max(point.moved_um for point, inside in drawn if inside) - 0.01
    other = {"arm": "A", "object": "B", "sensor": "another"}
    assert compared(serial_numbers=other) is None
    in_use.file.write_text("damaged")
    assert compare(document, volume_px, in_use) is None
    assert compare(document, volume_px, None) is None


def test_a_refused_solve_leaves_no_calibration_of_before(tmp_path: Path) -> None:
    render_session(tmp_path, 12, SessionPlan(contacts_per_face=5, width_px=640, height_px=512))
    folder = SessionFolder(tmp_path)
    folder.calibration.write_text("of before")
    session = read_session(tmp_path)
    black = np.zeros((512, 640), np.uint8)
    write_png(session.poses[0].ambient, black)
    with pytest.raises(OperationError) as caught:
        solve(folder, None, quiet, {}, LIMITS, range(45))
    assert caught.value.code == "image-dark"
    assert caught.value.remedy
    assert not folder.calibration.exists()


def capture_of(folder: SessionFolder, ambient: np.ndarray) -> tuple[Capture, SelectedDatasheets]:
    session = read_session(folder.path)
    pose = session.poses[0]
    assert pose.laser is not None
    dark = Frame(0, 0, ambient, 5000.0, False)
    lit = Frame(1, 0, read_grey(pose.laser), 5000.0, True)
    mean = ReadingMean(pose.q_rad, pose.q_rad * 0, 10, 0, 1)
    chosen = SelectedDatasheets(session.arm, session.block, session.sensor)
    return Capture(dark, lit, "pair", mean), chosen


def test_a_fresh_picture_is_looked_at_at_once(folder: SessionFolder) -> None:
    ambient = read_grey(read_session(folder.path).poses[0].ambient)
    seen, pose = detect_in_capture(*capture_of(folder, ambient), 3)
    assert isinstance(pose, BlockObservation)
    assert pose.number == 3
    assert len(seen.corners) >= 8
    assert seen.stripe
    assert not [finding for finding in seen.findings if finding.quality == "bad"]
    seen, unseen = detect_in_capture(*capture_of(folder, np.zeros_like(ambient)), 4)
    assert isinstance(unseen, OperationError)
    assert seen.corners == ()
    assert seen.findings[0].quality == "bad"
    assert str(seen.findings[0].remedy).endswith(".")
    assert seen.fault == "exposure"
    assert "Exposure is at fault." in str(seen.findings[0].text)
