"""Pictures and poses of others become a recording."""

import json
import re
from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.csv_table import table_text
from crenel.formats.images import read_grey, write_png
from crenel.formats.session.flange_columns import COLUMNS, pose_cells
from crenel.formats.session.pose_columns import joint_columns
from crenel.formats.session.scan_folder import read_scan_folder
from crenel.formats.settings.line_settings import LineSettings
from crenel.metrology.arm.kinematics import AnyArm, RobotArm, flange_pose
from crenel.metrology.fitting.plane_sphere import fit_plane
from crenel.metrology.stripe import StripeSettings
from crenel.metrology.time_delay.course import DelayCourse
from crenel.metrology.transforms import Floats
from crenel.workflows.pictures.import_pictures import ImportedScan, import_pictures
from crenel.workflows.reconstruct import Reconstruction, reconstruct_cloud
from tests.cli.test_cli import crenel, refused
from tests.datasheets import write_arm
from tests.formats.builders import (
    ARM,
    HEIGHT,
    SENSOR,
    WIDTH,
    edit_text,
    lit_picture,
    little_calibration,
    q_at,
)
from tests.real_sessions import write_real_session
from tests.refusals import refused_as
from tests.workflows.test_reconstruct import MS, expected

STAMPS_NS = [int(t * MS) for t in (100, 140, 180, 220, 260)]
ROBOT = RobotArm("robot", "A-1")
PICTURES = 7
"""Of the real robot's sixteen: enough for a calibration."""
TOLERANCE_MM = 0.05
"""A tenth of a pixel, at the little camera's 200 px focal length and 100 mm."""


def arm_cells(arm: AnyArm, stamp_ns: int) -> list[float]:
    if arm is ARM:
        return [float(angle) for angle in np.rad2deg(q_at(stamp_ns))]
    return [*pose_cells(flange_pose(ARM, q_at(stamp_ns)))]


def write_scan(folder: Path, arm: AnyArm = ARM, timed: bool = True, apart: bool = False) -> Path:
    """A folder of pictures, with the arm's readings in their rows or apart."""
    (folder / "images").mkdir(parents=True)
    write_arm(folder / "arm.json", arm)
    (folder / "sensor.json").write_text(json.dumps(SENSOR))
    columns = joint_columns(6) if arm is ARM else COLUMNS
    rows: list[Sequence[str | float]] = []
    for number, stamp_ns in enumerate(STAMPS_NS):
        file = f"images/{number}.png"
        write_png(folder / file, lit_picture(number))
        time_s = [stamp_ns / 1e9] if timed else []
        rows.append([file, *time_s, *([] if apart else arm_cells(arm, stamp_ns))])
    head = ("file", *(["time_s"] if timed else []), *([] if apart else columns))
    (folder / "images.csv").write_text(table_text(head, rows))
    if apart:
        times_ns = range(0, 400 * MS, 4 * MS)
        readings = [[t / 1e9, *arm_cells(arm, t)] for t in times_ns]
        (folder / "readings.csv").write_text(table_text(("time_s", *columns), readings))
    return folder


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write_scan(tmp_path / "scan")


def imported(folder: Path, settings: StripeSettings | None = None) -> ImportedScan:
    scan, out = read_scan_folder(folder), folder / "scan.mcap"
    return import_pictures(scan, out, "Bracket", LineSettings(settings or StripeSettings()))


def import_refused(folder: Path) -> str:
    return refused("import", folder, "-o", folder.parent / "scan.mcap")


def rebuilt(
    folder: Path, arm: AnyArm = ARM, delay: DelayCourse | None = None
) -> tuple[Reconstruction, Floats]:
    recording, cloud = folder / "scan.mcap", folder / "cloud.ply"
    result = reconstruct_cloud(recording, little_calibration(), arm, cloud, delay=delay)
    return result, read_cloud(cloud).points_mm


def distances_mm(points: Floats, stamps_ns: Sequence[int]) -> Floats:
    """Of each point from the lines that were drawn."""
    off = []
    for line in (expected([stamp_ns]) for stamp_ns in stamps_ns):
        along = (line[-1] - line[0]) / np.linalg.norm(line[-1] - line[0])
        from_first = points - line[0]
        off.append(np.linalg.norm(from_first - np.outer(from_first @ along, along), axis=1))
    return np.asarray(np.min(off, axis=0))


