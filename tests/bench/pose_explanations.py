"""Poses with a fault in all of them: how often the true cause is the one that is named.

    python -m tests.bench pose-explanations [--sets 60] [--first 0] [--json]

Simulated sessions of 7 to 14 poses, each with one of ``FAULTS``. A set is right if the refusal
names the fault and from which pose on it holds, or, of few poses, if those alone are excluded.
An advice to correct the certificate is counted apart where that is right.
"""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.messages.message import Message
from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.transforms import Floats, inverse, se3_exp
from tests.bench.board_sessions import DrawnSession, SessionPlan, draw_session
from tests.bench.rows import bench_parser, measured_rows

REFUSED, CERTIFICATE, NOTHING, EXCLUDED = "refused", "certificate", "", "excluded"


@dataclass(frozen=True)
class Wrong:
    """Inputs with a fault, what is right to name, and the poses that may be excluded instead."""

    inputs: BoardInputs
    faults: tuple[str, ...]
    first: int | None = None
    may_exclude: frozenset[int] = frozenset()


def with_readings(drawn: DrawnSession, readings: Floats, *faults: str) -> Wrong:
    return Wrong(replace(drawn.inputs, readings=readings), faults)


def slip(drawn: DrawnSession, late: bool, whole: bool = False) -> Wrong:
    """Pictures dropped before one (the poses come late), or poses (they come early)."""
    given, rng = drawn.inputs, drawn.rng
    count = len(given.readings)
    by = int(rng.integers(1, 3))
    first = 0 if whole else int(rng.integers(1, count - 2 * by - 1))
    kept = np.delete(np.arange(count), np.arange(first, first + by))
    rows, pictures = (np.arange(count - by), kept) if late else (kept, np.arange(count - by))
    seen = tuple(replace(given.observations[p], number=k) for k, p in enumerate(pictures))
    inputs = replace(given, observations=seen, readings=given.readings[rows])
    names = ("late", "after") if late else ("early", "before")
    off = frozenset(range(first, count - by))
    return Wrong(inputs, names, first, off if len(off) <= 2 else frozenset())


def permuted(drawn: DrawnSession, order: list[int], *faults: str) -> Wrong:
    wrong = with_readings(drawn, drawn.inputs.readings[order], *faults)
    off = frozenset(k for k, p in enumerate(order) if k != p)
    return replace(wrong, may_exclude=off if len(off) <= 2 else frozenset())


def by_name(drawn: DrawnSession) -> Wrong:
    order = sorted(range(len(drawn.inputs.readings)), key=lambda k: str(k + 1))
    return permuted(drawn, order, "sorted", "late", "early", "mixed")


def backwards(drawn: DrawnSession) -> Wrong:
    return permuted(drawn, list(range(len(drawn.inputs.readings)))[::-1], "reversed")


def swapped(drawn: DrawnSession) -> Wrong:
    order = list(range(len(drawn.inputs.readings)))
    one, other = drawn.rng.choice(len(order), 2, replace=False)
    order[one], order[other] = order[other], order[one]
    return permuted(drawn, order, "swapped")


def shuffled(drawn: DrawnSession) -> Wrong:
    order = list(map(int, drawn.rng.permutation(len(drawn.inputs.readings))))
    return permuted(drawn, order, "mixed", "swapped")


def in_unit(drawn: DrawnSession) -> Wrong:
    readings = drawn.inputs.readings.copy()
    readings[:, :3, 3] /= drawn.rng.choice([1000.0, 25.4, 10.0])
    return with_readings(drawn, readings, "unit")


def inverted(drawn: DrawnSession) -> Wrong:
    return with_readings(drawn, inverse(drawn.inputs.readings), "inverted")


def turned(drawn: DrawnSession, change: Callable[[Rotation], Rotation], *faults: str) -> Wrong:
    readings = drawn.inputs.readings.copy()
    readings[:, :3, :3] = change(Rotation.from_matrix(readings[:, :3, :3])).as_matrix()
    return with_readings(drawn, readings, *faults)


def scalar_first(drawn: DrawnSession) -> Wrong:
    return turned(
        drawn, lambda R: Rotation.from_quat(np.roll(R.as_quat(), 1, axis=1)), "scalar-first"
    )


def turns_inverted(drawn: DrawnSession) -> Wrong:
    return turned(drawn, Rotation.inv, "turns-inverted", "rotations")


def other_angles(drawn: DrawnSession) -> Wrong:
    one, other = drawn.rng.choice(["ZYX", "XYZ", "ZYZ"], 2, replace=False)
    return turned(drawn, lambda R: Rotation.from_euler(other, R.as_euler(one)), "rotations")


def vector_as_angles(drawn: DrawnSession) -> Wrong:
    return turned(drawn, lambda R: Rotation.from_euler("xyz", R.as_rotvec()), "rotations")


