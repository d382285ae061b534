"""A scan of a plate with a dent, a bump and a step is decided as its truth, whatever erred."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.formats.clouds.files import cloud_writer
from crenel.metrology.decision import GUARDED_95
from crenel.parts.cad.evaluate_part import read_part
from crenel.parts.deviation.document_map import CELL
from crenel.parts.deviation.evaluate_deviation import DeviationOrder, DeviationResult, deviate
from crenel.parts.deviation.maths_decisions import (
    IN,
    OUT,
    UNDECIDED,
    DeviationLimits,
    count_by_chance,
    decide_cells,
    decide_profile,
    temper_decisions,
)
from tests.parts.meshes import sphere_corners, write_stl
from tests.parts.simulated_inspection import (
    draw_station,
    draw_truth,
    plan_passes,
    scan_part,
    usual_passes,
    write_station,
)
from tests.parts.simulated_plate import Plate

LIMITS = DeviationLimits(-0.04, 0.04)
PLATE = Plate()


@pytest.fixture(scope="module")
def station_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("station")
    write_station(folder, draw_station(4))
    write_stl(folder / "part.stl", PLATE.corners())
    return folder


@pytest.fixture(scope="module")
def scan_of_draw(station_folder: Path) -> Callable[[int], Path]:
    """The recording of the plate by a station that errs as drawn."""
    station = draw_station(4)
    planned = plan_passes(station, usual_passes(PLATE), 2)

    @cache
    def scan(seed: int) -> Path:
        path = station_folder / f"{seed}.mcap"
        scan_part(path, PLATE, draw_truth(station, seed), planned, seed)
        return path

    return scan


def order(scan: Path) -> DeviationOrder:
    return DeviationOrder(scan, read_part(scan.parent / "part.stl", "mm"), limits=LIMITS)


def cells_of_top(result: DeviationResult) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """Which cells are of the top, and the true height of each."""
    cells = result.placed.cells
    on_top = (cells.normals[:, 2] > 0.9) & (cells.at_mm[:, 2] < PLATE.top_mm + 1)
    return on_top, PLATE.relief_mm(cells.at_mm[:, 0], cells.at_mm[:, 1]) * on_top


@pytest.mark.slow
@pytest.mark.parametrize("seed", [51, 52, 53])
def test_what_is_wrong_is_never_decided_as_right(
    scan_of_draw: Callable[[int], Path], seed: int
) -> None:
    result = deviate(order(scan_of_draw(seed)))
    cells, (on_top, true) = result.placed.cells, cells_of_top(result)
    x0, y0, x1, y1, _ = PLATE.step
    x, y, _ = cells.at_mm.T
    inside = np.minimum.reduce([x - x0, x1 - x, y - y0, y1 - y])
    dent, bump = true == -0.05, true == 0.15
    step, flat = on_top & (inside > 1), on_top & (true == 0) & (inside < -1)
    assert min(dent.sum(), bump.sum(), step.sum()) > 30
    assert not (result.decisions[dent] == IN).any()
    assert not (result.decisions[flat] == OUT).any()
    assert not (result.decisions[step] == IN).any()
    known = bump & (cells.count >= 3)
    assert (result.decisions[known] == OUT).all()
    for some in (dent, bump, step, flat):
        off = float(np.median((cells.deviation_mm - true)[some]))
        assert abs(off) < 3 * float(np.median(result.u_mm[some]))
    ratio = (cells.deviation_mm - true)[flat] / result.u_mm[flat]
    assert 0.6 < float(np.sqrt(np.mean(ratio**2))) < 1.5
    assert result.profile is not None
    assert result.profile.decision == "fail"


@pytest.mark.slow
def test_the_sum_of_the_budget_is_what_draws_of_all_errors_show(
    scan_of_draw: Callable[[int], Path],
) -> None:
    from crenel.parts.deviation.evaluate_pose import ScanOnPart, place_by_best_fit
    from crenel.parts.deviation.maths_uncertainty import map_errors
    from crenel.parts.evaluate_folder import read_station
    from crenel.parts.evaluate_points import read_scan

    path = scan_of_draw(51)
    station = read_station(path.parent / "calibration.json", path.parent / "arm.json")
    errors = read_scan(path, station, lambda share, text: None).errors
    part = read_part(path.parent / "part.stl", "mm")
    placed = place_by_best_fit(ScanOnPart(part, errors.points_mm, errors, 6.0))
    assert placed.errors is not None
    assert station.shared is not None
    known = map_errors(placed.cells, placed.errors, placed.pose, station.shared)
    drawn = np.concatenate(list(known.draw(2000)), axis=1).std(axis=1)
    assert np.allclose(drawn, known.standard_uncertainty_mm, rtol=0.12)
    # the fit takes most of what moves all cells together
    alone = replace(known, shared=placed.errors.shared)
    whole = np.median(np.sqrt(alone.variances["calibration"] + alone.variances["arm"]))
    left = np.median(np.sqrt(known.variances["calibration"] + known.variances["arm"]))
    assert left < 0.7 * whole


@pytest.mark.slow
def test_the_command_writes_a_map_and_ends_by_its_decision(
    scan_of_draw: Callable[[int], Path], tmp_path: Path
) -> None:
    path = scan_of_draw(51)
    out = tmp_path / "map.ply"
    command = ["deviate", str(path), "--part", str(path.parent / "part.stl"), "--unit", "mm"]
    tolerance = ["--tolerance", "-0.04", "0.04"]
    ran = CliRunner().invoke(cli, [*command, *tolerance, "-o", str(out)])
    assert ran.exit_code == 4, ran.output
    head, _, body = out.read_bytes().partition(b"end_header\n")
    rows = np.frombuffer(body, CELL)
    assert f"element vertex {len(rows)}" in head.decode()
    assert set(rows["decision"]) == {IN, OUT, UNDECIDED}
    assert (rows["uncertainty_um"] > 0).all()
    wide = CliRunner().invoke(cli, [*command, "--tolerance", "-1", "1", "-o", str(out)])
    assert wide.exit_code in (0, 5)
    assert not (
        np.frombuffer(out.read_bytes().partition(b"end_header\n")[2], CELL)["decision"] == OUT
    ).any()


def test_a_cloud_decides_nothing(tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    part = write_stl(tmp_path / "part.stl", PLATE.corners())
    mesh = read_part(part, "mm").mesh
    faces = rng.choice(len(mesh.areas_mm2), 4000, p=mesh.areas_mm2 / mesh.areas_mm2.sum())
    points = np.einsum("nc,nci->ni", rng.dirichlet(np.ones(3), 4000), mesh.corners_mm[faces])
    cloud = tmp_path / "cloud.ply"
    with cloud_writer(cloud) as writer:
        full = np.ones(len(points))
        writer.write(points + rng.normal(0, 0.01, points.shape), full, 10 * full, 0)
    out = tmp_path / "map.ply"
    command = ["deviate", str(cloud), "--part", str(part), "-o", str(out), "--radius", "3"]
    ran = CliRunner().invoke(cli, [*command, "--tolerance", "-1", "1"])
    assert ran.exit_code == 5, ran.output
    assert "uncertainty unknown" in ran.output
    rows = np.frombuffer(out.read_bytes().partition(b"end_header\n")[2], CELL)
    assert (rows["decision"] == UNDECIDED).all()
    assert np.isnan(rows["uncertainty_um"]).all()


def test_facets_too_coarse_for_the_tolerance_decide_nothing(tmp_path: Path) -> None:
    rng = np.random.default_rng(2)
    radius, noise = 20.0, 0.005
    out = rng.normal(size=(20_000, 3))
    points = out / np.linalg.norm(out, axis=1)[:, None] * radius + rng.normal(0, noise, out.shape)
    cloud = tmp_path / "ball.ply"
    with cloud_writer(cloud) as writer:
        writer.write(points + [1.0, 2.0, 3.0], np.ones(len(out)), np.ones(len(out)), 0)
    part = write_stl(tmp_path / "part.stl", sphere_corners(radius, 24))
    command = ["deviate", str(cloud), "--part", str(part), "-o", str(tmp_path / "map.ply")]
    command += ["--lock", "rx", "--lock", "ry", "--lock", "rz"]
    coarse = CliRunner().invoke(cli, [*command, "--tolerance", "-0.1", "0.1"])
    assert coarse.exit_code == 1
    assert "finer facets" in coarse.stderr
    # within its chord error, the deviation has no bias
    result = deviate(DeviationOrder(cloud, read_part(part, "mm"), locked=("rx", "ry", "rz")))
    cells = result.placed.cells
    off = cells.deviation_mm[cells.count >= 3]
    assert (off > -4 * noise).all()
    assert (off < cells.chord_error_mm[cells.count >= 3].max() + 4 * noise).all()


def test_each_cell_is_decided_by_the_rule_against_both_limits() -> None:
    limits, u = DeviationLimits(-0.02, 0.06), np.array([0.005, 0.005, 0.005, 0.005, np.nan])
    off = np.array([0.02, 0.07, -0.03, 0.055, 0.02])
    assert decide_cells(off, u, limits, GUARDED_95).tolist() == [IN, OUT, OUT, UNDECIDED, UNDECIDED]


def test_a_profile_is_one_decision_over_all_cells() -> None:
    rng = np.random.default_rng(3)
    off = np.zeros(500)
    for u, decision in ((0.002, "pass"), (0.0135, "undecided"), (0.05, "fail")):
        draws = [u * rng.normal(size=(500, 200)) for _ in range(10)]
        assert decide_profile(off, draws, LIMITS).decision == decision
    # errors that all cells share do not add up
    shared = [0.0135 * rng.normal(size=(1, 200)) * np.ones((500, 1)) for _ in range(10)]
    assert decide_profile(off, shared, LIMITS).probability > 0.99


def test_how_many_cells_are_out_by_chance_is_what_a_perfect_part_shows() -> None:
    """By the rule alone, a tenth of a thousand cells; of so many, one of 20 maps shows one."""
    u = np.full(1000, 0.03)
    rng = np.random.default_rng(4)
    out = 0
    for _ in range(400):
        off = rng.normal(0.0, u)
        alone = decide_cells(off, u, LIMITS, GUARDED_95)
        out += int((temper_decisions(alone, alone, off, u) == OUT).sum())
    assert out / 400 == pytest.approx(count_by_chance(u, LIMITS, GUARDED_95), abs=0.04)
    assert count_by_chance(u, LIMITS, GUARDED_95) < 0.051


def test_a_cell_among_others_that_are_not_in_is_not_in_by_chance() -> None:
    decisions = np.array([IN, IN, OUT, UNDECIDED], np.uint8)
    around = np.array([IN, UNDECIDED, IN, IN], np.uint8)
    off, u = np.array([0.0, 0.0, 0.5, 0.0]), np.full(4, 0.01)
    assert temper_decisions(decisions, around, off, u).tolist() == [IN, UNDECIDED, OUT, UNDECIDED]
