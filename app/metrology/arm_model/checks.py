"""What is wrong with the points: too few, too alike, a place that moved, a wrong tip."""

import numpy as np

from app.metrology.arm import Arm
from app.metrology.arm_model.adjustment import residuals
from app.metrology.arm_model.observations import Observations, Stacked
from app.metrology.arm_model.parameters import parameter_names, parameter_values, tip_jacobian
from app.metrology.arm_model.selection import limits
from app.metrology.arm_model.solving import Fit
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

LEAST_SEAT, LEAST_SPHERE, LEAST_PLACES = 6, 6, 4
LEAST_SWING_RAD = np.deg2rad(15.0)
"""The joint that turns most in a seat must turn at least so far."""
OUTLIER_SHARE = 0.25
"""A place with more of its points left out is not to be trusted at all."""
MOVED_SIGMAS = 4.0
"""First and later points of a seat lie so much further apart than single points scatter."""
MIXED_MM = 100.0
"""No tip of a reasonable arm.json is off by so much."""
EXCESS_SIGMAS, EXCESS_MM, WRONG_TIP_MM = 5.0, 0.005, 0.025
FAR_LIMITS = 20.0
"""A parameter that moves by so many times what a workshop gets wrong is worth a look."""


def check_enough(arm: Arm, observations: Observations) -> None:
    """Refuses too few places or points, and places about which the arm hardly moved."""
    if observations.groups_count < LEAST_PLACES:
        raise Refusal(
            "too-few-places",
            f"{observations.groups_count} places were touched",
            f"at least {LEAST_PLACES} seats, spheres and bar positions are needed, so that some "
            "can be held out",
            "Take more places, all over the arm's reach",
        )
    for seat in observations.seats:
        if len(seat.q_rad) < LEAST_SEAT:
            raise _too_few(f"seat {seat.name}", len(seat.q_rad), LEAST_SEAT)
        check_swing(f"seat {seat.name}", arm, seat.q_rad)
    for sphere in observations.spheres:
        if len(sphere.q_rad) < LEAST_SPHERE:
            raise _too_few(f"sphere {sphere.name}", len(sphere.q_rad), LEAST_SPHERE)


def _too_few(label: str, points: int, least: int) -> Refusal:
    return Refusal(
        "too-few-points",
        f"{label} has {points} points",
        f"at least {least} are needed to tell the arm's errors from its own centre",
        "Take more there, or delete its rows",
    )


def check_swing(label: str, arm: Arm, q_rad: Floats) -> None:
    """Refuses a seat about which the arm hardly moved; angles (m, n)."""
    swings = np.ptp(q_rad, axis=0)
    most = int(np.argmax(swings))
    if swings[most] < LEAST_SWING_RAD:
        raise Refusal(
            "arm-hardly-moved",
            f"{label}: no joint turned more than {np.rad2deg(swings[most]):.1f}° "
            f"({arm.joints[most].name})",
            "an arm that stays as it is shows nothing of its errors",
            "Swing the elbow from one side to the other while the tip stays in the seat",
        )


def check_not_mixed(arm: Arm, observations: Observations) -> None:
    """Refuses a seat whose points lie in two places, as any arm near the given one sees it."""
    for seat in observations.seats:
        tips, _ = tip_jacobian(arm, seat.q_rad)
        split, gap_mm = _split(tips)
        if gap_mm > MIXED_MM and _two_groups(tips, split, gap_mm):
            raise Refusal(
                "seat-moved",
                f"seat {seat.name}: its points 1 to {split} and {split + 1} to {len(tips)} lie "
                f"{gap_mm:.0f} mm apart",
                "they are of two seats, or the seat was carried elsewhere in between",
                "Give each seat a name of its own",
            )


def check_places_stood_still(data: Stacked, fit: Fit) -> None:
    """Refuses a place whose points disagree; says so if it moved in between."""
    vectors = residuals(data, fit.at, fit.scatter_mm).vectors_mm
    sd = _typical_sd(data, fit, vectors)
    for number, place in enumerate(data.places):
        own = data.place_of == number
        points = vectors[own]
        out = int(np.sum(~fit.kept[own]))
        untrusted = out >= 3 and out > OUTLIER_SHARE * len(points)
        split, gap_mm = _split(points) if place.diameter_mm is None else (0, 0.0)
        moved = gap_mm > max(MOVED_SIGMAS * sd, 1e-2)
        if moved and (untrusted or _two_groups(points, split, gap_mm)):
            raise Refusal(
                "seat-moved",
                f"{place.label}: its points 1 to {split} and {split + 1} to {len(points)} lie "
                f"{gap_mm * 1e3:.0f} µm apart, while single points scatter by {sd * 1e3:.0f} µm",
                "the seat moved in between",
                "Clamp the seat, and take this place again or delete its rows",
            )
        if untrusted:
            raise Refusal(
                "place-disagrees",
                f"{place.label}: {out} of its {len(points)} points disagree with the rest",
                "the tip was not seated, or the seat was loose, or points of another place are "
                "among them",
                "Take this place again, or delete its rows",
            )


