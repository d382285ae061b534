"""Plain frames by every processor variant, and by another checkout, in turn in one run.

Each has a process of its own; they take turns of 24 frames, so that all see the same machine.
"""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from crenel.errors import OperationError
from crenel.metrology.transforms import Floats
from crenel.native.library import CRENEL, VARIANT_SETTING
from crenel.progress import Progress
from tests.bench.stripe.frames import simulate_frame

POOL, ROUNDS = 24, 60
DEPTH_BITS = (8, 16)
KINDS = ("hot", "cold")
COLUMNS = ("by", "8 bit, hot", "8 bit, cold", "16 bit, hot", "16 bit, cold")
READING = "one reading of the frame (np.max)"


@dataclass(frozen=True)
class Rates:
    """Frames a second by one method: medians, for ``DEPTH_BITS`` times ``KINDS``."""

    by: str
    per_s: tuple[float, ...]
    shares: tuple[float, ...] | None
    """Of the other checkout's rate, turn by turn, their medians; None without one."""


def run(other: Path | None, progress: Progress) -> list[Rates]:
    """The rates of all variants of this processor, the best first, then of another checkout.

    Args:
        other: the Python interpreter in which the other checkout is installed.

    Raises:
        OperationError: the other interpreter has no Crenel that extracts stripes.
    """
    progress(0.0, "rendering")
    with tempfile.TemporaryDirectory(prefix="crenel-bench-") as folder, ExitStack() as processes:
        frames = Path(folder) / "frames.npz"
        pools = _pools()
        named: dict[str, Any] = {str(bits): pool for bits, pool in pools.items()}
        np.savez(frames, **named)
        workers = {
            variant: processes.enter_context(_worker(Path(sys.executable), frames, variant))
            for variant in reversed(CRENEL.variants)
        }
        if other is not None:
            workers["the other"] = processes.enter_context(_worker(other, frames))
        spent_s = _time_workers(workers, progress)
    spent_s[READING] = np.array([[_reading_s(pools[b], k) for b in DEPTH_BITS for k in KINDS]])
    reference = spent_s.get("the other")
    return [
        Rates(
            by,
            tuple(float(r) for r in 1 / np.median(seconds, axis=0)),
            None
            if reference is None or by == READING
            else tuple(float(s) for s in np.median(reference / seconds, axis=0)),
        )
        for by, seconds in spent_s.items()
    ]


def table(rates: list[Rates]) -> list[list[str]]:
    """Rows for ``COLUMNS``."""
    rows = []
    for one in rates:
        cells = [f"{rate:.0f} /s" for rate in one.per_s]
        if one.shares is not None:
            cells = [f"{cell} ({s:.2f})" for cell, s in zip(cells, one.shares, strict=True)]
        rows.append([one.by, *cells])
    return rows


def _pools() -> dict[int, np.ndarray]:
    """(POOL, H, W) frames of each depth; those of 16 bits hold 12 significant ones."""
    base = [simulate_frame(seed).image for seed in range(8)]
    eight = np.array([np.roll(base[i % len(base)], 17 * i, axis=1) for i in range(POOL)])
    chance = np.random.default_rng(0).integers(0, 16, eight.shape, np.uint16)
    return {8: eight, 16: eight.astype(np.uint16) * 16 + chance}


@contextmanager
def _worker(
    interpreter: Path, frames: Path, variant: str | None = None
) -> Iterator["subprocess.Popen[str]"]:
    """A process that times extraction, ready to be asked."""
    text = (Path(__file__).parent / "worker.py").read_text()
    environment = os.environ if variant is None else os.environ | {VARIANT_SETTING: variant}
    process = subprocess.Popen(
        [str(interpreter), "-c", text, str(frames)],
        env=environment,
        cwd=frames.parent,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    try:
        if process.stdout.readline() != "ready\n":
            raise OperationError(
                "other-checkout",
                f"{interpreter} extracts no stripes",
                "the package crenel cannot be imported there, or is too old",
                "Name the Python of a virtual environment in which Crenel is installed",
            )
        yield process
    finally:
        process.terminate()
        process.communicate()


def _time_workers(
    workers: dict[str, "subprocess.Popen[str]"], progress: Progress
) -> dict[str, Floats]:
    """Seconds a frame (ROUNDS, depths and kinds) of each worker, in turn."""
    spent = {by: np.empty((ROUNDS, len(DEPTH_BITS) * len(KINDS))) for by in workers}
    for turn in range(ROUNDS):
        progress(0.1 + 0.9 * turn / ROUNDS, "timing")
        asked = [f"{kind} {bits}\n" for bits in DEPTH_BITS for kind in KINDS]
        for column, line in enumerate(asked):
            for by, process in workers.items():
                assert process.stdin is not None
                assert process.stdout is not None
                process.stdin.write(line)
                process.stdin.flush()
                spent[by][turn, column] = float(process.stdout.readline())
    return spent


def _reading_s(pool: np.ndarray, kind: str) -> float:
    """Seconds that numpy takes to read a frame once: their median."""
    images = list(pool) if kind == "cold" else [pool[0]] * POOL
    spent = []
    for image in images * 4:
        begin = time.perf_counter()
        np.max(image)
        spent.append(time.perf_counter() - begin)
    return float(np.median(spent))
