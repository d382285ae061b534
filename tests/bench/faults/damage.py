"""A station on a data folder in which something is damaged or foreign."""

import os
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

import httpx

from crenel.errors import OperationError
from crenel.progress import Progress, no_progress
from tests.bench.faults.damages import Damage, database_damages, file_damages, folder_damages
from tests.bench.faults.furnished import FolderRecords, furnish
from tests.bench.faults.looking import TRACE, query_station
from tests.bench.faults.row import FaultRow
from tests.bench.faults.station import ENDED, StationProcess

STARTED_MODULES = ()  # programs of others

NOBODY = 65534
SAMPLED = 30
"""Of all ways in all places."""
LONGEST_LINE = 600


def run(
    data: Path,
    tries: int = SAMPLED,
    seed: int = 0,
    words: str = "",
    progress: Progress = no_progress,
    kept: FolderRecords | None = None,
) -> FaultRow:
    """Damages copies of a furnished folder, each in one way, and looks at the station on it.

    It must start and report what is wrong, or refuse in one line; then it answers everything,
    acts, and ends on request.

    Args:
        data: a folder for the station's own, which is made.
        tries: how many of all ways in all places, besides those of database and folders.
        words: only damages whose names have them.
        kept: what is in the folder, where it is furnished already.
    """
    kept = kept or furnish(data, progress)
    rng, row = random.Random(seed), FaultRow("a damaged data folder")
    everywhere = file_damages(kept)
    damages = [*database_damages(kept), *folder_damages()]
    damages += rng.sample(everywhere, min(tries, len(everywhere))) if not words else everywhere
    damages = [damage for damage in damages if words in damage.name]
    if not _is_runnable_by(NOBODY):
        damages = [damage for damage in damages if not damage.by_others]
    for number, damage in enumerate(damages):
        progress(number / len(damages), f"a damaged folder: {damage.name}")
        copy = data.with_name(f"{data.name}-damaged")
        shutil.copytree(data, copy, symlinks=True)
        try:
            _try(copy, damage, kept, rng, row)
        finally:
            shutil.rmtree(copy)
    return row


def _is_runnable_by(user: int) -> bool:
    """Whether another user could run a station here; as a plain user, this one is another."""
    if os.getuid() != 0:
        return True
    try:
        looked = subprocess.run([sys.executable, "-c", "import crenel"], user=user, check=False)
    except PermissionError:
        return False
    return looked.returncode == 0


def _try(
    copy: Path, damage: Damage, kept: FolderRecords, rng: random.Random, row: FaultRow
) -> None:
    user = None
    if damage.by_others and os.getuid() == 0:
        user = NOBODY
        for path in (copy.parent, copy, *copy.rglob("*")):
            os.chown(path, NOBODY, NOBODY, follow_symlinks=False)
    damage.do(copy, rng)
    with StationProcess(copy, user=user) as station:
        try:
            station.enter()
        except OperationError as refusal:
            ended = refusal.code == ENDED
            why = _check_rejection(station, damage) if ended else refusal.line
            row.count_try(not why, note=f"{damage.name}: {why}" if why else "")
            return
        except httpx.HTTPStatusError as error:  # accounts are on a damaged page
            answer = error.response
            clear = (
                answer.is_client_error
                and damage.expected_message
                and re.search(damage.expected_message, answer.text)
            )
            row.count_try(bool(clear), note="" if clear else f"{damage.name}: {answer.text[:200]}")
            return
        wrong, lost = _check_service(station, damage, kept, row)
        notes = "; ".join([*wrong, *lost])
        row.count_try(
            not wrong and not lost, bool(lost), f"{damage.name}: {notes}" if notes else ""
        )


def _check_rejection(station: StationProcess, damage: Damage) -> str:
    """What is wrong with how a station refused to start; empty where nothing is."""
    lines = [line for line in station.console_text.splitlines() if not line.startswith("(viser)")]
    last = lines[-1] if lines else ""
    if TRACE in station.console_text:
        return f"a trace: {last}"
    if station.status != 1 or not last or len(last) > LONGEST_LINE:
        return f"it ended with {station.status}: {last[:200]}"
    named = re.escape(damage.name.partition(":")[0])
    if not re.search(
        f"{named}|{damage.expected_message}" if damage.expected_message else named, last
    ):
        return f"it refused: {last}"
    return ""


def _check_service(
    station: StationProcess, damage: Damage, kept: FolderRecords, row: FaultRow
) -> tuple[list[str], list[str]]:
    """What is wrong with a station that runs, and what it has lost."""
    ids = {"scan_id": list(kept.scans), "calibration_id": [kept.calibration]}
    ids |= {
        "record_id": [kept.calibration, kept.performance],
        "form": ["html"],
        "name": ["pose-1.png"],
    }
    ids |= {"performance_id": [kept.performance]}
    try:
        look = query_station(station, ids)
        row.note_stop(station.stop_s())
        lost = [
            f"{one} is not listed"
            for one in kept.records
            if one not in damage.affected_ids and not look.mentions(one)
        ]
        wrong = look.faults
        if damage.expected_message and not look.mentions(damage.expected_message):
            wrong.append("nothing is reported of it")
        station.end()
    except OperationError as refusal:
        return [refusal.line], []
    return wrong, lost