def check_tip_diameter(arm: Arm, data: Stacked, fit: Fit) -> None:
    """Refuses a tip or spheres of evidently another diameter than stated."""
    if not data.on_sphere.any():
        return
    excess, sd = fit.at.radius_excess_mm, float(np.sqrt(fit.others_covariance[0, 0]))
    if abs(excess) > max(EXCESS_SIGMAS * sd, WRONG_TIP_MM):
        diameter = arm.tip.diameter_mm
        raise Refusal(
            "tip-diameter",
            f"the spheres are seen {2e3 * excess:+.0f} µm (± {2e3 * sd:.0f}) against their "
            f"diameters with the tip's {diameter:g} mm",
            f"the tip rather has {diameter + 2 * excess:.3f} mm, or the spheres' diameters are "
            "not theirs",
            "Correct the tip's diameter in arm.json, or diameter_mm in the table",
        )


def warnings_of(arm: Arm, observations: Observations, fit: Fit) -> tuple[str, ...]:
    """What whoever identifies an arm should know beside the result."""
    found: list[str] = []
    if not observations.bars:
        found.append(
            "no ball bar was measured: the arm's size is that of its papers, held by its "
            "longest link"
        )
    for name, error in zip(fit_bar_names(observations), fit.at.bar_errors_mm, strict=True):
        sd = next(b.standard_uncertainty_mm for b in observations.bars if b.name == name)
        if abs(float(error)) > 4 * sd:
            found.append(
                f"bar {name} is seen {float(error) * 1e3:+.0f} µm against its calibrated "
                f"length: other lengths contradict it"
            )
    if observations.spheres:
        excess, sd = fit.at.radius_excess_mm, float(np.sqrt(fit.others_covariance[0, 0]))
        if abs(excess) > max(EXCESS_SIGMAS * sd, EXCESS_MM):
            found.append(
                f"the spheres are seen {2e3 * excess:+.0f} µm larger than stated: the tip's "
                f"diameter may be {arm.tip.diameter_mm + 2 * excess:.4f} mm"
            )
    found += _far_moves(arm, fit)
    return tuple(found)


def fit_bar_names(observations: Observations) -> tuple[str, ...]:
    """The bars' names, in the order of their errors in a fit."""
    return tuple(dict.fromkeys(bar.name for bar in observations.bars))


def _far_moves(arm: Arm, fit: Fit) -> list[str]:
    before, after = parameter_values(arm), parameter_values(fit.at.arm)
    names = parameter_names(arm)
    far: list[str] = []
    for i, limit in zip(fit.moved, limits(arm, fit.moved), strict=True):
        change = float(after[i] - before[i])
        if abs(change) > FAR_LIMITS * limit:
            angle = names[i].endswith("_rad")
            told = f"{np.rad2deg(change):+.3f}°" if angle else f"{change:+.2f} mm"
            far.append(f"{names[i]} moves by {told}: check arm.json and the bars' lengths")
    return far


def _typical_sd(data: Stacked, fit: Fit, vectors: Floats) -> float:
    """Per coordinate, how far a point in a seat typically lies from the centre, mm."""
    seated = fit.kept & ~data.on_sphere
    if not seated.any():
        return fit.scatter_mm
    return float(np.sqrt(np.median(np.sum(vectors[seated] ** 2, axis=1))) / 1.5382)


def _split(points: Floats) -> tuple[int, float]:
    """Where a set of points (m, 3) falls apart in time, and by how far (mm)."""
    count = len(points)
    best, gap = 0, 0.0
    strongest = 0.0
    for k in range(3, count - 2):
        apart = float(np.linalg.norm(points[:k].mean(axis=0) - points[k:].mean(axis=0)))
        strength = apart * np.sqrt(k * (count - k) / count)
        if strength > strongest:
            strongest, best, gap = strength, k, apart
    return best, gap


def _two_groups(points: Floats, split: int, gap_mm: float) -> bool:
    """Whether the gap explains most of the points' scatter."""
    first, later = points[:split], points[split:]
    within = np.concatenate([first - first.mean(axis=0), later - later.mean(axis=0)])
    return float(np.sqrt(np.mean(np.sum(within**2, axis=1)))) < 0.6 * gap_mm
