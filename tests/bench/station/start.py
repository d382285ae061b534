"""How soon the program is there: from its start to its first page, and to a calibration.

Every copy works with caches of its own in a temporary folder. Cold, they are empty: Python
compiles its modules again, the standard library's too. Copies are measured in turn.
"""

import statistics
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

from crenel.progress import Progress, no_progress
from crenel_hardware.simulator.session import SessionPlan, render_session
from tests.bench.station.started import DemoProcess, InstalledCopy, busy_machine

SEED = 7
Sample = tuple[str, float]
"""What was measured, and its figure."""


@dataclass(frozen=True)
class StartRow:
    """One measure: its median, smallest and largest figure of each copy, by the copy's name."""

    measure: str
    unit: str
    figures: dict[str, tuple[float, float, float]]


@dataclass(frozen=True)
class Rounds:
    """How often each kind is measured."""

    cold: int = 1
    warm: int = 3
    busy: int = 3


def columns(copies: Sequence[InstalledCopy]) -> tuple[str, ...]:
    return ("measure", *(copy.name for copy in copies))


def table(rows: Sequence[StartRow]) -> list[tuple[str, ...]]:
    return [
        (row.measure, *(_format_figures(figures, row.unit) for figures in row.figures.values()))
        for row in rows
    ]


def _format_figures(figures: tuple[float, float, float], unit: str) -> str:
    median, least, most = figures
    decimals = 2 if unit == "s" else 0
    text = f"{median:.{decimals}f} {unit}".rstrip()
    return text if least == most else f"{text} ({least:.{decimals}f}–{most:.{decimals}f})"


def run(
    copies: Sequence[InstalledCopy],
    rounds: Rounds,
    session: Path | None = None,
    progress: Progress = no_progress,
) -> list[StartRow]:
    """All measures of all copies.

    Args:
        session: a folder as ``crenel calibrate`` takes it; one with a scan recording in it is
            rebuilt, too. By default a simulated one without.

    Raises:
        OperationError: a copy does not do what it is asked.
    """
    samples: dict[tuple[str, str], list[float]] = {}
    with tempfile.TemporaryDirectory(prefix="crenel-bench-") as made:
        folder = Path(made)
        if session is None:
            session = folder / "session"
            render_session(session, SEED, SessionPlan())
        all_rounds = list(_rounds(folder, copies, rounds, session.absolute()))
        for i, (copy, measure) in enumerate(all_rounds):
            progress(i / len(all_rounds), f"Starting {copy.name}")
            for name, figure in measure():
                samples.setdefault((name, copy.name), []).append(figure)
    names = list(dict.fromkeys(name for name, _ in samples))
    return [
        StartRow(
            name, _unit(name), {copy.name: _summarise(samples[name, copy.name]) for copy in copies}
        )
        for name in names
    ]


def _summarise(figures: list[float]) -> tuple[float, float, float]:
    return statistics.median(figures), min(figures), max(figures)


def _unit(name: str) -> str:
    if name.endswith("devices lost"):
        return ""
    return "MB" if name.endswith(("RSS", "size")) else "s"


Round = tuple[InstalledCopy, Callable[[], Iterator[Sample]]]


def _rounds(
    folder: Path, copies: Sequence[InstalledCopy], rounds: Rounds, session: Path
) -> Iterator[Round]:
    """Each of them in the order in which it is measured, reversed every second time."""
    warm = {copy: folder / f"warm-{i}" for i, copy in enumerate(copies)}
    number = 0
    for kind, times in (("cold", rounds.cold), ("warm", rounds.warm), ("busy", rounds.busy)):
        for turn in range(times):
            for copy in copies if turn % 2 == 0 else reversed(copies):
                number += 1
                place = folder / f"round-{number}"
                cache = place if kind == "cold" else warm[copy]
                yield copy, _make_measure(copy, kind, cache, place, session)
    for copy in copies:
        yield copy, _make_size_measure(copy)


def _make_measure(
    copy: InstalledCopy, kind: str, cache: Path, place: Path, session: Path
) -> Callable[[], Iterator[Sample]]:
    def measure() -> Iterator[Sample]:
        place.mkdir()
        if kind != "cold" and not cache.exists():
            cache.mkdir()
            list(_commands(copy, cache, session))
            list(_demo(copy, cache, place / "first"))
        with busy_machine() if kind == "busy" else nullcontext():
            for name, figure in _commands(copy, cache, session, cold=kind == "cold", into=place):
                yield f"{kind}: {name}", figure
            for name, figure in _demo(copy, cache, place / "data", cold=kind == "cold"):
                yield f"{kind}: {name}", figure
        if kind == "warm":
            with DemoProcess(copy, cache, place / "idle") as station:
                station.ready_s()
                yield "idle station: RSS", station.idle_mb()

    return measure


def _make_size_measure(copy: InstalledCopy) -> Callable[[], Iterator[Sample]]:
    return lambda: iter([("installed size", copy.size_mb())])


def _demo(copy: InstalledCopy, cache: Path, data: Path, cold: bool = False) -> Iterator[Sample]:
    cache = _cache_folder(cache, "demo", cold)
    with DemoProcess(copy, cache, data) as station:
        yield "first page", station.first_page_s()
        yield "ready", station.ready_s()
        yield "calibrated by the simulated operator", station.calibration_s()
        yield "devices lost", float(station.losses())


def _commands(
    copy: InstalledCopy, cache: Path, session: Path, cold: bool = False, into: Path | None = None
) -> Iterator[Sample]:
    """Each command cold has caches of its own: none finds what another has left there."""
    target = into or cache
    calibration, stripes = target / "calibration.json", target / "stripes.csv"
    picture = min((session / "images").glob("*laser*"), default=None)
    recording = min(session.glob("*.mcap"), default=None)

    def timed(*arguments: str | Path) -> float:
        return copy.seconds(_cache_folder(cache, str(arguments[0]), cold), *arguments)

    yield "crenel --help", timed("--help")
    asked = ("calibrate", session, "--method", "one-pose", "-o", calibration)
    yield "crenel calibrate --method one-pose", timed(*asked)
    if picture is not None:
        yield "crenel extract", timed("extract", picture, "-o", stripes)
    if recording is not None:
        known = ("--calibration", calibration, "--arm", session / "arm.json")
        yield "crenel reconstruct", timed("reconstruct", recording, *known, "-o", target / "c.ply")


def _cache_folder(cache: Path, name: str, cold: bool) -> Path:
    folder = cache / name.strip("-") if cold else cache
    folder.mkdir(exist_ok=True)
    return folder
