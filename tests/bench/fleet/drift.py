"""How often *Drift* accuses a healthy recording, and how often it finds a wrong calibration."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

import numpy as np

from crenel.metrology.calibration_levels import OUTSIDE_SHARE, find_calibration_levels
from crenel.metrology.change_points import find_changes
from crenel.metrology.figure_history import FigureHistory, find_history
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress

START = datetime(2026, 1, 1, tzinfo=UTC)
MONTHS, MONTH_DAYS = 10, 30
SCATTER_UM = 2.0
SEED = 1
CORRELATION = 0.4
Levels = tuple[float, ...]


@dataclass(frozen=True)
class MonthsCase:
    """A station with one calibration a month, some of them wrong."""

    wrong_um: Levels
    """Of each month; 0 is right."""
    spread_um: float
    """Standard deviation of the own errors of all calibrations."""
    every_days: int
    """Between two tests."""


@dataclass(frozen=True)
class MonthsResult:
    """In which share of the simulated stations something was named."""

    case: MonthsCase
    found: float | None
    """All wrong months are in periods; None if none is wrong."""
    noted: float | None
    """All wrong months are in periods, or called perhaps wrong, or have a value that stands out."""
    accused: float
    """A month that is not wrong is in a period."""


@dataclass(frozen=True)
class FalseChanges:
    """In which share of the series without a change one was found."""

    values: int
    independent: float
    correlated: float
    """Each value has ``CORRELATION`` of the one before."""


@dataclass(frozen=True)
class LimitResult:
    """What a limit of calibrations outside means, as shares of simulated stations."""

    calibrations: int
    limit: float
    """As ``share`` of ``find_outside``."""
    accused: float
    """No calibration is wrong, and one is outside."""
    doubted: float
    """No calibration is wrong, and one is only called perhaps wrong."""
    found: float
    """A wrong calibration is outside."""
    noted: float
    """It is outside or called perhaps wrong."""


CASES = (
    *(MonthsCase((0.0,) * MONTHS, spread, 3) for spread in (0.0, 3.0)),
    *(MonthsCase((0.0,) * 4 + (um,) + (0.0,) * 5, 0.0, 3) for um in (6.0, 12.0)),
    MonthsCase((12.0,) + (0.0,) * 9, 0.0, 3),
    MonthsCase((0.0,) * 3 + (12.0, 6.0) + (0.0,) * 5, 0.0, 3),
    MonthsCase((0.0,) * 5 + (12.0,) * 5, 0.0, 3),
    *(MonthsCase((0.0,) * 4 + (um,) + (0.0,) * 5, 3.0, 3) for um in (14.0, 24.0, 30.0)),
    MonthsCase((0.0,) * 5 + (20.0,) * 5, 3.0, 3),
    *(MonthsCase((0.0,) * 4 + (12.0,) + (0.0,) * 5, 0.0, days) for days in (10, 15)),
)
LIMIT_CASES = (
    *((10, share) for share in (0.0025, 0.005, 0.01, 0.02)),
    *((count, OUTSIDE_SHARE) for count in (6, 20, 40)),
)
"""Calibrations of a station, and the limit by which one of them is outside."""
LIMIT_SPREAD_UM, LIMIT_WRONG_UM = 3.0, 14.0
TESTS_OF_EACH = 10
COUNTS = (6, 8, 12, 20, 30, 60, 100)


LIMIT_COLUMNS = (
    "calibrations",
    "limit, %",
    "healthy accused, %",
    "healthy perhaps wrong, %",
    "wrong found, %",
    "or noted, %",
)
MONTH_COLUMNS = (
    "own errors, µm",
    "months wrong",
    "by, µm",
    "a test every",
    "found, %",
    "or noted, %",
    "healthy accused, %",
)
SERIES_COLUMNS = ("values", "independent, %", "correlated, %")


def run_months(
    repeats: int, progress: Progress = no_progress, cases: Sequence[MonthsCase] = CASES
) -> list[MonthsResult]:
    """Simulates stations of each case, and looks at what is named."""
    found = []
    for number, case in enumerate(cases):
        found.append(_measure_months(case, repeats))
        progress((number + 1) / len(cases), "")
    return found


def run_series(
    repeats: int, progress: Progress = no_progress, counts: Sequence[int] = COUNTS
) -> list[FalseChanges]:
    """Looks for changes in series that have none."""
    rng = np.random.default_rng(SEED)
    found = []
    for number, count in enumerate(counts):
        independent = _share_changed([rng.normal(size=count) for _ in range(repeats)])
        correlated = _share_changed([_draw_correlated(rng, count) for _ in range(repeats)])
        found.append(FalseChanges(count, independent, correlated))
        progress((number + 1) / len(counts), "")
    return found


def run_limits(
    repeats: int, progress: Progress = no_progress, cases: Sequence[tuple[int, float]] = LIMIT_CASES
) -> list[LimitResult]:
    """Counts by each limit which calibrations are outside, with and without a wrong one."""
    found = []
    for number, (calibrations, limit) in enumerate(cases):
        healthy = _list_by_limit(calibrations, limit, 0.0, repeats)
        wrong = _list_by_limit(calibrations, limit, LIMIT_WRONG_UM, repeats)
        middle = _name(calibrations // 2)
        found.append(
            LimitResult(
                calibrations,
                limit,
                sum(bool(outside) for outside, _ in healthy) / repeats,
                sum(bool(doubtful) and not outside for outside, doubtful in healthy) / repeats,
                sum(middle in outside for outside, _ in wrong) / repeats,
                sum(middle in outside | doubtful for outside, doubtful in wrong) / repeats,
            )
        )
        progress((number + 1) / len(cases), "")
    return found


def table_of_limits(results: Sequence[LimitResult]) -> list[tuple[str, ...]]:
    """A row for each number of calibrations and limit."""
    return [
        (
            str(one.calibrations),
            f"{100 * one.limit:g}",
            *(_percent(share) for share in (one.accused, one.doubted, one.found, one.noted)),
        )
        for one in results
    ]


def table_of_months(results: Sequence[MonthsResult]) -> list[tuple[str, ...]]:
    """A row for each case."""
    rows: list[tuple[str, ...]] = []
    for one in results:
        wrong = [(str(month + 1), um) for month, um in enumerate(one.case.wrong_um) if um]
        rows.append(
            (
                f"{one.case.spread_um:g}",
                ", ".join(month for month, _ in wrong) or "none",
                ", ".join(dict.fromkeys(f"{um:g}" for _, um in wrong)) or "–",
                f"{one.case.every_days} days",
                _percent(one.found),
                _percent(one.noted),
                _percent(one.accused),
            )
        )
    return rows


def table_of_series(results: Sequence[FalseChanges]) -> list[tuple[str, ...]]:
    """A row for each number of values."""
    return [
        (str(one.values), _percent(one.independent), _percent(one.correlated)) for one in results
    ]


def simulate_months(case: MonthsCase, rng: np.random.Generator) -> FigureHistory:
    """The history of one station."""
    days = range(1, MONTHS * MONTH_DAYS, case.every_days)
    levels = np.array(case.wrong_um) + case.spread_um * rng.normal(size=MONTHS)
    months = [day // MONTH_DAYS for day in days]
    values = 28.0 + levels[months] + SCATTER_UM * rng.normal(size=len(months))
    times = [START + timedelta(days=day) for day in days]
    return find_history(times, values.tolist(), [_name(month) for month in months])


def list_named_months(history: FigureHistory) -> set[int]:
    """The months with a day that is surely in a period."""
    return {
        day // MONTH_DAYS
        for period in history.periods
        for day in range(MONTHS * MONTH_DAYS)
        if period.surely_contains(START + timedelta(days=day))
    }


def _measure_months(case: MonthsCase, repeats: int) -> MonthsResult:
    rng = np.random.default_rng(SEED)
    wrong = {month for month, um in enumerate(case.wrong_um) if um}
    found = noted = accused = 0
    for _ in range(repeats):
        history = simulate_months(case, rng)
        named = list_named_months(history)
        noticed = {one.calibration_id for one in history.standing_out}
        noticed.update(one.calibration_id for one in history.spread.doubtful)
        perhaps = {int(one.removeprefix("cal-")) for one in noticed}
        found += wrong <= named
        noted += wrong <= named | perhaps
        accused += bool(named - wrong)
    if not wrong:
        return MonthsResult(case, None, None, accused / repeats)
    return MonthsResult(case, found / repeats, noted / repeats, accused / repeats)


def _list_by_limit(
    calibrations: int, limit: float, wrong_um: float, repeats: int
) -> list[tuple[set[str], set[str]]]:
    """Of each simulated station, the calibrations outside, and those that are perhaps wrong; the
    middle one is wrong."""
    rng = np.random.default_rng(SEED)
    used = [_name(number) for number in range(calibrations) for _ in range(TESTS_OF_EACH)]
    named = []
    for _ in range(repeats):
        levels = LIMIT_SPREAD_UM * rng.normal(size=calibrations)
        levels[calibrations // 2] += wrong_um
        values = np.repeat(levels, TESTS_OF_EACH) + SCATTER_UM * rng.normal(size=len(used))
        found = find_calibration_levels(values, used, limit)
        assert found is not None
        named.append((set(found.outside), set(found.doubtful)))
    return named


def _name(number: int) -> str:
    return f"cal-{number}"


def _share_changed(series: Sequence[Floats]) -> float:
    return sum(bool(find_changes(one)) for one in series) / len(series)


def _draw_correlated(rng: np.random.Generator, count: int) -> Floats:
    values = rng.normal(size=count)
    for index in range(1, count):
        values[index] += CORRELATION * values[index - 1]
    return values


def _percent(share: float | None) -> str:
    return "–" if share is None else f"{100 * share:.1f}"
