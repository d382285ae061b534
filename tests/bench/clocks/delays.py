"""The delay between arm and camera in simulated passes: value, uncertainty, jumps and drift."""

import os
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from multiprocessing import get_context

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text
from crenel.metrology.time_delay.course import PPM
from crenel.metrology.time_delay.delay import ClockDelay, estimate_delay
from crenel.progress import Progress, no_progress
from tests.bench.clocks.passes import Lateness, PassPlan, PlannedJump, simulate_pass

KINDS = (
    "constant",
    "jump",
    "drift",
    "jumps and drift",
    "at rest",
    "late packets",
    "late batches",
    "late by a wandering time",
)
SHARES = (100, 80, 60, 30, 30, 40, 40, 40)
"""Of 420 passes."""
LONGEST_DELAY_S = 5.0
LEAST_JUMP_S, LEAST_DRIFT_PPM = 2e-3, 20.0
WITHIN = 3.0
"""In standard uncertainties."""
COLUMNS: tuple[Text, ...] = (
    "passes",
    "number",
    "within 3 u",
    "u, median µs",
    "jumps named",
    "drifts named",
    "false jumps",
    "false drifts",
    "refused",
)


@dataclass(frozen=True)
class PassKind:
    """What was found in passes of one kind."""

    kind: str
    passes: int
    within: int
    """Passes whose delay at the last frame lies within three standard uncertainties."""
    median_uncertainty_ms: float | None
    jumps: int
    jumps_named: int
    drifts: int
    drifts_named: int
    false_jumps: int
    false_drifts: int
    refused: dict[str, int]
    """Number of refused passes by the code of the refusal."""


@dataclass(frozen=True)
class _Outcome:
    plan: PassPlan
    found: ClockDelay | None
    refused: str = ""


def plan_pass(kind: str, seed: int) -> PassPlan:
    """A pass of a kind; everything else is drawn."""
    random = np.random.default_rng([seed, KINDS.index(kind)])
    waves = int(random.integers(2, 5))
    movement = np.column_stack(
        [
            random.uniform(3, 10, waves),
            random.uniform(0.2, 0.9, waves),
            random.uniform(0, 2 * np.pi, waves),
        ]
    )
    plan = PassPlan(
        seed,
        delay_s=float(random.uniform(-LONGEST_DELAY_S, LONGEST_DELAY_S)),
        seconds=float(random.uniform(20, 40)),
        frames_hz=float(random.uniform(15, 60)),
        readings_hz=float(random.choice([100.0, 125.0, 250.0, 500.0, 1000.0])),
        point_sd_mm=float(random.uniform(0.005, 0.02)),
        arm_sd_mm=float(random.uniform(0.003, 0.03)),
        bent_mm=float(random.uniform(0, 0.02)),
        at_rest=kind == "at rest",
        movement=movement,
    )
    if "drift" in kind:
        sign = float(random.choice([-1.0, 1.0]))
        drift_ppm = sign * LEAST_DRIFT_PPM * float(10 ** random.uniform(0, 1.2))
        plan = replace(plan, drift_ppm=drift_ppm, seconds=float(random.uniform(60, 120)))
    if "jump" in kind:
        plan = replace(plan, jumps=_plan_jumps(plan, random))
    return replace(plan, lateness=_plan_lateness(kind, plan.readings_hz, random))


def _plan_lateness(kind: str, readings_hz: float, random: np.random.Generator) -> Lateness:
    """Packets late by 1 to 30 ms, of one reading or of 5 to 40 ms of readings; a lateness that
    wanders by 0.3 to 20 ms within 4 to 15 s."""
    if kind == "late packets":
        return Lateness(packet_s=1e-3 * float(30 ** random.uniform(0, 1)))
    if kind == "late batches":
        seconds = 5e-3 * float(8 ** random.uniform(0, 1))
        late_s = float(random.choice([0.0, 1e-3, 5e-3]))
        return Lateness(late_s, max(round(seconds * readings_hz), 2))
    if kind == "late by a wandering time":
        wander_s = 0.3e-3 * float(60 ** random.uniform(0, 1))
        return Lateness(wander_s=wander_s, wander_hz=1 / float(random.uniform(4, 15)))
    return Lateness()


def _plan_jumps(plan: PassPlan, random: np.random.Generator) -> tuple[PlannedJump, ...]:
    """One jump or two of 2 ms to 2 s, which leave the delay within what is searched."""
    count = int(random.integers(1, 3))
    jumps: list[PlannedJump] = []
    # where the arm's poses are known in spite of the delay
    first_s, last_s = 4.0 + max(-plan.delay_s, 0.0), plan.seconds - 4.0 - max(plan.delay_s, 0.0)
    delay_s = plan.delay_s
    for number in range(count):
        change_s = LEAST_JUMP_S * float(10 ** random.uniform(0, 3))
        change_s *= -1.0 if delay_s > 0 else 1.0
        delay_s += change_s
        at_s = first_s + (last_s - first_s) * (number + float(random.uniform(0.2, 0.8))) / count
        jumps.append(PlannedJump(at_s, change_s, bool(random.random() < 0.3)))
    return tuple(jumps)


