"""Every kind of fault, one after the other."""

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from crenel.errors import OperationError
from crenel.progress import Progress, no_progress
from tests.bench.faults import damage, disk, floods, kills
from tests.bench.faults.broker import hostile_broker
from tests.bench.faults.calls import UNAVAILABLE
from tests.bench.faults.row import FaultRow
from tests.bench.station.subprocess_station import convert_connection_errors

Attempt = Callable[[Path, int, Progress], list[FaultRow]]
"""Of a folder, a seed and a progress."""


@dataclass(frozen=True)
class FaultKind:
    """A kind of fault by its name on the command line, and what tries it in a new folder."""

    name: str
    attempt: Attempt


def _kills(name: str, guide: str) -> FaultKind:
    """The station is killed in every step of a guide."""
    return FaultKind(
        name, lambda data, seed, report: [kills.kill_guides(data, guide, progress=report)]
    )


KINDS = (
    FaultKind(
        "kills-in-scans",
        lambda data, seed, report: [kills.kill_scans(data, seed=seed, progress=report)],
    ),
    _kills("kills-in-calibrations", "flow"),
    _kills("kills-in-verifications", "verify"),
    _kills("kills-in-performance-tests", "performance"),
    _kills("kills-in-tests-of-lengths", "lengths"),
    _kills("kills-in-tests-of-scanned-lengths", "scanned-lengths"),
    _kills("kills-in-plane-tests", "plane"),
    _kills("kills-in-contact-tests", "contact"),
    _kills("kills-in-inspections", "parts"),
    FaultKind("disk", lambda data, seed, report: [disk.run(data, seed=seed, progress=report)]),
    FaultKind("damage", lambda data, seed, report: [damage.run(data, seed=seed, progress=report)]),
    FaultKind("floods", lambda data, seed, report: floods.run(data, progress=report)),
    FaultKind("broker", lambda data, seed, report: hostile_broker.run(data, progress=report)),
)


def run(names: list[str], seed: int = 0, progress: Progress = no_progress) -> list[FaultRow]:
    """Tries the kinds of these names, or whose names begin so; all for none.

    A kind that cannot be tried in this installation has a row that says so.

    Raises:
        OperationError: there is no such kind, the only kind cannot be tried here, or a station
            does not go on.
    """
    known = [kind.name for kind in KINDS]
    if unknown := [name for name in names if not any(_has(kind, name) for kind in known)]:
        raise OperationError(
            "bench-kind", f"There is no kind {unknown[0]}", f"there are: {', '.join(known)}"
        )
    chosen = [kind for kind in KINDS if not names or any(_has(kind.name, name) for name in names)]
    rows: list[FaultRow] = []
    with tempfile.TemporaryDirectory(prefix="crenel-bench-") as folder, convert_connection_errors():
        for number, kind in enumerate(chosen):
            share = partial(_share, progress, number, len(chosen))
            try:
                rows += kind.attempt(Path(folder) / kind.name / "data", seed, share)
            except OperationError as error:
                if error.code != UNAVAILABLE or len(chosen) == 1:
                    raise
                rows.append(FaultRow(kind.name, notes=[error.line]))
    return rows


def _has(kind: str, name: str) -> bool:
    """``kills`` stands for all kinds of kills."""
    return kind == name or kind.startswith(f"{name}-")


def _share(progress: Progress, number: int, of: int, share: float, text: str) -> None:
    progress((number + share) / of, text)
