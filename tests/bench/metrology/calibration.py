"""Does the adjustment keep its word: errors of hundreds of solves against what was claimed.

For each set-up the rms error of reconstructed points is compared with the Cramér-Rao
bound at the truth, and the scatter with the uncertainty that each solve claimed.

A few errors rule an rms, so that the ratio to the bound has its standard error beside it: of
200 solves about 0.035. The same draws are solved again with the noise's scales known, which
reaches the bound: what these solves are off it is the sampling variation of the draws, and
without that (a control variate) the ratio is known two to four times better.
"""

import time
from dataclasses import dataclass

import numpy as np

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.information import information_at
from crenel.metrology.adjustment.core.parameters import SENSOR, AdjustmentState
from crenel.metrology.adjustment.core.uncertainty import (
    Volume,
    measuring_volume,
    plane_across_view,
    plane_uncertainty,
    sensor_jacobian,
)
from crenel.metrology.adjustment.core.variance_components import Scales
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, apply, rigid_fit
from crenel.progress import Progress, no_progress
from tests.bench.metrology.simulated import Draw, SetUp, draw_session, draw_setup

FIVE_FACES = ("crest", "front", "back", "left", "right")
POOR_ARM = Scales(links_rad=3e-5, links_mm=0.012, noise=1.0, touch_mm=0.004)
SET_UPS = (
    SetUp("one pose", 1, seed=11),
    SetUp("8 poses", 8, seed=12),
    SetUp("8 poses, 250 µm arm, five faces", 8, faces=FIVE_FACES, scales=POOR_ARM, seed=13),
    SetUp(
        "8 poses, seven axes, camera turned, no distortion",
        8,
        joints=7,
        roll_rad=1.5,
        distortion=(0.0,) * 5,
        seed=14,
    ),
    SetUp("20 poses", 20, seed=15),
)


@dataclass(frozen=True)
class Ratio:
    """Of an rms error to the bound, and its standard error by the number of solves."""

    value: float
    error: float

    def __str__(self) -> str:
        return f"{self.value:.3f} ± {self.error:.3f}"


def ratio(squares: Floats, bound: float) -> Ratio:
    """Of the root of the mean of squares (N,) to a bound."""
    value = float(np.sqrt(np.mean(squares)) / bound)
    error = float(np.std(squares, ddof=1) / np.sqrt(len(squares)) / bound**2)
    return Ratio(value, error / (2 * value))


@dataclass(frozen=True)
class SetUpResult:
    """What a set-up came to; lengths in µm, angles in arcseconds, k = 1."""

    name: str
    solves: int
    failed: int
    rms_um: float
    bound_um: float
    over_bound: Ratio
    without_sampling: Ratio
    claimed_um: float
    sensor_um: float
    angle: float
    angle_claimed: float
    offset_um: float
    offset_claimed_um: float
    solve_s: float

    @property
    def claimed_over_observed(self) -> float:
        return self.claimed_um / self.rms_um


@dataclass(frozen=True)
class _Solve:
    errors_mm: Floats  # (G, 3), flange frame
    known_scales_errors_mm: Floats  # the same, with the noise's scales known
    in_sensor_um: float
    line: Floats  # (2,) offset mm and slope rad of a plane
    claimed_mm2: float
    plane_claimed: tuple[float, float]
    seconds: float


def run(
    solves: int, progress: Progress = no_progress, setups: tuple[SetUp, ...] = SET_UPS
) -> list[SetUpResult]:
    """``solves`` noisy sessions of each set-up, solved from a rough start."""
    results = []
    for i, setup in enumerate(setups):
        station = draw_setup(setup)
        reference = draw_session(station, np.random.default_rng(0), noisy=False)
        exact = information_at(reference.problem, reference.truth, setup.scales)
        volume = measuring_volume(exact)
        done, failed = [], 0
        for trial in range(solves):
            progress((i + trial / solves) / len(setups), setup.name)
            draw = draw_session(station, np.random.default_rng([setup.seed, trial]))
            try:
                done.append(_solve_draw(draw, exact, volume))
            except Exception as refusal:  # counted, with what it was
                failed += 1
                progress((i + trial / solves) / len(setups), f"{setup.name}: {refusal}")
        results.append(_summarise(setup, exact, volume, done, failed))
    return results


