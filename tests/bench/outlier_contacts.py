"""Contact points that were taken elsewhere: how often the right one is named, and a good one.

    python -m tests.bench outlier-contacts [--sets 500] [--first 0] [--only NAME] [--json]

Every row is one thing that is touched, so many times, with an outlier or two among the contact
points: the first, one in the middle, the last. It is off by 5 standard deviations to 30 mm, evenly
over the logarithm. Half of the sets have none. Counted are the sets in which an outlier is named;
in which it is said that one of some points is off, where nothing tells which; in which a good
point is named; and in which an outlier beyond 20 standard deviations is not noticed.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.quick.maths.probed_gauge import sphere_through
from crenel.guide.calibration.touch.block import suggest_places
from crenel.metrology.adjustment.core.gauss_newton import solve_adjustment
from crenel.metrology.adjustment.outliers.contacts import remove_outlier_contacts
from crenel.metrology.arm.identification.observations import ArmObservations
from crenel.metrology.arm.identification.parameter_selection import candidates_of
from crenel.metrology.arm.identification.robust_solve import fit_arm
from crenel.metrology.arm.kinematics import Arm, geometric_jacobians, tip_centres
from crenel.metrology.fitting.outlier_search import Agreement
from crenel.metrology.fitting.touched_shape import agree_on_plane, agree_on_sphere
from crenel.metrology.probing.alignment import align
from crenel.metrology.targets.crenellated_block import probing_face
from crenel.metrology.transforms import Floats, apply, rotation_from_vector
from tests.bench.fault_identification import direction
from tests.bench.metrology.simulated import SetUp, SimulatedSetup, draw_session, draw_setup
from tests.bench.rows import bench_parser, measured_rows
from tests.metrology.arm_sessions import collect_observations, nominal_arm
from tests.metrology.builders import BLOCK, TIP_RADIUS_MM, random_pose
from tests.simulated_arm_sessions import ArmSessionPlan, draw_arm_session

SD_MM, ENCODERS_MM = 0.02, 0.01
"""Of a contact point altogether, and by the arm's readings alone."""
LEAST_SDS, MOST_MM, CLEAR_SDS = 5.0, 30.0, 20.0
RADIUS_MM = 12.7
REFUSED = ("contact-off-unknown-which", "contacts-do-not-fit", "contacts-mirrored")

Fit = Callable[[np.random.Generator, Floats], Agreement]
"""The agreement of contact points that are off their place by (N,) mm."""


@dataclass(frozen=True)
class Touched:
    """One thing that is touched ``count`` times, with what is drawn at random."""

    count: int
    fit: Fit
    sd_mm: float = SD_MM
    slow: int = 1
    """So many sets are counted as one: a fit to all else takes longer."""


def on_plane(bend_mm: float, rng: np.random.Generator, off_mm: Floats) -> Agreement:
    """A gauge; with a bend, a board."""
    count = len(off_mm)
    places = rng.permutation([(x, y) for x in (-40.0, 0.0, 40.0) for y in (-30.0, 0.0, 30.0)])
    xy = np.resize(places, (count, 2)) + rng.uniform(-9, 9, (count, 2))
    noise = rng.normal(0, SD_MM, count)
    bent = bend_mm * np.sin(xy[:, 0] / 40 + rng.uniform(0, 6)) * np.cos(xy[:, 1] / 30)
    tips = np.column_stack([xy, noise + bent + off_mm]) @ turned(rng).T + rng.uniform(-500, 500, 3)
    usual_mm = max(ENCODERS_MM, bend_mm)
    return agree_on_plane(tips, spread(count, usual_mm), max(0.1, bend_mm))


def on_sphere(rng: np.random.Generator, off_mm: Floats) -> Agreement:
    """A gauge, a master sphere or the sphere of a tip check, touched all over its upper half."""
    count = len(off_mm)
    height = rng.permutation(np.linspace(1.0, 0.0, count)) + rng.uniform(-0.05, 0.05, count)
    height = np.clip(height, -0.2, 1.0)
    turn = 2.4 * np.arange(count) + rng.uniform(0, 6)
    level = np.sqrt(1 - height**2)
    outward = np.column_stack([level * np.cos(turn), level * np.sin(turn), height])
    reach_mm = RADIUS_MM + 3.0
    far = np.maximum(reach_mm + rng.normal(0, SD_MM, count) + off_mm, 0.0)
    tips = far[:, None] * outward @ turned(rng).T + rng.uniform(-500, 500, 3)
    return agree_on_sphere(tips, spread(count, ENCODERS_MM), reach_mm)


