"""Programs and folders that cannot be: each is refused with one line that says where."""

import json
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.parts.document_program import ProgramFile
from crenel_hardware.simulator.devices.kinematics import flange_poses
from crenel_hardware.simulator.scene.datasheets import robot_datasheet
from tests.parts.bracket_program import datum_touches, write_program
from tests.parts.draws import first_setting
from tests.parts.simulated_inspection import (
    Floats,
    Station,
    draw_station,
    draw_truth,
    touch_rows,
    write_station,
)
from tests.parts.simulated_solid import Bracket

Change = Callable[[dict[str, Any]], None]
Touches = dict[str, list[tuple[Floats, Floats]]]


@cache
def usual_station() -> Station:
    return draw_station(1)


def write_folder(folder: Path, more: Touches | None = None) -> None:
    """A folder whose datums are touched, and nothing else is measured."""
    station, part = usual_station(), Bracket()
    write_station(folder, station)
    truth = draw_truth(station, 2)
    rows = touch_rows(station, truth, datum_touches(part), 2)
    rows += touch_rows(station, truth, more or {}, 3)
    columns = ["feature", *(f"q{i + 1}_deg" for i in range(7))]
    lines = [",".join(columns), *(",".join(map(str, row)) for row in rows)]
    (folder / "touches.csv").write_text("\n".join(lines) + "\n")
    write_program(folder / "program.json", part, part, "touch")
    program = json.loads((folder / "program.json").read_text())
    program["features"] = program["features"][:3]
    program["dimensions"] = [
        {"id": "A-B", "kind": "angle", "features": ["A", "B"], "nominal": 90, "unit": "deg"}
    ]
    program["source"] = {"default": "touch"}
    (folder / "program.json").write_text(json.dumps(program))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_folder(tmp_path)
    return tmp_path


def refusal(folder: Path) -> str:
    """The one line with which an inspection is refused."""
    run = CliRunner().invoke(cli, ["inspect", str(folder)])
    assert run.exit_code == 1, run.output
    lines = [line for line in run.stderr.splitlines() if not line.startswith("crenel: warning")]
    assert len(lines) == 1
    assert lines[0].startswith("crenel: ")
    assert not (folder / "results.json").exists()
    return lines[0]


def edit(folder: Path, how: Change) -> None:
    path = folder / "program.json"
    program = json.loads(path.read_text())
    how(program)
    path.write_text(json.dumps(program))


def first(program: dict[str, Any], name: str = "features") -> dict[str, Any]:
    found: dict[str, Any] = program[name][0]
    return found


