"""Tables: ``coordinates.csv`` read, identified with its frames and markers, refused; CSV texts."""

import csv
import io
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.formats.csv_table import parse_table, table_text
from crenel.formats.datasheets.arm import ArmFile, arm_document, read_arm
from crenel.formats.session.arm_session import read_observations
from crenel.formats.session.coordinates_table import (
    COORDINATES,
    parse_coordinates,
    read_coordinates,
)
from crenel.formats.session.pose_columns import joint_columns
from crenel.metrology.arm.kinematics import Arm
from crenel.workflows.identify_arm import identification_summary, identify_folder
from tests.present import present
from tests.refusals import refused_as
from tests.simulated_robots import Tracker, built, measure, postures, robot

HEAD: tuple[str, ...] = ("frame", "marker", "x_mm", "y_mm", "z_mm", "qx", "qy", "qz", "qw")
HEAD += ("standard_uncertainty_mm", "rotation_standard_uncertainty_deg")
MARKER = "marker_x_mm,marker_y_mm,marker_z_mm"
Rows = tuple[Arm, list[list[float | str]]]


@pytest.fixture(scope="module")
def rows() -> Rows:
    """A robot, and the cells of fifty full poses."""
    rng = np.random.default_rng(1)
    arm = robot(6)
    found = measure(built(arm, rng), postures(arm, 50, rng), Tracker.somewhere(rng), rng, True)
    quaternions = Rotation.from_matrix(present(found.rotations)).as_quat()
    cells = zip(found.points_mm, quaternions, found.q_rad, strict=True)
    return arm, [
        ["hall", "tip", *point, *quaternion, 0.05, np.degrees(2e-4), *np.degrees(q)]
        for point, quaternion, q in cells
    ]


@pytest.fixture
def folder(tmp_path: Path, rows: Rows) -> Path:
    arm, cells = rows
    arm_document(arm).write(tmp_path / "arm.json")
    text = table_text((*HEAD, *joint_columns(6)), cells)
    (tmp_path / COORDINATES).write_text(text)
    return tmp_path


def test_what_is_read_is_what_was_measured(folder: Path, rows: Rows) -> None:
    (found,) = read_coordinates(folder / COORDINATES, rows[0])
    assert (found.frame, found.marker) == ("hall", "tip")
    assert found.lines == tuple(range(2, 52))
    written = np.array([[float(cell) for cell in row[2:5]] for row in rows[1]])
    np.testing.assert_allclose(found.points_mm, written, rtol=1e-12)
    assert found.rotations is not None
    np.testing.assert_allclose(found.standard_uncertainty_mm, 0.05)
    np.testing.assert_allclose(present(found.rotation_uncertainty_rad), 2e-4)
    assert found.offset_mm is None


def read_cells(folder: Path) -> list[list[str]]:
    return [line.split(",") for line in (folder / COORDINATES).read_text().splitlines()]


def write_cells(folder: Path, rows: list[list[str]]) -> None:
    (folder / COORDINATES).write_text("".join(",".join(row) + "\n" for row in rows))


def columns(folder: Path, names: str, change: Callable[[list[str]], list[str]]) -> None:
    """The table with other columns: ``change`` is given the cells of each row."""
    _, *rows = read_cells(folder)
    write_cells(folder, [[*names.split(","), *joint_columns(6)], *map(change, rows)])


def test_points_alone_are_enough(folder: Path, rows: Rows) -> None:
    columns(folder, "x_mm,y_mm,z_mm", lambda row: row[2:5] + row[11:])
    (found,) = read_coordinates(folder / COORDINATES, rows[0])
    assert (found.frame, found.marker) == ("instrument", "tip")
    assert found.rotations is None
    assert found.rotation_uncertainty_rad is None
    assert not found.standard_uncertainty_mm.any()


def test_angles_and_a_given_marker_are_read(folder: Path, rows: Rows) -> None:
    def turned(row: list[str]) -> list[str]:
        rz, ry, rx = Rotation.from_quat([float(one) for one in row[5:9]]).as_euler("ZYX", True)
        return [*row[2:5], str(rx), str(ry), str(rz), "10", "20", "30", *row[11:]]

    (by_quaternion,) = read_coordinates(folder / COORDINATES, rows[0])
    columns(folder, f"x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg,{MARKER}", turned)
    (by_angles,) = read_coordinates(folder / COORDINATES, rows[0])
    assert by_quaternion.rotations is not None
    np.testing.assert_allclose(present(by_angles.rotations), by_quaternion.rotations, atol=1e-9)
    assert present(by_angles.offset_mm).tolist() == [10.0, 20.0, 30.0]


@pytest.mark.slow
def test_the_result_says_where_instrument_and_markers_were(folder: Path) -> None:
    document, result = identify_folder(folder, folder / "new.json")
    assert ArmFile.read(folder / "new.json") == document
    part = present(document.identification)
    assert part.scatter_um is None
    assert part.coordinates_scatter_um is not None
    assert present(part.validation.after.coordinates_um) < 150
    (frame,), (marker,) = part.frames, part.markers
    assert (frame.name, marker.name) == ("hall", "tip")
    assert marker.quaternion is not None
    assert {one.file for one in part.inputs} == {"arm.json", COORDINATES}
    text = " ".join(f"{name} {value}" for name, value in identification_summary(result))
    assert "measured coordinates" in text
    assert "base in frame hall" in text
    tip = read_arm(folder / "new.json").tip
    assert (tip.x_mm, tip.y_mm) == (marker.x_mm, marker.y_mm)