def run(passes: int = 420, seed: int = 0, progress: Progress = no_progress) -> list[PassKind]:
    """Passes of all kinds, on all cores."""
    wanted = [
        (kind, seed + number)
        for kind, share in zip(KINDS, SHARES, strict=True)
        for number in range(max(round(passes * share / sum(SHARES)), 1))
    ]
    outcomes: dict[str, list[_Outcome]] = {kind: [] for kind in KINDS}
    context = get_context("spawn")
    with ProcessPoolExecutor(os.cpu_count() or 1, mp_context=context) as pool:
        for number, one in enumerate(pool.map(_try_pass, wanted), 1):
            outcomes[wanted[number - 1][0]].append(one)
            progress(number / len(wanted), f"{number} of {len(wanted)} passes")
    return [_judge(kind, outcomes[kind]) for kind in KINDS]


def _try_pass(wanted: tuple[str, int]) -> _Outcome:
    plan = plan_pass(*wanted)
    try:
        return _Outcome(plan, estimate_delay(simulate_pass(plan)))
    except OperationError as error:
        return _Outcome(plan, None, error.code)


def _judge(kind: str, outcomes: Sequence[_Outcome]) -> PassKind:
    found = [(one.plan, one.found) for one in outcomes if one.found is not None]
    codes = [one.refused for one in outcomes if one.refused]
    named = [count_named_jumps(plan, delay) for plan, delay in found]
    drifting = [(plan, delay) for plan, delay in found if plan.drift_ppm]
    return PassKind(
        kind,
        passes=len(outcomes),
        within=sum(pull(plan, delay) <= WITHIN for plan, delay in found),
        median_uncertainty_ms=float(np.median([one.standard_uncertainty_ms for _, one in found]))
        if found
        else None,
        jumps=sum(len(one.plan.jumps) for one in outcomes),
        jumps_named=sum(named),
        drifts=sum(one.plan.drift_ppm != 0 for one in outcomes),
        drifts_named=sum(abs(drift_pull(plan, delay)) <= WITHIN for plan, delay in drifting),
        false_jumps=sum(
            len(delay.jumps) - count for (_, delay), count in zip(found, named, strict=True)
        ),
        false_drifts=sum(
            delay.course.drift_ppm != 0 for plan, delay in found if not plan.drift_ppm
        ),
        refused={code: codes.count(code) for code in sorted(set(codes))},
    )


def pull(plan: PassPlan, found: ClockDelay) -> float:
    """Error of the delay at the last frame, in standard uncertainties."""
    last_s = np.array([plan.seconds])
    stamp_s = plan.camera_stamps_s(last_s)
    # the same delay a moment later, by the course's own stamp
    late_s = found.course.stamp_ns / 1e9 - 1000.0 - float(stamp_s[0])
    true_s = (
        float((plan.delay_at_s(last_s) + plan.lateness_at_s(last_s))[0])
        + PPM * plan.drift_ppm * late_s
    )
    return abs(found.delay_ms - 1e3 * true_s) / found.standard_uncertainty_ms


def drift_pull(plan: PassPlan, found: ClockDelay) -> float:
    """Error of the drift in standard uncertainties; infinite if none was named."""
    if not found.course.drift_ppm:
        return np.inf
    return (found.course.drift_ppm - plan.drift_ppm) / found.drift_uncertainty_ppm


def count_named_jumps(plan: PassPlan, found: ClockDelay) -> int:
    """How many of the plan's jumps were found, with their change and their time."""
    count = 0
    for jump in plan.jumps:
        before_s = float(plan.camera_stamps_s(np.array([jump.at_s - 1e-9]))[0])
        behind_s = float(plan.camera_stamps_s(np.array([jump.at_s]))[0])
        count += any(
            abs(one.jump.change_ns / 1e9 - jump.change_s)
            <= WITHIN * one.change_uncertainty_ms / 1e3
            and min(before_s, behind_s) - WITHIN * one.time_uncertainty_s
            <= one.jump.stamp_ns / 1e9 - 1000.0
            <= max(before_s, behind_s) + WITHIN * one.time_uncertainty_s
            for one in found.jumps
        )
    return count


def table(kinds: Sequence[PassKind]) -> list[list[Text]]:
    """The rows under ``COLUMNS``."""
    return [
        [
            one.kind,
            str(one.passes),
            str(one.within),
            "" if one.median_uncertainty_ms is None else f"{1e3 * one.median_uncertainty_ms:.1f}",
            f"{one.jumps_named} of {one.jumps}",
            f"{one.drifts_named} of {one.drifts}",
            str(one.false_jumps),
            str(one.false_drifts),
            ", ".join(f"{count} × {code}" for code, count in one.refused.items()),
        ]
        for one in kinds
    ]
