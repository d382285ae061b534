"""Whether the part stayed in place: passes against passes, recordings, and touches against scan.

Features that two groups of points both determine are fitted twice and compared before anything is
judged. Errors that both share cancel, so that a slip far below the uncertainty of a place shows.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.metrology.transforms import Floats
from crenel.parts.evaluate_features import (
    FeatureByMeans,
    MeasuredPoints,
    take_points,
)
from crenel.parts.maths.feature_fit import FittedFeature, fit_feature
from crenel.parts.maths.knowledge import MeasuredFeature
from crenel.parts.maths.overlap import Overlap, compare_features

CHANCE = 1e-4
"""Of a false alarm in each comparison; there are at most five in an inspection of one scan."""
LEAST_POINTS = 60
MOST_POINTS = 1_500
"""Of a feature in each comparison: more would only make the noise smaller, which is small."""
SHARES = (0.25, 0.5, 0.75)
"""Where one recording is cut into two."""


def find_slips(
    data: MeasuredPoints,
    features: Sequence[FeatureByMeans],
    frames_of_scans: Sequence[int],
    T_arm_part: Floats,
    tip_radius_mm: float,
    shared: Floats,
) -> list[Text]:
    """What shows that the part moved while it was measured; empty if nothing does.

    Args:
        frames_of_scans: how many frames with points each recording has, in their order.
        shared: (P, P) covariance of the shared errors.
    """
    scanned = [one for one in features if one.means == "scan"]
    total = sum(frames_of_scans)
    ends = np.cumsum(frames_of_scans)[:-1].tolist()
    between_scans = bool(ends)
    cuts = ends or [int(share * total) for share in SHARES]
    found = [one for cut in cuts if (one := _compare_at(scanned, cut, data, shared)) is not None]
    worst = min(found, key=lambda one: one[0].chance, default=None)
    if worst is not None and worst[0].chance < CHANCE:
        # touches would differ from a scan of two places in any case
        return [_describe("scans" if between_scans else "passes", *worst)]
    touched = _compare_touches(data, scanned, features, T_arm_part, tip_radius_mm, shared)
    if touched is not None and touched[0].chance < CHANCE:
        return [_describe("touches", *touched)]
    return []


def _describe(between: str, overlap: Overlap, feature: str) -> Text:
    return message(
        "part-moved-while-measured",
        between=between,
        feature=feature,
        off=quantity(1e3 * overlap.largest_mm, "µm", 1),
        u=quantity(1e3 * overlap.u_mm, "µm", 1),
    )


def _compare_at(
    scanned: Sequence[FeatureByMeans], cut: int, data: MeasuredPoints, shared: Floats
) -> tuple[Overlap, str] | None:
    """Frames before a number against the others, by the features that both have."""
    pairs, places, names = [], [], []
    for one in scanned:
        used = one.fitted.used
        frame = one.points.errors.frame[used]
        halves = [_fit_some(one, used[some], data) for some in (frame < cut, frame >= cut)]
        first, second = halves
        if first is None or second is None:
            continue
        pairs.append((MeasuredFeature(first, 0, False), MeasuredFeature(second, 0, False)))
        places.append(one.points.errors.points_mm[used])
        names.append(one.part.id)
    if not pairs:
        return None
    overlap = compare_features(pairs, places, shared)
    return overlap, names[overlap.feature]


def _fit_some(
    one: FeatureByMeans, some: NDArray[np.int64], data: MeasuredPoints
) -> FittedFeature | None:
    """A feature by some of its points; None where they are too few, or do not determine it."""
    if len(some) < LEAST_POINTS:
        return None
    points = one.points.select(some[:: -(-len(some) // MOST_POINTS)])
    try:
        return fit_feature(
            one.part.id,
            one.fitted.shape,
            points,
            data.program.map.radius_mm,
            one.part.form_allowance_mm,
        )
    except OperationError:
        return None


def _compare_touches(
    data: MeasuredPoints,
    scanned: Sequence[FeatureByMeans],
    features: Sequence[FeatureByMeans],
    T_arm_part: Floats,
    tip_radius_mm: float,
    shared: Floats,
) -> tuple[Overlap, str] | None:
    """Touches against the scan, by the features that have both."""
    pairs, places, names = [], [], []
    known = {one.part.id: one for one in features if one.means == "touch"}
    for number, one in enumerate(scanned, 1):
        name = one.part.id
        if name not in data.touched:
            continue
        touched = known[name].fitted if name in known else None
        if touched is None:
            touched = _fit_touches(data, one, T_arm_part, tip_radius_mm)
        if touched is None:
            continue
        used = one.fitted.used
        pairs.append(
            (MeasuredFeature(one.fitted, 0, False), MeasuredFeature(touched, number, True))
        )
        places.append(one.points.errors.points_mm[used])
        names.append(name)
    if not pairs:
        return None
    overlap = compare_features(pairs, places, shared)
    return overlap, names[overlap.feature]


def _fit_touches(
    data: MeasuredPoints, one: FeatureByMeans, T_arm_part: Floats, tip_radius_mm: float
) -> FittedFeature | None:
    try:
        (taken,) = take_points(data, [(one.part.id, "touch")], T_arm_part, tip_radius_mm)
        return fit_feature(*taken.given, data.program.map.radius_mm)
    except OperationError:
        return None
