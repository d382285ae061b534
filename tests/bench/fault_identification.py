"""How often a fault in all contacts, or in the block's certificate, is identified correctly.

    python -m tests.bench fault-identification [--draws 40] [--json]

Sessions of random stations (six poses, forty touches on four faces) are drawn without pictures,
as the benchmark ``calibration`` does, with arms of three qualities; each is given one fault.
Counted is how often it is identified, and how often taken for another one.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.metrology.adjustment.core.gauss_newton import solve_adjustment
from crenel.metrology.adjustment.core.observations import ContactObservations
from crenel.metrology.adjustment.outliers.fault_hypotheses import block_fault_findings
from crenel.metrology.limits import LIMITS
from crenel.metrology.transforms import Floats
from tests.bench.metrology.simulated import (
    USUAL,
    Draw,
    SetUp,
    SimulatedSetup,
    draw_session,
    draw_setup,
)
from tests.bench.rows import bench_parser, measured_rows

FACES = ("crest", "front", "left", "right")
STATIONS, POSES, PER_FACE = 4, 6, 10
CODES = ("tip-diameter", "tip-place", "object-moved", "object-size", "size")
# The tip's error over the arm's reach, and the links' errors that make it.
ARMS = {
    "25 um": USUAL,
    "100 um": replace(USUAL, links_mm=0.012, links_rad=3e-5),
    "250 um": replace(USUAL, links_mm=0.03, links_rad=7.5e-5),
}

Fault = Callable[[Draw, np.random.Generator], Draw]


def diameter(by_mm: float, session: Draw, _rng: np.random.Generator) -> Draw:
    touches = session_contacts(session)
    return with_contacts(session, replace(touches, radius_mm=touches.radius_mm + by_mm / 2))


def place(by_mm: float, session: Draw, rng: np.random.Generator) -> Draw:
    R_arm_flange = session_contacts(session).R_arm_flange
    return move_contacts(session, R_arm_flange @ (by_mm * direction(rng)))


def nudge(by_mm: float, by_deg: float, session: Draw, rng: np.random.Generator) -> Draw:
    tips = session_contacts(session).tips_mm
    turn = Rotation.from_rotvec(np.radians(by_deg) * direction(rng)).as_matrix()
    arms = tips - tips.mean(axis=0)
    return move_contacts(session, arms @ turn.T - arms + by_mm * direction(rng))


def scale_block(share: float, session: Draw, _rng: np.random.Generator) -> Draw:
    prior, state = session.problem.prior, session.start
    prior = replace(prior, coordinates=prior.coordinates * (1 + share))
    state = replace(state, coordinates=state.coordinates * (1 + share))
    return replace(session, problem=replace(session.problem, prior=prior), start=state)


FAULTS: dict[str, tuple[str, Fault]] = {
    "none": ("", lambda session, _: session),
    "tip 0.1 mm too large": ("tip-diameter", partial(diameter, 0.1)),
    "tip 0.1 mm from its place": ("tip-place", partial(place, 0.1)),
    "tip 0.3 mm from its place": ("tip-place", partial(place, 0.3)),
    "block moved by 0.1 mm, 0.05 deg": ("object-moved", partial(nudge, 0.1, 0.05)),
    "block moved by 0.3 mm, 0.2 deg": ("object-moved", partial(nudge, 0.3, 0.2)),
    "certificate 0.3 % too large": ("object-size", partial(scale_block, 0.003)),
    "certificate 1 % too large": ("object-size", partial(scale_block, 0.01)),
}


def session_contacts(session: Draw) -> ContactObservations:
    assert session.problem.contacts is not None
    return session.problem.contacts


def with_contacts(session: Draw, touches: ContactObservations) -> Draw:
    return replace(session, problem=replace(session.problem, contacts=touches))


def move_contacts(session: Draw, by_mm: Floats) -> Draw:
    touches = session_contacts(session)
    return with_contacts(session, replace(touches, tips_mm=touches.tips_mm + by_mm))


def direction(rng: np.random.Generator) -> Floats:
    drawn_mm = rng.normal(size=3)
    return np.asarray(drawn_mm / np.linalg.norm(drawn_mm))


def named_fault(station: SimulatedSetup, fault: Fault, seed: int) -> str:
    """The fault that is named, or none."""
    rng = np.random.default_rng(seed)
    session = fault(draw_session(station, rng), rng)
    found = block_fault_findings(solve_adjustment(session.problem, session.start), LIMITS)
    named = [one.code for one in found if one.code in CODES and one.quality != "good"]
    return named[0] if named else ""


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--draws", type=int, default=40)
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        for name in FAULTS:
            shares: dict[str, float] = {}
            for arm in ARMS:
                right, other = identified_and_mistaken(name, arm, given.draws)
                shares |= {f"{arm}, right, %": right, f"{arm}, other, %": other}
            rows.add(name, shares)


def identified_and_mistaken(name: str, arm: str, draws: int) -> tuple[float, float]:
    """Share in % of the sessions in which a fault is identified, and taken for another one."""
    code, fault = FAULTS[name]
    stations = [
        draw_setup(SetUp(name, POSES, 6 + k % 2, FACES, PER_FACE, scales=ARMS[arm], seed=k + 1))
        for k in range(STATIONS)
    ]
    codes = [named_fault(stations[k % STATIONS], fault, k) for k in range(draws)]
    right = sum(one == code for one in codes if code)
    other = sum(one not in (code, "") for one in codes)
    return 100 * right / draws, 100 * other / draws


if __name__ == "__main__":
    main()
