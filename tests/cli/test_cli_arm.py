"""``crenel identify`` and ``crenel articulation``."""

import json
from pathlib import Path

import pytest

from app.formats.datasheets.arm import read_arm
from tests.cli.test_cli import crenel, names_in, refused
from tests.simulated_arm_sessions import ArmSessionPlan, render_arm_session

pytestmark = pytest.mark.slow

PLAN = ArmSessionPlan(
    seats=6, points_per_seat=14, spheres=0, bar_lengths_mm=(600.0,), positions_per_bar=4
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    render_arm_session(tmp_path / "s", 5, PLAN)
    return tmp_path / "s"


def test_identify_writes_the_arm_and_shows_before_and_after(tmp_path: Path, folder: Path) -> None:
    out = tmp_path / "new.json"
    result = crenel("identify", folder, "-o", out)
    assert result.exit_code == 0, result.output
    for word in (
        "before",
        "after",
        "J2.theta_deg",
        "Unchanged parameters",
        "µm",
        str(out),
        "calibrate the arm's sensors",
    ):
        assert word in result.stdout
    assert read_arm(out) != read_arm(folder / "arm.json")
    fields = json.loads(crenel("identify", folder, "-o", out, "--json").stdout)
    part = fields["identification"]
    assert part["volume_after_um"] < part["volume_before_um"] / 10
    assert fields["file"] == str(out)


def test_identify_refuses_on_one_line_and_writes_nothing(tmp_path: Path, folder: Path) -> None:
    before = names_in(tmp_path)
    assert "no such folder" in refused("identify", tmp_path / "none")
    assert "computed from" in refused("identify", folder, "-o", folder / "arm.json")
    lines = (folder / "articulation.csv").read_text().splitlines()
    (folder / "articulation.csv").write_text("\n".join(lines[:3]) + "\n")
    assert "seat S1" in refused("identify", folder, "-o", tmp_path / "new.json")
    assert names_in(tmp_path) == before


def test_without_a_bar_the_scale_is_reported_as_not_observable(
    tmp_path: Path, folder: Path
) -> None:
    (folder / "ballbars.csv").unlink()
    result = crenel("identify", folder, "-o", tmp_path / "new.json")
    assert result.exit_code == 0, result.output
    assert "ball bar" in result.stderr
    assert "not observable" in result.stdout


def test_articulation_passes_or_fails_by_the_limit(tmp_path: Path, folder: Path) -> None:
    shown = crenel("articulation", folder)
    assert shown.exit_code == 0, shown.output
    assert "S1" in shown.stdout
    assert "FAIL" not in shown.stdout
    assert crenel("articulation", folder, "--limit-um", "2000").exit_code == 0
    failed = crenel("articulation", folder / "articulation.csv", "--limit-um", "50")
    assert failed.exit_code == 1
    assert "beyond the limit" in failed.stderr
    fields = json.loads(crenel("articulation", folder, "--limit-um", "2000", "--json").stdout)
    assert fields["verdict"] == "pass"
    assert len(fields["sets"]) == 6
    assert "arm.json" in refused("articulation", tmp_path)


def test_wrong_usage(folder: Path) -> None:
    assert crenel("identify").exit_code == 2
    assert crenel("articulation", folder, "--limit-um", "-3").exit_code == 2


def test_correlated_parameters_are_named(tmp_path: Path, folder: Path) -> None:
    out = tmp_path / "new.json"
    shown = crenel("identify", folder, "-o", out)
    assert "Correlated" in shown.stdout
    pairs = json.loads(out.read_text())["identification"]["correlated"]
    assert all(abs(pair["coefficient"]) > 0.95 for pair in pairs)
    names = {one["name"] for one in json.loads(out.read_text())["identification"]["parameters"]}
    assert pairs
    assert {pair["first"] for pair in pairs} <= names


def test_points_of_the_fit_are_no_check(tmp_path: Path, folder: Path) -> None:
    before = names_in(tmp_path)
    reported = refused("identify", folder, "-o", tmp_path / "new.json", "--check", folder)
    assert "other places" in reported
    assert names_in(tmp_path) == before


def test_articulation_refuses_points_of_two_places(folder: Path) -> None:
    table = folder / "articulation.csv"
    lines = table.read_text().splitlines()
    mixed = [lines[0], *(f"S1,{line.split(',', 1)[1]}" for line in lines[1:29])]
    table.write_text("\n".join(mixed) + "\n")
    reported = refused("articulation", folder)
    assert "another place" in reported
    table.write_text(table.read_text().replace(mixed[3].split(",")[2], "nan"))
    assert refused("articulation", folder).count("articulation.csv") == 1