CHANGES: dict[str, tuple[Change, str]] = {
    "newer": (lambda p: p.update(version=2), "version is 2"),
    "other format": (lambda p: p.update(format="crenel/plan"), "crenel/inspection-program"),
    "feature twice": (lambda p: p["features"].append(p["features"][0]), "'A' occurs twice"),
    "dimension twice": (lambda p: p["dimensions"].append(p["dimensions"][0]), "occurs twice"),
    "unknown datum": (lambda p: p["alignment"].update(primary="Z"), "no feature 'Z'"),
    "unknown feature": (lambda p: first(p, "dimensions").update(features=["A", "Q"]), "'Q'"),
    "unknown source": (lambda p: p["source"].update(touch=["Q"]), "source.touch"),
    "limits": (lambda p: first(p, "dimensions").update(lower=1, upper=-1), "lower (1)"),
    "no features": (lambda p: p.update(features=[]), "features"),
    "kind": (lambda p: first(p).update(kind="blob"), "features[0].kind"),
    "no normal": (lambda p: first(p)["nominal"].pop("normal"), "lacks normal"),
    "zero normal": (lambda p: first(p)["nominal"].update(normal=[0, 0, 0]), "must not be zero"),
    "text": (lambda p: first(p)["nominal"].update(point_mm=["a", 0, 0]), "number"),
    "infinite": (lambda p: first(p)["nominal"].update(point_mm=[1e12, 0, 0]), "point_mm"),
    "unit": (lambda p: first(p, "dimensions").update(unit="mm"), "no unit of angle"),
    "one feature": (lambda p: first(p, "dimensions").update(features=["A"]), "2 features"),
    "no such size": (
        lambda p: p["dimensions"].append(
            {"id": "d", "kind": "diameter", "features": ["A"], "nominal": 3}
        ),
        "a plane has no diameter",
    ),
    "box": (
        lambda p: first(p)["region"].update(boxes_mm=[[[1, 1, 1], [0, 0, 0]]]),
        "second corner",
    ),
    "loose datums": (lambda p: p["alignment"].update(secondary=None, tertiary=None), "free"),
    "no touches": (lambda p: p["source"].update(default="scan", touch=[]), "no scan"),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_wrong_program_is_refused_with_its_place(folder: Path, name: str) -> None:
    how, words = CHANGES[name]
    edit(folder, how)
    assert words in refusal(folder)


def rows_of(folder: Path) -> list[str]:
    return (folder / "touches.csv").read_text().splitlines()


def write_rows(folder: Path, rows: list[str]) -> None:
    (folder / "touches.csv").write_text("\n".join(rows) + "\n")


def test_too_few_touches_are_named(folder: Path) -> None:
    write_rows(
        folder,
        [row for row in rows_of(folder) if not row.startswith("C,")][:]
        + [row for row in rows_of(folder) if row.startswith("C,")][:2],
    )
    assert "feature C has 2 touches where 3 are needed" in refusal(folder)


def test_touches_at_one_place_are_named(folder: Path) -> None:
    rows = rows_of(folder)
    of_c = [row for row in rows if row.startswith("C,")]
    write_rows(folder, [row for row in rows if not row.startswith("C,")] + 3 * of_c[:1])
    assert "at one place" in refusal(folder)


def test_a_touch_on_the_wrong_side_is_named(tmp_path: Path) -> None:
    inside = (np.array([0.0, 40.0, 15.0]), np.array([1.0, 0.0, 0.0]))
    write_folder(tmp_path, {"C": [inside]})
    run = CliRunner().invoke(cli, ["inspect", str(tmp_path)])
    assert run.exit_code == 0, run.output
    said = " ".join(line for line in run.stderr.splitlines() if "touches.csv" in line)
    assert "line 17: the touch is on the wrong side of feature C" in said


def test_an_unknown_feature_of_a_touch_is_named(folder: Path) -> None:
    write_rows(folder, [*rows_of(folder), rows_of(folder)[-1].replace("C,", "D,")])
    assert "'D'" in refusal(folder)


@pytest.mark.parametrize("name", ["program.json", "arm.json", "calibration.json"])
def test_a_missing_or_broken_file_is_named(folder: Path, name: str) -> None:
    (folder / name).write_text("{")
    assert name in refusal(folder)
    (folder / name).unlink()
    assert name in refusal(folder)


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    assert "no such folder" in refusal(tmp_path / "nowhere")


def test_another_arms_calibration_is_refused(folder: Path) -> None:
    path = folder / "calibration.json"
    document = json.loads(path.read_text())
    document["serial_numbers"] = {"arm": "other"}
    path.write_text(json.dumps(document))
    assert "other" in refusal(folder)


def test_a_part_is_measured_by_touches_alone(folder: Path) -> None:
    run = CliRunner().invoke(cli, ["inspect", str(folder), "--json"])
    assert run.exit_code == 0, run.output
    result = json.loads(run.stdout)
    (angle,) = result["dimensions"]
    assert abs(angle["value"] - 90) < 4 * angle["standard_uncertainty"]
    assert {one["source"] for one in result["features"]} == {"touch"}


def test_of_a_robot_only_scatter_is_stated(folder: Path) -> None:
    """How well its controller knows a pose is written nowhere."""
    arm = usual_station().arm
    rows = [row.split(",") for row in rows_of(folder)[1:]]
    T = flange_poses(arm, np.radians([[float(cell) for cell in row[1:]] for row in rows]))
    turned = Rotation.from_matrix(T[:, :3, :3]).as_quat()
    cells = np.concatenate([T[:, :3, 3], turned], axis=1).tolist()
    poses = [[row[0], *map(str, one)] for row, one in zip(rows, cells, strict=True)]
    head = "feature,x_mm,y_mm,z_mm,qx,qy,qz,qw"
    write_rows(folder, [head, *(",".join(row) for row in poses)])
    (folder / "arm.json").write_text(json.dumps(robot_datasheet(arm)))
    run = CliRunner().invoke(cli, ["inspect", str(folder), "--json"])
    assert run.exit_code == 0, run.output
    result = json.loads(run.stdout)
    assert result["uncertainty"] == "scatter"
    assert "standard_uncertainty" not in result["dimensions"][0]
    assert abs(result["dimensions"][0]["value"] - 90) < 0.2


def test_an_interrupted_write_leaves_the_old_result(folder: Path) -> None:
    (folder / "results.json").write_text("old")
    edit(folder, lambda p: p.update(version=9))
    assert CliRunner().invoke(cli, ["inspect", str(folder)]).exit_code == 1
    assert (folder / "results.json").read_text() == "old"


def test_angles_are_in_degrees_unless_said(folder: Path) -> None:
    edit(folder, lambda p: first(p, "dimensions").pop("unit"))
    (angle,) = ProgramFile.read(folder / "program.json").dimensions
    assert angle.unit == "deg"


def test_programs_of_tests_are_read(tmp_path: Path) -> None:
    setting = first_setting()
    write_program(tmp_path / "program.json", setting.nominal, setting.true)
    program = ProgramFile.read(tmp_path / "program.json")
    assert program.means_of("H1") == "scan"
    assert program.size_mm() > 100