@pytest.mark.parametrize("arm", [ARM, ROBOT], ids=["joints", "poses"])
@pytest.mark.parametrize(("timed", "apart"), [(False, False), (True, False), (True, True)])
def test_pictures_become_the_cloud(tmp_path: Path, arm: AnyArm, timed: bool, apart: bool) -> None:
    folder = write_scan(tmp_path / "scan", arm, timed, apart)
    result = imported(folder)
    assert (result.frames, result.without_line, result.unreadable) == (5, [], [])
    again, points = rebuilt(folder, arm)
    assert (again.points, again.frames, again.warnings) == (result.points, 5, ())
    assert result.points > 5 * 30
    assert distances_mm(points, STAMPS_NS).max() < TOLERANCE_MM
    for stamp_ns in STAMPS_NS:  # each of them was at another place
        assert (distances_mm(points, [stamp_ns]) < TOLERANCE_MM).sum() < result.points / 2


def test_a_delay_counts_where_the_readings_have_times(tmp_path: Path) -> None:
    folder = write_scan(tmp_path / "scan", apart=True)
    imported(folder)
    _, points = rebuilt(folder, delay=DelayCourse(20 * MS))
    assert distances_mm(points, [t + 20 * MS for t in STAMPS_NS]).max() < TOLERANCE_MM


def test_poses_of_pictures_without_times_are_never_mixed(tmp_path: Path) -> None:
    folder = write_scan(tmp_path / "scan", timed=False)
    imported(folder)
    with pytest.raises(OperationError, match="no arm readings"):
        rebuilt(folder, delay=DelayCourse(20 * MS))


def test_rows_may_be_in_any_order_and_without_the_laser(folder: Path) -> None:
    head, *rows = (folder / "images.csv").read_text().splitlines()
    lights = ["laser", "ambient", "both", "ambient", "laser"]
    lit = [f"{row},{light}" for row, light in zip(rows, lights, strict=True)]
    (folder / "images.csv").write_text("\n".join([f"{head},lighting", *reversed(lit)]))
    assert imported(folder).frames == 3
    _, points = rebuilt(folder)
    assert distances_mm(points, STAMPS_NS[::2]).max() < TOLERANCE_MM


def test_pictures_that_cannot_be_read_or_are_dark_are_named(folder: Path) -> None:
    (folder / "images/0.png").unlink()
    (folder / "images/1.png").write_bytes(b"no picture")
    write_png(folder / "images/2.png", np.zeros((HEIGHT, WIDTH), np.uint8))
    write_png(folder / "images/3.png", np.zeros((HEIGHT, WIDTH - 1), np.uint8))
    result = imported(folder)
    for name in "013":
        assert any(f"{name}.png" in error.line for error in result.unreadable)
    (dark,) = result.without_line
    assert "2.png" in dark.line
    again, points = rebuilt(folder)
    assert (again.frames, again.frames_without_stripe) == (1, 1)
    assert distances_mm(points, STAMPS_NS[-1:]).max() < TOLERANCE_MM


def test_the_recording_says_how_the_stripes_were_extracted(folder: Path) -> None:
    imported(folder, StripeSettings(smoothing_px=1.0))
    again, _ = rebuilt(folder)
    assert any("smoothed along the laser line by 1 px" in str(one) for one in again.warnings)


def test_frames_in_gaps_of_the_readings_are_counted(tmp_path: Path) -> None:
    folder = write_scan(tmp_path / "scan", ROBOT, apart=True)
    head, *rows = (folder / "readings.csv").read_text().splitlines()
    kept = [row for row in rows if not 0.13 < float(row.split(",")[0]) < 0.19]
    (folder / "readings.csv").write_text("\n".join([head, *kept]))
    result = imported(folder)
    assert (result.frames, result.without_pose) == (5, 2)
    with refused_as("scan-incomplete"):
        rebuilt(folder, ROBOT)
    shown = crenel("import", folder, "-o", tmp_path / "scan.mcap")
    assert shown.exit_code == 3
    assert "2 frames give no points" in shown.stderr
    assert "incomplete: 2 of 5 pictures" in shown.stderr


def test_readings_in_milliseconds_are_refused(tmp_path: Path) -> None:
    folder = write_scan(tmp_path / "scan", ROBOT, apart=True)
    head, *rows = (folder / "readings.csv").read_text().splitlines()
    cells = [row.split(",", 1) for row in rows]
    late = [f"{1000 * float(time)},{rest}" for time, rest in cells]
    (folder / "readings.csv").write_text("\n".join([head, *late]))
    said = import_refused(folder)
    assert "the readings are 4.000 s apart on average" in said
    assert not (tmp_path / "scan.mcap").exists()


def test_pictures_without_times_have_no_duration(tmp_path: Path) -> None:
    folder = write_scan(tmp_path / "scan", timed=False)
    shown = crenel("import", folder, "-o", tmp_path / "scan.mcap")
    assert re.search(r"from the first to the last +no times", shown.stdout)