def changed(drawn: DrawnSession, tool: bool) -> Wrong:
    """Another tool frame, or an object elsewhere, from one pose on."""
    readings, rng = drawn.inputs.readings.copy(), drawn.rng
    first = int(rng.integers(3, len(readings) - 2))
    by = se3_exp(np.concatenate([rng.normal(0, 0.15, 3), rng.normal(0, 40, 3)]))
    late = readings[first:]
    readings[first:] = late @ by if tool else by @ late
    wrong = with_readings(drawn, readings, "tool-changed" if tool else "object-moved")
    return replace(wrong, first=first)


def of_other_size(drawn: DrawnSession) -> Wrong:
    board = drawn.inputs.board
    size = board.square_mm * drawn.rng.choice([0.8, 0.9, 1.1, 1.25])
    return Wrong(replace(drawn.inputs, board=replace(board, square_mm=size)), (CERTIFICATE,))


def right(drawn: DrawnSession) -> Wrong:
    return Wrong(drawn.inputs, (NOTHING,))


FAULTS: dict[str, Callable[[DrawnSession], Wrong]] = {
    "pictures dropped": lambda drawn: slip(drawn, late=True),
    "poses dropped": lambda drawn: slip(drawn, late=False),
    "pictures dropped at the start": lambda drawn: slip(drawn, late=True, whole=True),
    "poses dropped at the start": lambda drawn: slip(drawn, late=False, whole=True),
    "sorted by name": by_name,
    "reversed": backwards,
    "two swapped": swapped,
    "shuffled": shuffled,
    "in another unit": in_unit,
    "inverted": inverted,
    "scalar first": scalar_first,
    "turns inverted": turns_inverted,
    "other angles": other_angles,
    "vectors as angles": vector_as_angles,
    "tool changed": lambda drawn: changed(drawn, tool=True),
    "object moved": lambda drawn: changed(drawn, tool=False),
    "other size": of_other_size,
    "nothing": right,
}


def draw(seed: int) -> tuple[str, Wrong]:
    """One set, each fault in turn; every third board looks the same turned round."""
    rng = np.random.default_rng([seed, 54])
    name = list(FAULTS)[seed % len(FAULTS)]
    count = int(rng.integers(11, 15) if name == "sorted by name" else rng.integers(7, 15))
    tilts = rng.uniform(5, 30, count)
    corners = (7, 5) if rng.uniform() < 0.33 else (7, 6)
    plan = SessionPlan(
        tilts,
        float(np.exp(rng.uniform(np.log(0.02), np.log(0.5)))),
        float(np.exp(rng.uniform(np.log(5e-5), np.log(1e-3)))),
        rng.uniform(0.05, 0.2),
        corners,
        rng.uniform(8, 25),
    )
    return name, FAULTS[name](draw_session(plan, rng))


def say(wrong: Wrong) -> tuple[str, int | None, frozenset[int]]:
    """The fault that is named, from which pose on, and the poses that are excluded."""
    try:
        poses = calibrate_board(wrong.inputs).poses
    except OperationError as error:
        if error.code == "square-size":
            return CERTIFICATE, None, frozenset()
        if error.code != "poses-read-otherwise" or not isinstance(error.what, Message):
            return f"{REFUSED}: {error.code}", None, frozenset()
        values = error.what.values
        first = values["first"]
        return str(values["fault"]), first if isinstance(first, int) else None, frozenset()
    out = frozenset(one.number for one in poses if not one.used)
    return (EXCLUDED if out else NOTHING), None, out


def judge(wrong: Wrong) -> tuple[bool, bool, str]:
    """Whether the true cause is named, whether a right certificate is doubted, and what is said."""
    fault, first, out = say(wrong)
    is_right = fault in wrong.faults and (
        wrong.first is None or fault in ("before", "after") or first == wrong.first
    )
    is_right |= fault == EXCLUDED and out == wrong.may_exclude
    doubted = fault == CERTIFICATE and CERTIFICATE not in wrong.faults
    return is_right, doubted, f"{fault} from {first} {sorted(out)}"


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--sets", type=int, default=60)
    parser.add_argument("--first", type=int, default=0, help="number of the first set")
    given = parser.parse_args()
    counts: Counter[str] = Counter()
    with measured_rows(given.json) as rows:
        for seed in range(given.first, given.first + given.sets):
            name, wrong = draw(seed)
            is_right, doubted, said = judge(wrong)
            counts["right"] += is_right
            counts["doubted"] += doubted
            if not is_right:
                rows.say(f"{seed} {name} from {wrong.first}: {said}")
        shares = {
            "true cause named, %": 100 * counts["right"] / given.sets,
            "right certificate doubted": counts["doubted"],
        }
        rows.add("poses with a fault", shares)


if __name__ == "__main__":
    main()
