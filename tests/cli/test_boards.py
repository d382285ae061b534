"""Sessions on a chessboard on the command line: a robot's, an arm's, and recorded ones."""

import json
import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.formats.clouds.files import read_cloud
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.images import read_grey, write_png
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import CalibrationFile, read_calibration
from crenel.formats.session.calibration_session import ContactReadings, write_contacts
from crenel.formats.session.pose_pictures import ImageRow, write_images
from crenel.metrology.adjustment.planning.inverse_kinematics import solve_inverse_kinematics
from crenel.metrology.arm.kinematics import flange_pose
from crenel.metrology.arm.reported_poses import pose_from_transform
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Markers
from crenel.metrology.transforms import apply, inverse, rigid
from crenel.report.contents.reports import render_report
from tests.cli.test_cli import done, names_in, printed, refused
from tests.datasheets import write_arm, write_object
from tests.formats.builders import ARM, edit_json, edit_text
from tests.metrology.boards import (
    BOARD,
    NORMAL,
    OFFSET_MM,
    POSES,
    ROBOT,
    SIZE,
    T_FLANGE_CAM,
    TIP,
    Look,
    find_flange_pose,
    picture,
)
from tests.metrology.seen_boards import camera_at
from tests.metrology.test_board_calibration import touching
from tests.present import present
from tests.real_sessions import write_real_session
from tests.running.usual import usual

pytestmark = pytest.mark.slow

START_RAD = np.deg2rad([0.0, 20.0, 90.0, 45.0, 25.0, 5.0])
MS = 1_000_000
FEW = (1, 2, 3)
"""Pictures that just calibrate a sensor."""


