"""A block of which only the drawing is known, made within a tolerance: eight poses.

    python -m tests.bench nominal-block [--sessions 5] [--solves 60] [--seed 51001]
                                        [--tolerance-mm 0.1] [--json]

Rendered sessions first: each is calibrated with the block's edges estimated, and with the drawing
taken for a certificate; the truth's pixels are rebuilt and compared with where their light fell.
Then sessions without pictures (`tests.bench.metrology.simulated`), which are fast enough to
compare what the adjustment claims with what it is off, of a scanned point and of the block's edges:
of one station many draws, and of many stations one draw each.
"""

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import read_session
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.metrology.adjustment.block.nominal_block import estimate_block
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.parameters import SENSOR
from crenel.metrology.adjustment.core.uncertainty import measuring_volume, sensor_jacobian
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import apply
from crenel.workflows.calibrate import joint_inputs
from crenel_hardware.simulator.devices.kinematics import UnreachableError
from crenel_hardware.simulator.session import SessionPlan
from tests.bench.metrology.simulated import Draw, SetUp, SimulatedSetup, draw_session, draw_setup
from tests.bench.rows import Rows, bench_parser, measured_rows, rms
from tests.bench.sessions import draw_camera, draw_sessions, errors_um

POSES, EXACT_MM = 8, 0.002
FACES = {
    "3 faces": ("crest", "front", "left"),
    "5 faces": ("crest", "front", "back", "left", "right"),
}
STATIONS_EVERY = 6
"""So many draws of one station, then the next."""


def draw_plan(tolerance_mm: float, rng: np.random.Generator) -> SessionPlan:
    """Six or seven axes, any roll of the camera, faces as they come."""
    faces = list(FACES.values())[int(rng.integers(len(FACES)))]
    joints = int(rng.integers(6, 8))
    plan = SessionPlan(joints, poses=POSES, faces=faces, tolerance_mm=tolerance_mm)
    return replace(plan, **draw_camera(rng))


def measure_rendered(count: int, seed: int, tolerance_mm: float, rows: Rows) -> None:
    """The whole way from pictures: with estimated edges, and with the drawing as certificate."""
    with_edges, without, claimed = [], [], []
    refused = {"with": 0, "without": 0}
    draw = partial(draw_plan, tolerance_mm)
    with tempfile.TemporaryDirectory() as scratch:
        for folder in draw_sessions(count, seed, draw, Path(scratch)):
            inputs = joint_inputs(read_session(folder))
            try:
                found = calibrate_block(inputs)
            except OperationError as refusal:
                refused["with"] += 1
                rows.say(f"{folder.name}: refused: {refusal}")
                continue
            ours = errors_um(found, folder)
            with_edges.append(ours)
            claimed.append(found.uncertainty.total_um)
            rows.say(
                f"{folder.name}: {ours[0]:.1f}, {ours[1]:.1f} µm, claimed {claimed[-1]:.1f} µm"
            )
            exact = replace(inputs.block, standard_uncertainty_mm=EXACT_MM, is_nominal=False)
            try:
                without.append(errors_um(calibrate_block(replace(inputs, block=exact)), folder))
            except OperationError:
                refused["without"] += 1
    for name, errors in (("edges estimated", with_edges), ("drawing as certificate", without)):
        if errors:
            sensor, flange = np.transpose(errors)
            medians = {"sensor, median µm": float(np.median(sensor))}
            rows.add(name, medians | {"flange, median µm": float(np.median(flange))})
    if with_edges:
        flange = np.array(with_edges)[:, 1]
        said = rms(np.array(claimed)) / rms(flange)
        rows.add("rendered", {"measured": len(flange), **refused, "claimed / observed": said})


@dataclass(frozen=True)
class SolvedDraw:
    """Squares of one solve: a point's error and its claim (mm²), the edges' errors and claims."""

    point: float
    point_claimed: float
    edges: float
    edges_claimed: float


def measure_solves(name: str, count: int, seed: int, tolerance_mm: float, rows: Rows) -> None:
    """Claimed over observed, by draws without pictures."""
    done = {"edges estimated": list[SolvedDraw](), "drawing as certificate": list[SolvedDraw]()}
    failed = 0
    for draw in draw_all(FACES[name], count, seed, tolerance_mm):
        exact = replace(draw.problem.prior, sd=np.full(len(draw.problem.prior.sd), EXACT_MM))
        for way, problem in (
            ("edges estimated", draw.problem),
            ("drawing as certificate", replace(draw.problem, prior=exact)),
        ):
            try:
                done[way].append(measure_draw(draw, solve_adjustment(problem, draw.start)))
            except OperationError:
                failed += 1
    for way, solves in done.items():
        point, claimed = (
            np.sqrt(np.mean([getattr(one, field) for one in solves]))
            for field in ("point", "point_claimed")
        )
        edges, edges_claimed = (
            np.sqrt(np.mean([getattr(one, field) for one in solves]))
            for field in ("edges", "edges_claimed")
        )
        values = {"solves": len(solves), "failed": failed, "point, rms µm": 1e3 * point}
        values |= {"claimed / observed": claimed / point, "edges, rms µm": 1e3 * edges}
        rows.add(f"{name}, {way}", values | {"edges, claimed / obs.": edges_claimed / edges})


def draw_all(faces: tuple[str, ...], count: int, seed: int, tolerance_mm: float) -> Iterator[Draw]:
    """So many sessions of stations drawn at random."""
    station: SimulatedSetup | None = None
    for trial in range(count):
        if trial % STATIONS_EVERY == 0 or station is None:
            setup = SetUp(
                "nominal", POSES, faces=faces, tolerance_mm=tolerance_mm, seed=seed + trial
            )
            try:
                station = draw_setup(setup)
            except UnreachableError:
                continue
        yield draw_session(station, np.random.default_rng([seed, trial]))


def measure_draw(draw: Draw, found: AdjustmentResult) -> SolvedDraw:
    """How far one solve is off its truth, and what it claims."""
    state, truth = found.state, draw.truth
    volume = measuring_volume(found)
    true_mm = apply(truth.T_flange_cam, sensor_points(truth.camera, truth.plane, volume.uv_px))
    J = sensor_jacobian(state, volume.uv_px)
    claimed = np.einsum("gik,kl,gil->g", J, found.uncertainty[SENSOR, SENSOR], J)
    made = estimate_block(found)
    count = len(truth.coordinates) - 5
    off_mm = (state.coordinates - truth.coordinates)[:count]
    return SolvedDraw(
        float(np.mean(np.sum((volume.points_flange_mm - true_mm) ** 2, axis=1))),
        float(np.mean(claimed)),
        float(np.var(off_mm)),
        float(np.mean(made.sd_mm[:count] ** 2)),
    )


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--sessions", type=int, default=5)
    parser.add_argument("--solves", type=int, default=60)
    parser.add_argument("--seed", type=int, default=51001)
    parser.add_argument("--tolerance-mm", type=float, default=0.1)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        for name in FACES if given.solves else ():
            measure_solves(name, given.solves, given.seed, given.tolerance_mm, rows)
        if given.sessions:
            measure_rendered(given.sessions, given.seed, given.tolerance_mm, rows)


if __name__ == "__main__":
    main()
