"""Robot poses before a board: how often a good one is excluded, and a bad one found.

    python -m tests.bench robot-poses [--sets 200] [--first 0] [--json]

Sessions of 5 to 12 poses of which one to three are tilted otherwise than the rest, by robots whose
poses scatter by 0.03 to 0.5 mm and 0.05 to 1 mrad. Each is judged as it is, and with one pose that
is off by 1 mm and 0.1 degrees; such a pose is clear where the robot scatters by at most 0.1 mm and
0.2 mrad, and 8 poses or more were taken. A wild one is off by 20 mm. They are judged by corners
alone, as before the adjustment; with ``--adjusted``, by whole calibrations.
"""

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from crenel.errors import OperationError
from crenel.metrology.adjustment.board.bundle import Bundle
from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.adjustment.board.pose_judgement import (
    judge_robot_poses,
    readmit_predicted_poses,
)
from crenel.metrology.adjustment.board.problem import BoardInputs, adjust_pictures
from crenel.metrology.adjustment.core.hand_eye import mounting_by_motion, refuse_contradictions
from crenel.metrology.transforms import Floats, rigid
from tests.bench.board_sessions import DrawnSession, SessionPlan, draw_session, moved
from tests.bench.rows import bench_parser, measured_rows
from tests.metrology.numerics import unit

BAD_MM, BAD_RAD = 1.0, np.deg2rad(0.1)
WILD_MM = 20.0


def draw(seed: int) -> tuple[DrawnSession, SessionPlan]:
    """One session, and what was drawn of it."""
    rng = np.random.default_rng([seed, 53])
    count, tilted = int(rng.integers(5, 13)), int(rng.integers(1, 4))
    tilts = np.abs(rng.normal(0, 2.0, count))
    tilts[-tilted:] = rng.uniform(12, 35, tilted)
    shift_mm = float(np.exp(rng.uniform(np.log(0.03), np.log(0.5))))
    turn_rad = float(np.exp(rng.uniform(np.log(5e-5), np.log(1e-3))))
    plan = SessionPlan(
        tilts, shift_mm, turn_rad, rng.uniform(0.05, 0.2), (6, 5), rng.uniform(12, 35)
    )
    return draw_session(plan, rng), plan


def judge_by_corners(inputs: BoardInputs, found: Bundle) -> set[int] | None:
    """Numbers of the poses that are excluded; None if the session is refused."""
    seen = np.array([rigid(one.rotation, one.translation_mm) for one in found.cameras])
    numbers = np.array([one.number for one in inputs.observations])
    try:
        mounting = mounting_by_motion(inputs.readings, seen, inputs.board.size_mm)
        mounting = readmit_predicted_poses(found, mounting, inputs.board)
        refuse_contradictions(mounting, numbers.tolist(), "board")
    except OperationError:
        return None
    mounting, _ = judge_robot_poses(found, mounting, inputs.board)
    return set(numbers[mounting.contradicts].tolist())


def judge_by_adjustment(inputs: BoardInputs) -> set[int] | None:
    """The same by a whole calibration."""
    try:
        return {one.number for one in calibrate_board(inputs).poses if not one.used}
    except OperationError:
        return None


def judge(seed: int, adjusted: bool, counts: Counter[str]) -> None:
    """Adds what becomes of one session."""
    drawn, plan = draw(seed)
    inputs, rng = drawn.inputs, drawn.rng
    _, found = adjust_pictures(inputs)

    def excluded(readings: Floats) -> set[int] | None:
        given = replace(inputs, readings=readings)
        return judge_by_adjustment(given) if adjusted else judge_by_corners(given, found)

    count = len(inputs.readings)
    out = excluded(inputs.readings)
    counts["sessions"] += 1
    counts["refused"] += out is None
    counts["poses"] += 0 if out is None else count
    counts["good excluded"] += len(out or ())
    clear = plan.shift_mm < 0.1 and plan.turn_rad < 2e-4 and count >= 8
    for kind, off_mm in (("bad", BAD_MM), ("wild", WILD_MM)):
        wrong = int(rng.integers(count))
        readings = inputs.readings.copy()
        readings[wrong] = moved(
            readings[wrong], BAD_RAD * unit(rng.normal(size=3)), off_mm * unit(rng.normal(size=3))
        )
        out = excluded(readings)
        if out is None:
            counts[f"{kind}: refused"] += 1
            continue
        counts[f"{kind}: sessions"] += 1
        counts[f"{kind}: found"] += wrong in out
        counts[f"{kind}: clear"] += clear
        counts[f"{kind}: clear found"] += clear and wrong in out
        counts[f"{kind}: good poses"] += count - 1
        counts[f"{kind}: good excluded"] += len(out - {wrong})


def measure(sets: Iterable[int], adjusted: bool = False) -> dict[str, float]:
    """Percentages of poses and sessions."""
    counts: Counter[str] = Counter()
    for seed in sets:
        judge(seed, adjusted, counts)

    def percent(part: str, whole: str) -> float:
        return 100 * counts[part] / max(counts[whole], 1)

    shares = {
        "refused": percent("refused", "sessions"),
        "good excluded": percent("good excluded", "poses"),
    }
    for kind in ("bad", "wild"):
        shares[f"{kind}: found"] = percent(f"{kind}: found", f"{kind}: sessions")
        shares[f"{kind}: clear found"] = percent(f"{kind}: clear found", f"{kind}: clear")
        shares[f"{kind}: good out"] = percent(f"{kind}: good excluded", f"{kind}: good poses")
        shares[f"{kind}: refused"] = percent(f"{kind}: refused", "sessions")
    return shares


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--sets", type=int, default=200)
    parser.add_argument("--first", type=int, default=0, help="number of the first set")
    parser.add_argument("--adjusted", action="store_true", help="by whole calibrations")
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        sets = range(given.first, given.first + given.sets)
        rows.add("robot poses", measure(sets, given.adjusted))


if __name__ == "__main__":
    main()
