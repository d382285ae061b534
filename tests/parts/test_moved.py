"""What has moved between two rounds of touches is named, and nothing else is."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.parts.nests.evaluate_moved import MovedCheck, check_moved
from crenel.parts.nests.maths_moved import compare_hypotheses, rigid_motion
from tests.parts.simulated_inspection import Station, draw_station, draw_truth, write_station
from tests.parts.simulated_nests import NESTS, nest_places, small_motion, write_round

PART = ("P1", "P2", "P3")
SLIP_MM = 0.1


@pytest.fixture(scope="module")
def station() -> Station:
    return draw_station(1)


def write_rounds(folder: Path, station: Station, case: str, seed: int) -> list[str]:
    """Both rounds of a case in a folder; returns the names of what moved."""
    rng = np.random.default_rng(seed)
    truth = draw_truth(station, seed)
    places = nest_places()
    after = dict(places)
    moved: list[str] = []
    if case == "nest":
        moved = [list(NESTS)[seed % len(NESTS)]]
        slip = rng.normal(size=3)
        after[moved[0]] = places[moved[0]] + SLIP_MM * slip / np.linalg.norm(slip)
    elif case in ("part", "all"):
        T = small_motion(rng, SLIP_MM)
        moved = [name for name in NESTS if case == "all" or name in PART]
        after |= {name: T[:3, :3] @ places[name] + T[:3, 3] for name in moved}
    folder.mkdir(exist_ok=True)
    write_station(folder, station)
    write_round(folder / "before.csv", station, truth, places, rng)
    write_round(folder / "after.csv", station, truth, after, rng)
    return moved


def check(folder: Path) -> MovedCheck:
    before, after, calibration, arm = (
        folder / name for name in ("before.csv", "after.csv", "calibration.json", "arm.json")
    )
    return check_moved(before, after, calibration, arm, PART)


@pytest.mark.slow
@pytest.mark.parametrize("case", ["nothing", "nest", "part", "all"])
def test_the_culprit_is_found(tmp_path: Path, station: Station, case: str) -> None:
    ratios = []
    for seed in range(500, 508):
        folder = tmp_path / str(seed)
        moved = write_rounds(folder, station, case, seed)
        found = check(folder)
        assert found.chosen is not None
        assert (found.chosen.culprit, found.names(found.chosen)) == (case, moved)
        ratios.append(found.chosen.chi_square / found.chosen.freedom)
    assert 0.6 < np.mean(ratios) < 1.5


def test_two_nests_that_slip_apart_are_not_taken_for_another_culprit(
    tmp_path: Path, station: Station
) -> None:
    write_rounds(tmp_path, station, "nothing", 7)
    rng, places = np.random.default_rng(7), nest_places()
    places["P1"] = places["P1"] + np.array([0.3, 0.0, 0.0])
    places["B2"] = places["B2"] + np.array([0.0, -0.3, 0.1])
    (tmp_path / "after.csv").unlink()
    (tmp_path / "after-touches").rmdir()
    write_round(tmp_path / "after.csv", station, draw_truth(station, 7), places, rng)
    assert check(tmp_path).chosen is None
    run = CliRunner().invoke(
        cli, ["moved", str(tmp_path / "before.csv"), str(tmp_path / "after.csv"), "--json"]
    )
    assert run.exit_code == 5
    said = json.loads(run.stdout)
    assert said["moved"] == "unknown"
    largest = max(said["nests"], key=lambda one: np.linalg.norm(one["shift_mm"]))
    assert largest["nest"] in ("P1", "B2")


def test_the_command_names_what_moved(tmp_path: Path, station: Station) -> None:
    (name,) = write_rounds(tmp_path, station, "nest", 3)
    both = [str(tmp_path / "before.csv"), str(tmp_path / "after.csv")]
    run = CliRunner().invoke(cli, ["moved", *both])
    assert run.exit_code == 4
    assert f"moved: nest {name} alone" in run.stderr
    assert CliRunner().invoke(cli, ["moved", both[0], both[0]]).exit_code == 0
    lines = (tmp_path / "after.csv").read_text().splitlines()
    (tmp_path / "few.csv").write_text("\n".join(lines[:4]) + "\n")
    run = CliRunner().invoke(cli, ["moved", both[0], str(tmp_path / "few.csv")])
    assert run.exit_code == 1
    assert "2 nests are in both" in run.stderr
    run = CliRunner().invoke(cli, ["moved", *both, "--part", "P9"])
    assert run.exit_code == 1
    assert "there is no nest 'P9'" in run.stderr or "there is no nest P9" in run.stderr


def test_a_large_motion_is_found_exactly() -> None:
    rng = np.random.default_rng(5)
    before = rng.normal(size=(4, 3)) * 100
    T = small_motion(rng, 40.0)
    after = before @ T[:3, :3].T + T[:3, 3]
    weight = np.linalg.inv(np.diag(rng.uniform(1, 4, 12) * 1e-6))
    found, rank = rigid_motion(before, after, np.asarray(weight))
    assert rank == 6
    assert np.allclose(found, T, atol=1e-8)
    two, rank = rigid_motion(before[:2], after[:2], np.eye(6))
    assert rank == 5
    assert np.allclose(before[:2] @ two[:3, :3].T + two[:3, 3], after[:2], atol=1e-7)
    hypotheses = compare_hypotheses(before, after, np.diag(np.full(12, 1e-6)))
    assert {one.culprit for one in hypotheses} == {"nothing", "nest", "all"}