def test_pictures_that_cannot_be_used_are_not_said_to_be_without_a_line(folder: Path) -> None:
    for file in (folder / "images").iterdir():
        file.write_bytes(b"no picture")
    assert "none of the 5 pictures can be used" in import_refused(folder)


def test_the_lasers_colour_is_found_in_colour_pictures(folder: Path) -> None:
    for file in (folder / "images").iterdir():
        grey = read_grey(file)
        cv2.imwrite(str(file), np.dstack([grey // 8, grey // 8, grey]))
    result = imported(folder)
    assert (result.frames, len(result.without_line)) == (5, 0)


def test_folders_may_be_separated_as_windows_does(folder: Path) -> None:
    table = folder / "images.csv"
    table.write_text(table.read_text().replace("images/", "images\\"))
    assert imported(folder).frames == 5
    table.write_text(table.read_text().replace("images\\", "C:\\cell\\images\\"))
    assert "must be inside its folder" in import_refused(folder)


SPOILT = {
    "time-twice": ("images.csv", "1.png,0.14", "1.png,0.1", "line 3 has the same time_s as line 2"),
    "no-number": ("images.csv", "1.png,0.14", "1.png,soon", "column time_s is 'soon'"),
    "milliseconds": ("images.csv", "1.png,", "1.png,1780000000000", "Give the times in seconds"),
    "outside": ("images.csv", "images/1.png", "../1.png", "must be inside its folder"),
    "untimed": ("images.csv", "time_s", "seconds", "no column time_s"),
    "radians": ("readings.csv", "q1_deg", "q1_rad", "degrees"),
}


@pytest.mark.parametrize(("file", "old", "new", "words"), SPOILT.values(), ids=SPOILT)
def test_odd_tables_are_refused(tmp_path: Path, file: str, old: str, new: str, words: str) -> None:
    folder = write_scan(tmp_path / "scan", apart=True)
    edit_text(folder / file, old, new)
    assert words in import_refused(folder)
    assert not (tmp_path / "scan.mcap").exists()


def test_pictures_and_readings_of_two_clocks_are_refused(tmp_path: Path) -> None:
    folder = write_scan(tmp_path / "scan", apart=True)
    rows = (folder / "images.csv").read_text().replace("png,0.", "png,5000.")
    (folder / "images.csv").write_text(rows)
    said = import_refused(folder)
    assert "from 0.000 s to 0.396 s: the pictures begin at 5000.100 s" in said
    assert "one clock" in said


def test_without_any_line_nothing_is_written(folder: Path, tmp_path: Path) -> None:
    for file in (folder / "images").iterdir():
        write_png(file, np.zeros((HEIGHT, WIDTH), np.uint8))
    (tmp_path / "scan.mcap").write_bytes(b"the scan before")
    said = import_refused(folder)
    assert "none of the 5 pictures shows a line" in said
    assert "Switch on the laser" in said
    assert [path.name for path in tmp_path.glob("*.mcap")] == ["scan.mcap"]
    assert (tmp_path / "scan.mcap").read_bytes() == b"the scan before"


@pytest.mark.slow
def test_a_real_robots_pictures_become_a_cloud_of_the_paper(real: Path, tmp_path: Path) -> None:
    """Of all points, also those beside the pattern, where the paper bends."""
    folder = write_real_session(real / "robot-laser-chessboard" / "calib3", tmp_path / "session")
    rows = (folder / "images.csv").read_text().splitlines()
    (folder / "images.csv").write_text("\n".join(rows[: 1 + PICTURES]) + "\n")
    calibration, recording = tmp_path / "calibration.json", tmp_path / "scan.mcap"
    assert crenel("calibrate", folder, "-o", calibration).exit_code == 0
    shown = crenel("import", folder, "-o", recording)
    assert shown.exit_code == 0, shown.output
    assert f"{PICTURES} with a line, 0 without" in shown.stdout
    cloud = tmp_path / "cloud.ply"
    arm = ("--calibration", calibration, "--arm", folder / "arm.json")
    assert crenel("reconstruct", recording, *arm, "-o", cloud).exit_code == 0
    points = read_cloud(cloud).points_mm
    plane = fit_plane(points)
    off = np.abs(points @ plane.normal - plane.offset_mm)
    assert 1.4826 * np.median(off) < 0.5


def test_lines_along_the_other_axis_are_named(folder: Path) -> None:
    """A line that runs down the picture: in another picture, and a piece of it along the axis."""
    down = np.pad(lit_picture(0).T[:, :HEIGHT], ((0, 0), (8, 8)), mode="edge")[:HEIGHT]
    write_png(folder / "images/0.png", np.ascontiguousarray(down))
    result = imported(folder)
    assert result.along_other_axis == 1
    assert all("Set stripe_axis to v in sensor.json" in one.line for one in result.without_line)