def on_block(rng: np.random.Generator, off_mm: Floats) -> Agreement:
    """Three faces, at places that the guide proposes."""
    features, places = [], []
    for face in ("crest", "front", "left"):
        proposed = rng.permutation(np.array(suggest_places(BLOCK, face)))[: len(off_mm) // 3]
        features += [face] * len(proposed)
        places.append(proposed)
    normals = np.array([probing_face(BLOCK, face)[0] for face in features])
    off_mm = TIP_RADIUS_MM + rng.normal(0, SD_MM, len(off_mm)) + off_mm
    tips = apply(random_pose(rng), np.concatenate(places) + off_mm[:, None] * normals)
    try:
        found = align(features, tips, TIP_RADIUS_MM, BLOCK, spread(len(tips), ENCODERS_MM))
    except OperationError as refusal:
        return doubted(refusal, len(tips))
    return Agreement(~found.outliers, found.doubtful)


@cache
def station() -> SimulatedSetup:
    return draw_setup(SetUp("board", 6, faces=("crest",), contacts_per_face=8))


def with_pictures(rng: np.random.Generator, off_mm: Floats) -> Agreement:
    """One face, as that of a board, whose place the pictures know."""
    session = draw_session(station(), rng)
    touches = session.problem.contacts
    assert touches is not None
    normals = touches.normals @ station().T_arm_obj[:3, :3].T
    touches = replace(touches, tips_mm=touches.tips_mm + off_mm[:, None] * normals)
    problem = replace(session.problem, contacts=touches)
    try:
        found = remove_outlier_contacts(solve_adjustment(problem, session.start))
    except OperationError as refusal:
        return doubted(refusal, len(touches))
    assert found.problem.contacts is not None
    kept = found.problem.contacts.inliers
    return Agreement(kept, np.zeros(len(kept), np.bool_))


def doubted(refusal: OperationError, count: int) -> Agreement:
    """Of a refusal that says that one of some points is off, or that all of them do not fit."""
    if refusal.code not in REFUSED:
        raise refusal
    return Agreement(np.ones(count, np.bool_), np.ones(count, np.bool_))


PLAN = ArmSessionPlan(
    seats=5,
    points_per_seat=10,
    spheres=2,
    points_per_sphere=12,
    bar_lengths_mm=(600.0,),
    positions_per_bar=2,
    points_per_end=8,
    touch_sd_mm=0.0,
    encoder_noise=False,
)
PLACES = {"seat": 2, "sphere": 5, "bar": 7}
ARMS = 6


@cache
def arm_session(seed: int) -> tuple[Arm, ArmObservations]:
    session = draw_arm_session(seed, PLAN)
    return nominal_arm(session.nominal_arm), collect_observations(session)


def in_identification(kind: str, rng: np.random.Generator, off_mm: Floats) -> Agreement:
    """The touches of one place among others, which show the arm."""
    arm, good = arm_session(int(rng.integers(ARMS)))
    data = good.stacked
    own = data.places[PLACES[kind]].rows
    q = data.q_rad + arm.encoder_sd_rad * rng.normal(size=data.q_rad.shape)
    centre = sphere_through(tip_centres(arm, q[own]))[0]
    for row, off in zip(range(own.start, own.stop), off_mm, strict=True):
        away = tip_centres(arm, q[row][None])[0] - centre
        along = away / np.linalg.norm(away) if kind == "sphere" else direction(rng)
        q[row] = moved(arm, q[row], off * along)
    try:
        fit = fit_arm(arm, with_readings(good, q).stacked, candidates_of(arm, good))
    except OperationError as refusal:
        return doubted(refusal, len(off_mm))
    kept = fit.inliers[: data.touches]
    others = np.ones(data.touches, np.bool_)
    others[own] = False
    kept[own.start] &= kept[others].all()  # a good point elsewhere is a good point, too
    return Agreement(kept[own], np.zeros(len(off_mm), np.bool_))


def moved(arm: Arm, q_rad: Floats, by_mm: Floats) -> Floats:
    """Angles (n,) that hold the tip (3,) mm away."""
    target, q = tip_centres(arm, q_rad[None])[0] + by_mm, q_rad.copy()
    for _ in range(6):
        J = geometric_jacobians(arm, q[None], arm.tip.centre_mm)[0, :3]
        q += np.linalg.pinv(J, rcond=0.02) @ (target - tip_centres(arm, q[None])[0])
    return q


def with_readings(good: ArmObservations, q_rad: Floats) -> ArmObservations:
    """The same touches with other angles."""
    lengths = [len(one) for one in readings_of(good)]
    parts = iter(np.split(q_rad, np.cumsum(lengths)[:-1]))
    return replace(
        good,
        seats=tuple(replace(seat, q_rad=next(parts)) for seat in good.seats),
        spheres=tuple(replace(sphere, q_rad=next(parts)) for sphere in good.spheres),
        bars=tuple(replace(bar, q_rad=(next(parts), next(parts))) for bar in good.bars),
    )


def readings_of(good: ArmObservations) -> Iterator[Floats]:
    yield from (seat.q_rad for seat in good.seats)
    yield from (sphere.q_rad for sphere in good.spheres)
    yield from (q_rad for bar in good.bars for q_rad in bar.q_rad)


def spread(count: int, sd_mm: float) -> Floats:
    return np.tile(sd_mm**2 * np.eye(3), (count, 1, 1))


def turned(rng: np.random.Generator) -> Floats:
    return rotation_from_vector(rng.normal(0, 1.5, 3))


TOUCHED: Mapping[str, Touched] = {
    **{f"block, {n} points": Touched(n, on_block) for n in (12, 18, 27)},
    **{f"plane, {n} points": Touched(n, partial(on_plane, 0.0)) for n in (4, 5, 6, 9)},
    **{f"sphere, {n} points": Touched(n, on_sphere) for n in (5, 7, 9, 15)},
    **{f"board, {n} points": Touched(n, partial(on_plane, 0.03), 0.05) for n in (6, 9)},
    "board with pictures, 8 points": Touched(8, with_pictures, 0.008, 10),
    "seat, 10 points": Touched(10, partial(in_identification, "seat"), SD_MM, 10),
    "sphere beside seats, 12 points": Touched(12, partial(in_identification, "sphere"), SD_MM, 10),
    "ball bar's end, 8 points": Touched(8, partial(in_identification, "bar"), SD_MM, 10),
}


@dataclass(frozen=True)
class WhatWasSaid:
    """What was said of one set."""

    accuses_good: bool
    in_doubt: bool
    names: bool
    overlooks: bool
    """Of outliers that are clear, and of which no doubt is said."""


def judge_set(touched: Touched, outliers: int, seed: int) -> WhatWasSaid:
    """One set of contact points with so many outliers."""
    rng = np.random.default_rng([seed, outliers, touched.count])
    off_mm = np.zeros(touched.count)
    first = int(rng.choice([0, touched.count // 2, touched.count - 1]))
    others = rng.permutation(np.delete(np.arange(touched.count), first))
    where = [first, *others][:outliers]
    least, most = np.log(LEAST_SDS * touched.sd_mm), np.log(MOST_MM)
    off_mm[where] = np.exp(rng.uniform(least, most, outliers)) * rng.choice([-1, 1], outliers)
    found = touched.fit(rng, off_mm)
    is_outlier, named = off_mm != 0.0, ~found.kept
    clear = np.abs(off_mm) > CLEAR_SDS * touched.sd_mm
    return WhatWasSaid(
        accuses_good=bool((named & ~is_outlier).any()),
        in_doubt=bool(found.doubtful.any()),
        names=bool(named.any()),
        overlooks=bool((clear & ~named).any() and not found.doubtful.any()),
    )


def measure(name: str, sets: range) -> dict[str, float]:
    """Percentages over sets without, with one and with two outliers."""
    shares: dict[str, float] = {}
    for outliers in (0, 1, 2):
        found = [judge_set(TOUCHED[name], outliers, seed) for seed in sets]

        def percent(what: str, found: list[WhatWasSaid] = found) -> float:
            return 100 * float(np.mean([getattr(one, what) for one in found]))

        shares[f"{outliers}: good named"] = percent("accuses_good")
        shares[f"{outliers}: in doubt"] = percent("in_doubt")
        if outliers:
            shares[f"{outliers}: named"] = percent("names")
            shares[f"{outliers}: overlooked"] = percent("overlooks")
    return shares


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--sets", type=int, default=500)
    parser.add_argument("--first", type=int, default=0, help="number of the first set")
    parser.add_argument("--only", default="", help="rows whose name begins so")
    given = parser.parse_args()
    with measured_rows(given.json) as rows:
        for name in TOUCHED:
            if name.startswith(given.only):
                sets = range(given.first, given.first + given.sets // TOUCHED[name].slow)
                rows.add(name, measure(name, sets))


if __name__ == "__main__":
    main()