@pytest.fixture(scope="module")
def pictures(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Everything of a session but the arm and where it stood."""
    folder = tmp_path_factory.mktemp("pictures")
    write_object(folder / "object.json", BOARD)
    document = {"name": "camera and laser", "serial_number": "S-7", "stripe_axis": "v"}
    document |= {"width_px": str(SIZE[0]), "height_px": str(SIZE[1])}
    SensorDatasheet.model_validate(document, strict=False).write(folder / "sensor.json")
    (folder / "images").mkdir()
    for k, T in enumerate(POSES):
        write_png(folder / f"images/{k + 1}.png", picture(T, Look(), k))
    return folder


@pytest.fixture(scope="module")
def robot_session(pictures: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Eight pictures and twelve contacts of a robot that reports its flange's pose."""
    folder = shutil.copytree(pictures, tmp_path_factory.mktemp("robot") / "session")
    write_arm(folder / "arm.json", ROBOT)
    flange = [find_flange_pose(T) for T in POSES]
    none = np.zeros(0)
    rows = [ImageRow(k, f"images/{k}.png", "both", none, T) for k, T in enumerate(flange, 1)]
    write_images(folder / "images.csv", rows)
    touched = ContactReadings(("board",) * 12, np.zeros((12, 0)), touching(12, TIP.radius_mm))
    write_contacts(folder / "probing.csv", touched)
    return folder


@pytest.fixture(scope="module")
def arm_session(pictures: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same pictures by an arm with joints; nothing was touched."""
    folder = shutil.copytree(pictures, tmp_path_factory.mktemp("arm") / "session")
    write_arm(folder / "arm.json", ARM)
    T_arm_obj = flange_pose(ARM, START_RAD) @ T_FLANGE_CAM @ POSES[0]
    rows = []
    for k, T in enumerate(POSES, 1):
        T_arm_flange = T_arm_obj @ inverse(T) @ inverse(T_FLANGE_CAM)
        q_rad = present(solve_inverse_kinematics(ARM, T_arm_flange, START_RAD))
        rows.append(ImageRow(k, f"images/{k}.png", "both", q_rad))
    write_images(folder / "images.csv", rows)
    return folder


def calibration_of(session: Path, folder: Path, *words: str) -> Path:
    """The file that ``crenel calibrate`` makes of a session, and prints these words of."""
    out = folder / "calibration.json"
    shown = done("calibrate", session, "-o", out)
    for each in words:
        assert each in shown.stdout
    return out


@pytest.fixture(scope="module")
def by_arm(arm_session: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return calibration_of(arm_session, tmp_path_factory.mktemp("by_arm"), "arm encoders")


@pytest.fixture(scope="module")
def by_robot(robot_session: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    words = ("robot's poses", "12 contact points fit the board")
    return calibration_of(robot_session, tmp_path_factory.mktemp("by_robot"), *words)


def keep_pictures(session: Path, numbers: Sequence[int]) -> None:
    """Leaves rows of ``images.csv`` out: the first has the number 1."""
    first, *rows = (session / "images.csv").read_text().splitlines()
    kept = [rows[number - 1] for number in numbers]
    (session / "images.csv").write_text("\n".join([first, *kept]) + "\n")


def test_its_report_speaks_of_corners(arm_session: Path, by_arm: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(arm_session, tmp_path / "session")
    shutil.copy(by_arm, folder / "calibration.json")
    shown = render_report(folder, ".html").decode()
    assert "Corners, rms" in shown
    assert "Corners, px" in shown
    assert "stripe red. Corners" in shown
    assert "Edges" not in shown.replace("Edges and corners", "")
    assert "Edges and corners, rms" not in shown


def test_a_robots_session_gives_the_same_file_as_any_other(by_robot: Path) -> None:
    document = CalibrationFile.read(by_robot)
    assert (document.method, document.serial_numbers.sensor) == ("joint", "S-7")
    assert [pose.number for pose in document.poses if pose.used] == list(range(1, 9))
    assert (len(document.poses[0].corners_px), len(document.corners_mm)) == (42, 42)
    assert {one.file for one in document.inputs} >= {"probing.csv", "images/8.png"}
    assert document.uncertainty is not None
    assert document.uncertainty.map is not None
    assert document.uncertainty.plane is not None
    assert document.residuals is not None
    assert len(document.residuals.contacts_um) == 12
    assert {point.kind for point in document.residuals.worst} == {"contact", "corner", "stripe"}
    assert document.covariance is not None
    assert document.verdict is not None
    assert "uncertainty" in {finding.code for finding in document.verdict.findings}
    assert camera_off_mm(by_robot) < 0.2


def camera_off_mm(calibration: Path) -> float:
    known = read_calibration(calibration)
    T_cam_sensor = rigid(known.camera.rotation, known.camera.translation_mm)
    found = known.T_flange_sensor @ inverse(T_cam_sensor)
    return float(np.linalg.norm((found - T_FLANGE_CAM)[:3, 3]))


def test_a_charuco_board_calibrates_if_cut_off_and_covered(spoilt: Path, tmp_path: Path) -> None:
    """From the files alone: as a chessboard, and each corner under its own number."""
    marked = replace(BOARD, markers=Markers("DICT_4X4_50", 7.5))
    write_object(spoilt / "object.json", marked)
    keep_pictures(spoilt, range(1, 7))
    for k, T in enumerate(POSES[:6]):
        image = picture(T, Look(board=marked), k)
        if k == 1:
            image[:, :230] = 60  # a hand
        write_png(spoilt / f"images/{k + 1}.png", image)
    seen = ("detect", spoilt / "images/2.png", "--object", spoilt / "object.json")
    (shown,) = printed(*seen, "--laser", "v", "--draw", tmp_path / "drawn")["images"]
    assert 8 <= len(shown["corners"]) < 42
    assert (tmp_path / "drawn" / "2.png").exists()
    out = calibration_of(spoilt, tmp_path)
    document = CalibrationFile.read(out)
    assert [pose.number for pose in document.poses if pose.used] == list(range(1, 7))
    assert camera_off_mm(out) < 0.2


def test_one_pose_is_refused_on_a_board(robot_session: Path, tmp_path: Path) -> None:
    out = tmp_path / "c.json"
    said = refused("calibrate", robot_session, "-o", out, "--method", "one-pose")
    assert "one pose is not sufficient on rendered board" in said
    assert "--method joint" in said
    assert names_in(tmp_path) == []


@pytest.mark.parametrize("reports", ["joints", "pose"])
def test_a_scan_is_reconstructed_with_its_arm(
    by_arm: Path,
    by_robot: Path,
    arm_session: Path,
    robot_session: Path,
    tmp_path: Path,
    reports: str,
) -> None:
    """By the joints of an arm, or by the poses that a robot reports."""
    names = tuple(joint.name for joint in ARM.joints) if reports == "joints" else None
    reading = START_RAD if names else pose_from_transform(flange_pose(ARM, START_RAD))
    calibration, session = (by_arm, arm_session) if names else (by_robot, robot_session)
    v = np.linspace(40.0, 470.0, 60)
    u = 320 + 0.1 * (v - 256)
    uv = np.column_stack([u, v])
    stripe = Stripe(u, v, np.full(60, 90.0), np.full(60, 0.05), "v")
    with RecordingWriter(tmp_path / "scan.mcap", names) as writer:
        for stamp in range(0, 100 * MS, 4 * MS):
            writer.reading(stamp, reading)
        writer.stripe(50 * MS, stripe, *SIZE)
    cloud, arm = tmp_path / "cloud.ply", session / "arm.json"
    given = ("--calibration", calibration, "--arm", arm)
    done("reconstruct", tmp_path / "scan.mcap", *given, "-o", cloud)
    in_cam = sensor_points(camera_at(np.eye(4)), LaserPlane(NORMAL, OFFSET_MM), uv)
    true = apply(flange_pose(ARM, START_RAD) @ T_FLANGE_CAM, in_cam)
    claimed = present(CalibrationFile.read(calibration).uncertainty)
    off_um = 1e3 * np.linalg.norm(read_cloud(cloud).points_mm - true, axis=1)
    assert float(np.sqrt(np.mean(off_um**2))) < max(3 * claimed.total_um, 100)


def test_a_robot_takes_no_scan_by_joints(robot_session: Path, by_arm: Path, tmp_path: Path) -> None:
    with RecordingWriter(tmp_path / "scan.mcap", tuple(one.name for one in ARM.joints)) as writer:
        writer.joints(0, START_RAD)
    arguments = (tmp_path / "scan.mcap", "--calibration", by_arm)
    said = refused("reconstruct", *arguments, "--arm", robot_session / "arm.json")
    assert "give" in said.lower()


@pytest.fixture
def spoilt(robot_session: Path, tmp_path: Path) -> Path:
    return shutil.copytree(robot_session, tmp_path / "session")


@pytest.fixture
def few(spoilt: Path) -> Path:
    keep_pictures(spoilt, FEW)
    return spoilt


def findings_of(session: Path, *more: str) -> dict[str, str]:
    shown = printed("calibrate", session, "-o", session / "c.json", *more)
    findings = shown["verdict"]["findings"]
    return {one["code"]: f"{one['quality']}: {one['text']} {one['remedy']}" for one in findings}


def why_refused(session: Path) -> str:
    said = refused("calibrate", session, "-o", session / "c.json")
    assert not (session / "c.json").exists()
    return said


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"inner_corners": [8, 6]}, "7 × 6 inner corners was found: rendered board has 8 × 6"),
        ({"square_mm": 0.01}, "is it in metres?"),
    ],
)
def test_another_certificate_is_refused(
    spoilt: Path, fields: dict[str, object], words: str
) -> None:
    keep_pictures(spoilt, (1,))
    edit_json(spoilt / "object.json", lambda document: document.update(fields))
    assert words in why_refused(spoilt)


def test_limits_of_the_user_decide(few: Path) -> None:
    """By the usual ones, so few pictures are not good."""
    easy = ("--good-um", "1000", "--usable-um", "2000")
    assert findings_of(few, *easy)["uncertainty"].startswith("good: ")


def test_bad_pictures_are_left_out_and_named_unless_all_are(spoilt: Path) -> None:
    """A file cut off, one that is missing, one that is no picture, a picture of nothing, and one
    of another size; the rest calibrates."""
    images = spoilt / "images"
    whole = (images / "2.png").read_bytes()
    (images / "2.png").write_bytes(whole[: len(whole) // 2])
    (images / "4.png").unlink()
    (images / "5.png").write_text("no picture")
    write_png(images / "6.png", np.zeros(SIZE[::-1], np.uint8))
    write_png(images / "7.png", np.zeros((100, 100), np.uint8))
    shown = printed("calibrate", spoilt, "-o", spoilt / "c.json")
    poses = {pose["number"]: pose for pose in shown["poses"]}
    said = {number: pose["reason"] for number, pose in poses.items() if not pose["used"]}
    expected = {2: "2.png", 4: "4.png: there is no such file", 5: "5.png"}
    expected |= {6: "No chessboard of 7 × 6", 7: "100 × 100"}
    assert said.keys() == expected.keys()
    assert all(words in said[number] for number, words in expected.items()), said
    files = [one["file"] for one in json.loads((spoilt / "c.json").read_text())["inputs"]]
    assert "images/1.png" in files
    assert "images/4.png" not in files
    for path in images.iterdir():
        path.unlink()
    refusal = refused("calibrate", spoilt, "-o", spoilt / "c.json")
    assert "images.csv line 2" in refusal
    assert "Restore the picture" in refusal


def test_laser_pictures_may_be_missing_or_damaged(spoilt: Path) -> None:
    """The pose then serves camera and mounting."""
    rows = []
    for k, T in enumerate(POSES[:5]):
        off, on = f"images/{k + 1}off.png", f"images/{k + 1}on.png"
        write_png(spoilt / off, picture(T, Look(laser=False), k))
        write_png(spoilt / on, picture(T, Look(dark=4.0, bright=6.0), k))
        flange = find_flange_pose(T)
        rows.append(ImageRow(k + 1, off, "ambient", np.zeros(0), flange))
        if k != 3:
            rows.append(ImageRow(k + 1, on, "laser", np.zeros(0), flange))
    write_images(spoilt / "images.csv", rows)
    (spoilt / "images/5on.png").write_text("no picture")
    document = printed("calibrate", spoilt, "-o", spoilt / "c.json")
    poses = {pose["number"]: pose for pose in document["poses"]}
    assert all(pose["used"] for pose in poses.values())
    assert poses[4]["stripe_points"] == poses[5]["stripe_points"] == 0
    assert poses[1]["stripe_points"] > 100
    (named,) = (one for one in document["verdict"]["findings"] if one["code"] == "laser-picture")
    assert named["quality"] == "attention"
    assert named["text"].startswith("Pose 5: ")
    assert "5on.png" in named["text"]


def test_camera_and_mounting_alone(few: Path, tmp_path: Path) -> None:
    """Where the laser was off, or the option says so; what needs the plane says what to do."""
    said = findings_of(few, "--without-laser")["no-laser-plane"]
    assert "nothing can be scanned" in said
    table = few / "images.csv"
    lit = table.read_text()
    table.write_text(lit.replace("both", "ambient"))
    assert findings_of(few)["no-laser-plane"] == said
    file = few / "c.json"
    document = CalibrationFile.read(file)
    assert document.laser_plane is None
    assert np.array(document.probe_matrix)[:3, 3] == pytest.approx(
        (T_FLANGE_CAM @ POSES[0])[:3, 3], abs=5.0
    )
    shutil.copy(file, few / "calibration.json")
    assert "none yet" in render_report(few, ".html").decode()
    scan = tmp_path / "scan.mcap"
    scan.write_bytes(b"")
    arm = few / "arm.json"
    lacks = refused("reconstruct", scan, "--calibration", file, "--arm", arm, "-o", "c.ply")
    assert "no laser plane yet. Take pictures" in lacks
    added = refused("calibrate", few, "--camera-from", file, "-o", few / "d.json")
    assert "the laser was off in all pictures" in added
    table.write_text(lit)
    whole = printed("calibrate", few, "--camera-from", file, "-o", few / "d.json")
    kept, own = (
        np.array(one["camera"]["projection_matrix"])
        for one in (whole, json.loads(file.read_text()))
    )
    np.testing.assert_allclose(kept, own, rtol=1e-9)
    assert whole["camera_from"]["file"] == "c.json"
    assert whole["laser_plane"]["normal"]


def test_the_same_picture_counts_once(few: Path) -> None:
    first, *rows = (few / "images.csv").read_text().splitlines()
    again = [f"{k + 4},{row.partition(',')[2]}" for k, row in enumerate(rows)]
    (few / "images.csv").write_text("\n".join([first, *rows, *again]) + "\n")
    assert "poses 4, 5, 6 are those of other poses" in findings_of(few)["picture-twice"]


def test_mirrored_pictures_are_refused_as_such(few: Path) -> None:
    for path in (few / "images").glob("*.png"):
        picture = present(cv2.imread(str(path), cv2.IMREAD_UNCHANGED))
        cv2.imwrite(str(path), picture[:, ::-1])
    assert "check that the pictures are not mirrored" in why_refused(few).replace("Check", "check")


def test_poses_in_metres_are_refused(few: Path) -> None:
    first, *rows = (few / "images.csv").read_text().splitlines()
    cells = [row.split(",") for row in rows]
    for row in cells:
        row[3:6] = [str(float(cell) / 1000) for cell in row[3:6]]
    metres = [",".join(row) for row in cells]
    (few / "images.csv").write_text("\n".join([first, *metres]) + "\n")
    assert "metres, but millimetres" in why_refused(few)


def test_touches_without_a_tip_are_refused(few: Path) -> None:
    edit_json(few / "arm.json", lambda document: document.pop("tip"))
    assert "12 contact points, but the arm robot has no tip" in why_refused(few)


def test_touches_of_another_feature_are_refused(spoilt: Path) -> None:
    edit_text(spoilt / "probing.csv", "board", "crest")
    assert "feature 'crest': the faces are board" in why_refused(spoilt)


def test_a_recording_with_bad_pictures_calibrates_from_the_rest(real: Path, tmp_path: Path) -> None:
    """Blurred, dark and half of the board; named, and nearly as good without them."""
    session = write_real_session(real / "robot-laser-chessboard" / "calib3", tmp_path / "session")
    keep_pictures(session, range(1, 11))
    bad = sorted((session / "images").glob("*.png"))[1:8:3]
    blurred, dark, half = (read_grey(path) for path in bad)
    half[:, half.shape[1] // 2 :] = half[:, :1]
    spoilt = (cv2.GaussianBlur(blurred, (0, 0), 30), dark // 40, half)
    for path, image in zip(bad, spoilt, strict=True):
        write_png(path, np.asarray(image, np.uint8))
    document = CalibrationFile.read(calibration_of(session, tmp_path))
    left_out = [pose for pose in document.poses if not pose.used]
    assert {pose.number for pose in left_out} == {int(path.stem[5:]) for path in bad}
    assert all(pose.reason for pose in left_out)
    used = [pose.off_um for pose in document.poses if pose.used]
    assert np.sqrt(np.mean(np.square(used))) < 500


@pytest.mark.parametrize(
    ("name", "scatter_mm"), usual([("calib1", 0.3), ("calib3", 0.5)], 1, pytest.mark.soak)
)
def test_recorded_pictures(real: Path, tmp_path: Path, name: str, scatter_mm: float) -> None:
    """A real robot's recordings: the poses agree on the board's place. In the first, the laser had
    not come to rest."""
    session = write_real_session(real / "robot-laser-chessboard" / name, tmp_path / "session")
    shown = done("calibrate", session, "-o", tmp_path / "calibration.json")
    document = CalibrationFile.read(tmp_path / "calibration.json")
    assert all(pose.used for pose in document.poses)
    assert max(pose.edges_rms_px for pose in document.poses) < 0.3
    assert np.sqrt(np.mean([pose.off_um**2 for pose in document.poses])) < 1e3 * scatter_mm
    assert 2345 < document.camera.matrix[0][0] < 2365
    assert document.verdict is not None
    said = [(one.code, str(one.text)) for one in document.verdict.findings]
    moved = [text for code, text in said if code == "laser-moved"]
    assert ["poses 1, 2 lie" in text for text in moved] == [True] * (name == "calib1")
    assert ("board-rocks" in dict(said)) == (name == "calib1")
    assert "more pictures" in shown.stdout or "Let the laser settle" in shown.stdout


def test_lines_along_the_other_axis_are_no_laser_that_moved(real: Path, tmp_path: Path) -> None:
    session = write_real_session(real / "robot-laser-chessboard" / "calib1", tmp_path / "session")
    keep_pictures(session, range(1, 5))  # which are enough for "laser-moved" by their own axis
    edit_json(session / "sensor.json", lambda document: document.update(stripe_axis="u"))
    found = findings_of(session)
    assert "Set stripe_axis to v" in found["stripe-axis"]
    assert "laser-moved" not in found