Edit = Callable[[list[list[str]]], None]


def set_cell(row: int, column: int, text: str) -> Edit:
    def edit(cells: list[list[str]]) -> None:
        cells[row][column] = text

    return edit


def every(row: slice, column: slice, change: Callable[[float], float]) -> Edit:
    def edit(cells: list[list[str]]) -> None:
        for one in cells[row]:
            one[column] = [repr(float(change(float(text)))) for text in one[column]]

    return edit


def without_column(column: int) -> Edit:
    def edit(cells: list[list[str]]) -> None:
        for row in cells:
            del row[column]

    return edit


@pytest.mark.parametrize(
    ("edit", "code", "place"),
    [
        (set_cell(3, 2, "nan"), "cell-not-a-number", "line 4"),
        (set_cell(3, 2, ""), "cell-empty", "line 4"),
        (set_cell(5, 8, "3"), "quaternion-not-unit", "line 6"),
        (set_cell(5, 11, "700"), "joint-outside-limits", "line 6"),
        (set_cell(7, 9, "-1"), "uncertainty-senseless", "line 8"),
        (set_cell(7, 9, "50"), "uncertainty-senseless", "line 8"),
        (set_cell(0, 4, "z_m"), "columns-missing", "z_mm"),
        (without_column(7), "columns-missing", "qz"),
        (without_column(-1), "joint-count", "5"),
        (every(slice(1, None), slice(11, None), np.radians), "joints-in-radians", COORDINATES),
        (every(slice(1, None), slice(2, 5), lambda x: x / 1e3), "coordinates-unit", "hall"),
        (lambda cells: cells.__delitem__(slice(5, None)), "too-few-points", "4 points"),
        (lambda cells: cells.__delitem__(slice(1, None)), "no-points", COORDINATES),
        (lambda cells: cells[0].__setitem__(5, "rx_deg"), "columns-missing", "qx"),
        (every(slice(30, None), slice(2, 5), lambda x: x + 40), "frames-mixed", "line 31"),
    ],
)
def test_bad_tables_are_refused(folder: Path, edit: Edit, code: str, place: str) -> None:
    cells = read_cells(folder)
    edit(cells)
    write_cells(folder, cells)
    with pytest.raises(OperationError) as caught:
        identify_folder(folder, folder / "new.json")
    assert caught.value.code == code
    assert COORDINATES in str(caught.value.text)
    assert place in str(caught.value.text)
    assert caught.value.remedy or caught.value.code in ("cell-empty",)
    assert not (folder / "new.json").exists()


def test_angles_in_radians_and_two_rotations_are_refused(folder: Path, rows: Rows) -> None:
    angles, whole = "rx_deg,ry_deg,rz_deg", read_cells(folder)
    columns(folder, f"{','.join(HEAD[:9])},{angles},{','.join(HEAD[9:])}", both_rotations)
    with refused_as("two-rotations"):
        read_observations(folder, rows[0])
    write_cells(folder, whole)
    columns(folder, f"x_mm,y_mm,z_mm,{angles}", lambda c: [*c[2:5], "1.1", "-0.2", "3.1", *c[11:]])
    with refused_as("rotations-in-radians"):
        read_observations(folder, rows[0])


def both_rotations(row: list[str]) -> list[str]:
    """Angles beside the quaternion."""
    return [*row[:9], "1", "2", "3", *row[9:]]


def test_a_marker_has_one_place(folder: Path, rows: Rows) -> None:
    columns(folder, f"x_mm,y_mm,z_mm,{MARKER}", lambda row: [*row[2:5], "1", "2", "3", *row[11:]])
    text = (folder / COORDINATES).read_text()
    (folder / COORDINATES).write_text(text.replace(",1,2,3,", ",1,2,4,", 1))
    with refused_as("marker-moved", where="line 3"):
        read_coordinates(folder / COORDINATES, rows[0])


def test_limits_of_the_arm_hold(folder: Path, rows: Rows) -> None:
    arm = rows[0]
    joints = (replace(arm.joints[0], limits_rad=(-0.1, 0.1)), *arm.joints[1:])
    with refused_as("joint-outside-limits"):
        read_coordinates(folder / COORDINATES, replace(arm, joints=joints))


@pytest.mark.parametrize("text", ["PK\x03\x04\x14\ufffd,x", "x\0_\0m\0m\0,\0"])
def test_a_workbook_is_named_as_one(text: str) -> None:
    """As a browser reads it, whose text has no file to fail at."""
    with pytest.raises(OperationError, match=r"tracker\.csv: this is the file of a spreadsheet"):
        parse_coordinates(text, Path("tracker.csv"), robot(6))


@given(st.text(st.sampled_from("'=+-@ \t\r1.eA,\"_infa٣"), max_size=6))
def test_no_cell_runs_in_a_spreadsheet_and_all_read_back(cell: str) -> None:
    text = table_text(("name", "value"), [(f"={cell}", -1.5), (cell, "-1.5"), ("A", "+2")])
    written = list(csv.reader(io.StringIO(text, newline="")))[1:]
    for name, _ in written:
        assert name[:1] not in set("=+-@\t\r") or re.fullmatch(r"[+-][0-9.]+(e[+-]?[0-9]+)?", name)
    assert [value for _, value in written] == ["-1.5", "-1.5", "+2"]
    rows = parse_table(text, Path("t.csv"), ("name",)).rows
    assert [row.cells["name"] for row in rows] == [f"={cell}", cell, "A"]