def _solve_draw(draw: Draw, exact: AdjustmentResult, volume: Volume) -> _Solve:
    truth = exact.state
    began = time.perf_counter()
    found = solve_adjustment(draw.problem, draw.start)
    seconds = time.perf_counter() - began
    state = found.state
    solved = solve_adjustment(draw.problem, draw.start, exact.scales)
    in_cam = sensor_points(state.camera, state.plane, volume.uv_px)
    true_in_cam = sensor_points(truth.camera, truth.plane, volume.uv_px)
    errors = _flange_points(state, volume) - volume.points_flange_mm
    across = plane_across_view(truth, volume)
    J = sensor_jacobian(state, volume.uv_px)
    squares = np.einsum("gik,kl,gil->g", J, found.uncertainty[SENSOR, SENSOR], J)
    own = Volume(volume.uv_px, _flange_points(state, volume))
    plane = plane_uncertainty(found, own)
    fitted = apply(rigid_fit(true_in_cam, in_cam), in_cam) - true_in_cam
    return _Solve(
        errors,
        _flange_points(solved.state, volume) - volume.points_flange_mm,
        1e3 * float(np.sqrt(np.mean(np.sum(fitted**2, axis=1)))),
        across.line @ (errors @ across.normal),
        float(np.mean(squares)),
        (plane.angle_arcsec, plane.offset_um),
        seconds,
    )


def _flange_points(state: AdjustmentState, volume: Volume) -> Floats:
    return apply(state.T_flange_cam, sensor_points(state.camera, state.plane, volume.uv_px))


def _summarise(
    setup: SetUp, exact: AdjustmentResult, volume: Volume, done: list[_Solve], failed: int
) -> SetUpResult:
    J = sensor_jacobian(exact.state, volume.uv_px)
    squares = np.einsum("gik,kl,gil->g", J, exact.covariance[SENSOR, SENSOR], J)
    bound_mm = float(np.sqrt(np.mean(squares)))
    square = np.array([np.mean(np.sum(one.errors_mm**2, 1)) for one in done])
    known = np.array([np.mean(np.sum(one.known_scales_errors_mm**2, 1)) for one in done])
    lines = np.array([one.line for one in done])
    claimed = np.array([one.plane_claimed for one in done])

    def rms(values: Floats) -> float:
        return float(np.sqrt(np.mean(values**2)))

    return SetUpResult(
        setup.name,
        len(done),
        failed,
        1e3 * float(np.sqrt(np.mean(square))),
        1e3 * bound_mm,
        ratio(square, bound_mm),
        ratio(square - known + bound_mm**2, bound_mm),
        1e3 * float(np.sqrt(np.mean([one.claimed_mm2 for one in done]))),
        rms(np.array([one.in_sensor_um for one in done])),
        float(np.degrees(rms(lines[:, 1])) * 3600),
        rms(claimed[:, 0]),
        1e3 * rms(lines[:, 0]),
        rms(claimed[:, 1]),
        float(np.median([one.seconds for one in done])),
    )


def table(results: list[SetUpResult]) -> list[tuple[str, ...]]:
    """Rows to print, for the columns of ``COLUMNS``."""
    return [
        (
            kept.name,
            f"{kept.solves}" + (f" ({kept.failed} failed)" if kept.failed else ""),
            f"{kept.rms_um:.1f}",
            str(kept.over_bound),
            str(kept.without_sampling),
            f"{kept.claimed_over_observed:.2f}",
            f"{kept.sensor_um:.2f}",
            f"{kept.angle:.1f} ({kept.angle_claimed / kept.angle:.2f})",
            f"{kept.offset_um:.1f} ({kept.offset_claimed_um / kept.offset_um:.2f})",
            f"{kept.solve_s:.2f}",
        )
        for kept in results
    ]


COLUMNS = (
    "set-up",
    "solves",
    "rms, µm",
    "rms / bound",
    "without sampling variation",
    "claimed / seen",
    "sensor, µm",
    "plane ″ (claimed / seen)",
    "offset µm (claimed / seen)",
    "solve, s",
)
