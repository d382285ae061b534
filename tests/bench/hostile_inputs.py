"""Hostile inputs of all kinds, varied by a seed: what fell, and in which try.

    python -m tests.bench hostile-inputs [--tries 10000] [--seed 0] [--only KIND …] [--at-once 2]

Certificates that are uploaded, messages of the live connection, places of an archive, addresses of
devices, answers of a provider of accounts, clouds of every format, cells of exported tables, and
files in the folders of datasheets, with which the station is started again. A try falls if it ends
in anything but an answer or a refusal: an error of the program, an end of the process, more than a
minute, another file touched, or a cell that a spreadsheet program runs. A kind runs in a process
of its own, which is replaced when it ends or hangs. ``--only KIND --seed S`` tries the same again.
"""

import hashlib
import os
import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, ExitStack
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

from crenel.errors import OperationError
from crenel_hardware.errors import DeviceError
from tests.bench.hostile import files, sent, stations
from tests.bench.hostile.falling import FallenError
from tests.bench.rows import bench_parser, measured_rows

HANG_S, START_S = 60.0, 1800.0
"""A try may take so long; the start of a process, which starts a station, longer."""
MOST_SHOWN = 5
Try = Callable[[random.Random], str]
"""``taken`` or ``refused``; raises what fell."""
Kind = Callable[[Path], AbstractContextManager[Try]]
"""In a folder that is its own."""
KINDS: Mapping[str, tuple[float, Kind]] = {
    "certificates": (0.14, stations.certificates),
    "live messages": (0.12, stations.live_messages),
    "datasheets and a start": (0.1, stations.started_with),
    "archive places": (0.08, files.archive_places),
    "device addresses": (0.08, sent.device_addresses),
    "provider answers": (0.06, sent.provider_answers),
    "clouds": (0.34, files.clouds),
    "table cells": (0.08, files.table_cells),
}
"""With their shares of the tries."""


def main() -> int:
    parser = bench_parser(__doc__ or "")
    parser.add_argument("--tries", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", choices=list(KINDS), nargs="+", default=list(KINDS))
    parser.add_argument("--at-once", type=int, default=2, help="kinds")
    given = parser.parse_args()
    fallen = 0
    with (
        measured_rows(given.json) as rows,
        tempfile.TemporaryDirectory() as folder,
        ThreadPoolExecutor(given.at_once) as pool,
    ):

        def try_one(name: str) -> None:
            nonlocal fallen
            tries = max(round(given.tries * KINDS[name][0]), 1)
            counts, longest_s = try_kind(name, given.seed, tries, Path(folder) / name, rows.say)
            fell = tries - counts["taken"] - counts["refused"]
            values = {"tries": tries, "taken": counts["taken"], "refused": counts["refused"]}
            rows.add(name, {**values, "fell": fell, "longest s": longest_s})
            fallen += fell

        list(pool.map(try_one, given.only))
    return int(fallen > 0)


def try_kind(
    name: str, seed: int, tries: int, folder: Path, say: Callable[[str], None]
) -> tuple[Counter[str], float]:
    """Tries a kind; what became of the tries, and how long the longest took."""
    own, others = folder / "own", folder / "others"
    own.mkdir(parents=True)
    others.mkdir()
    for canary in ("station.db", "private.key", "notes.txt"):
        (others / canary).write_bytes(canary.encode() * 100)
    before, counts, longest_s, number = content_of(others), Counter[str](), 0.0, 0
    while number < tries:
        longest_s, number = _try_on(name, seed, number, tries, own, counts, longest_s, say)
    if content_of(others) != before:
        counts["other files"] += 1
        counts["refused"] -= 1
        say(f"  {name}: other files were touched")
    return counts, longest_s


def _try_on(
    name: str,
    seed: int,
    first: int,
    tries: int,
    folder: Path,
    counts: Counter[str],
    longest_s: float,
    say: Callable[[str], None],
) -> tuple[float, int]:
    """Tries in one process, until it ends; the longest so far and the next number."""
    context = get_context("forkserver")
    context.set_forkserver_preload([one.__name__ for one in (files, sent, stations)])
    reports, sending = context.Pipe(duplex=False)
    own = folder / str(first)
    own.mkdir()
    process = context.Process(target=_work, args=(name, seed, first, tries, own, sending))
    process.start()
    sending.close()
    number, why, patience_s = first, "", START_S
    while number < tries:
        began_s = time.monotonic()
        if not reports.poll(patience_s):
            why = "hang"
            break
        try:
            kind, text = reports.recv()
        except EOFError:
            process.join(HANG_S)
            why = f"end of the process with {process.exitcode}"
            break
        if kind == "ready":
            patience_s = HANG_S
            continue
        counts[kind] += 1
        if kind not in ("taken", "refused") and counts[kind] <= MOST_SHOWN:
            say(f"  {name} {number}: {kind}: {text}")
        longest_s = max(longest_s, time.monotonic() - began_s)
        number += 1
    if why:
        counts[why] += 1
        say(f"  {name} {number}: {why}")
        number += 1
        process.kill()
    process.join()
    return longest_s, number


def _work(name: str, seed: int, first: int, tries: int, folder: Path, sending: Connection) -> None:
    """What a process does; nothing that it prints is of interest."""
    os.chdir(folder)
    with Path(os.devnull).open("w") as nothing, ExitStack() as stack:
        os.dup2(nothing.fileno(), sys.stdout.fileno())
        os.dup2(nothing.fileno(), sys.stderr.fileno())
        attempt = stack.enter_context(KINDS[name][1](folder))
        sending.send(("ready", ""))
        for number in range(first, tries):
            sending.send(outcome_of(attempt, random.Random(f"{name} {seed} {number}")))


def outcome_of(attempt: Try, rng: random.Random) -> tuple[str, str]:
    try:
        return attempt(rng), ""
    except (OperationError, DeviceError):
        return "refused", ""
    except FallenError as error:
        return error.kind, str(error)
    except BaseException as error:
        return type(error).__name__, repr(error)[:300]


def content_of(folder: Path) -> Mapping[str, str]:
    """Names and hashes of the files in a folder."""
    return {one.name: hashlib.sha256(one.read_bytes()).hexdigest() for one in folder.iterdir()}


if __name__ == "__main__":
    sys.exit(main())
