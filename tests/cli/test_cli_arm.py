"""``crenel identify`` and ``crenel articulation``."""

import json
from pathlib import Path

import pytest

from app.formats.datasheets.arm import read_arm
from tests.cli.test_cli import crenel, done, names_in, printed, refused
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
    result = done("identify", folder, "-o", out)
    words = ("before", "after", "J2.theta_deg", "Unchanged parameters", "Correlated", "µm")
    for word in (*words, str(out), "calibrate the arm's sensors"):
        assert word in result.stdout
    assert read_arm(out) != read_arm(folder / "arm.json")
    fields = printed("identify", folder, "-o", out)
    part = fields["identification"]
    assert part["volume_after_um"] < part["volume_before_um"] / 10
    assert fields["file"] == str(out)
    written = json.loads(out.read_text())["identification"]
    pairs, names = written["correlated"], {one["name"] for one in written["parameters"]}
    assert all(abs(pair["coefficient"]) > 0.95 for pair in pairs)
    assert pairs
    assert {pair["first"] for pair in pairs} <= names


def test_a_model_is_imported_once_everything_is_said(tmp_path: Path) -> None:
    out, table = tmp_path / "new.json", tmp_path / "table.txt"
    rows = [f"{number} {100 * number} 0 π/2 q{number}" for number in range(1, 7)]
    table.write_text("joint d a alpha theta\n" + "\n".join(rows))
    command = ("import-arm", table, "--tip", 0, 0, 150, 6, "-o", out)
    said = refused(*command)
    assert "length (mm | cm | m | inch; likely mm" in said
    assert "convention (dh-standard | dh-modified)" in said
    assert "KEY=VALUE" in crenel(*command, "--say", "length").stderr
    assert not out.exists()
    result = done(*command, "--say", "length=mm", "--say", "convention=dh-standard")
    assert "±180°" in result.stderr
    assert read_arm(out).joints[5].d_mm == 600


def test_identify_refuses_on_one_line_and_writes_nothing(tmp_path: Path, folder: Path) -> None:
    before = names_in(tmp_path)
    assert "no such folder" in refused("identify", tmp_path / "none")
    assert "computed from" in refused("identify", folder, "-o", folder / "arm.json")
    lines = (folder / "articulation.csv").read_text().splitlines()
    (folder / "articulation.csv").write_text("\n".join(lines[:3]) + "\n")
    assert "seat S1" in refused("identify", folder, "-o", tmp_path / "new.json")
    assert names_in(tmp_path) == before


def test_without_a_bar_the_scale_is_said_to_be_not_observable(tmp_path: Path, folder: Path) -> None:
    (folder / "ballbars.csv").unlink()
    result = done("identify", folder, "-o", tmp_path / "new.json")
    assert "ball bar" in result.stderr
    assert "not observable" in result.stdout


def test_articulation_passes_or_fails_by_the_limit(tmp_path: Path, folder: Path) -> None:
    shown = done("articulation", folder).stdout
    assert "S1" in shown
    assert "FAIL" not in shown
    done("articulation", folder, "--limit-um", "2000")
    failed = crenel("articulation", folder / "articulation.csv", "--limit-um", "50")
    assert failed.exit_code == 1
    assert "beyond the limit" in failed.stderr
    fields = printed("articulation", folder, "--limit-um", "2000")
    assert (fields["verdict"], len(fields["sets"])) == ("pass", 6)
    assert "arm.json" in refused("articulation", tmp_path)


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
    assert "another place" in refused("articulation", folder)
    table.write_text(table.read_text().replace(mixed[3].split(",")[2], "nan"))
    assert refused("articulation", folder).count("articulation.csv") == 1
