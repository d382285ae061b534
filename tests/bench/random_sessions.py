"""Do claims hold, and is nothing doubted that is well, over sessions of every kind?

    python -m tests.bench.random_sessions [--sessions 60]

Sessions are rendered with one to twelve poses, six or seven joints, arms off by 0 to 250 um in
their links or their parameters, three to five faces touched at 8 or 15 points each, one picture
or two a pose, any roll of the camera, and calibrated as the command line does.
"""

import argparse
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from app.errors import OperationError
from app.formats.session.calibration_session import read_session
from app.metrology.adjustment.block.calibrate import calibrate_block
from app.workflows.calibrate import joint_inputs
from hardware.simulator.devices.kinematics import ErrorSource
from hardware.simulator.session import SessionPlan
from tests.bench.rows import rms
from tests.bench.sessions import draw_camera, draw_sessions, errors_um

FIRST_SEED = 8001
FACES = ("crest", "front", "left", "right", "back")
KINDS: tuple[ErrorSource, ...] = ("links", "parameters")


def draw_plan(rng: np.random.Generator) -> SessionPlan:
    return SessionPlan(
        joints=int(rng.integers(6, 8)),
        poses=int(rng.choice([1, 2, 3, 4, 6, 8, 12])),
        imperfection_um=float(rng.choice([0, 30, 100, 250])),
        wrong_in=KINDS[int(rng.integers(2))],
        lighting=str(rng.choice(["pair", "both"])),
        **draw_camera(rng),
        faces=FACES[: int(rng.integers(3, 6))],
        contacts_per_face=int(rng.choice([8, 15])),
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sessions", type=int, default=60)
    wanted = parser.parse_args().sessions
    with tempfile.TemporaryDirectory() as scratch:
        measure_sessions(draw_sessions(wanted, FIRST_SEED, draw_plan, Path(scratch)))


def measure_sessions(folders: Iterable[Path]) -> None:
    """Prints error over claim in the flange frame, and what is bad or needs attention."""
    ratios: dict[str, list[float]] = defaultdict(list)
    doubted: Counter[str] = Counter()
    for folder in folders:
        try:
            found = calibrate_block(joint_inputs(read_session(folder)))
        except OperationError as refusal:
            doubted["refused"] += 1
            print(f"{folder.name} refused: {refusal}", flush=True)
            continue
        doubted.update(one.code for one in found.findings if one.quality in ("bad", "attention"))
        plan = draw_plan(np.random.default_rng(int(folder.name)))
        kinds = ("all", f"{plan.poses:2d} poses", f"arm off by {plan.imperfection_um:3.0f} um")
        for kind in (*kinds, f"{len(plan.faces)} faces"):
            ratios[kind].append(errors_um(found, folder)[1] / found.uncertainty.total_um)
    print(f"{'error over claim, flange frame':<34}{'sessions':>10}{'rms':>8}{'largest':>10}")
    for kind, values in sorted(ratios.items()):
        print(f"{kind:<34}{len(values):>10}{rms(np.array(values)):>8.2f}{max(values):>10.2f}")
    for code, count in doubted.most_common():
        print(f"{code:<34}{count:>10}")


if __name__ == "__main__":
    main()
