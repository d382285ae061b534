"""Checks of coordinates that another instrument measured: too few, another unit or frame, another
arm, or another marker than named."""

from collections.abc import Sequence
from math import ceil

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.identification.checks.misfit import explain_misfit
from crenel.metrology.arm.identification.cross_validation import FOLDS
from crenel.metrology.arm.identification.initial_unknowns import (
    TYPICAL,
    align_frame,
    initial_unknowns,
    marker_points,
)
from crenel.metrology.arm.identification.least_squares import residuals
from crenel.metrology.arm.identification.observations import (
    BASE,
    TIP,
    ArmObservations,
    StackedObservations,
)
from crenel.metrology.arm.identification.parameter_selection import candidates_of
from crenel.metrology.arm.identification.parameters import Indices
from crenel.metrology.arm.identification.robust_solve import ArmFit, settle_frames
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.identification.unknowns import Unknowns
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats, apply, skews
from crenel.units import mistaken_unit

LEAST_IN_FRAME, WANTED_POSES = 6, 50
FEW = 2
"""Values for each unknown, below which a warning is given."""
SAME_UNIT = 2.0
"""Coordinates spread less or more than the arm's by this factor are in another unit."""
OTHER_SPREAD = 0.25
"""By which share the spread of points may be off in the unit that they are in."""
OTHER_ARM_MM = 100.0
"""Points of the right arm lie closer to a reasonable arm.json."""
OTHER_MARKER_MM = 5.0
FAR, FAR_MM, FAR_SHARE = 10.0, 5.0, 0.15
"""Points that lie off by this multiple of the typical distance, if they are so many, may be in
another frame."""
AS_CLOSE, AS_CLOSE_MM = 5.0, 2.0
"""They are, if they lie in one of their own almost as well as the others."""
OTHER_ROTATION_RAD = np.deg2rad(15.0)
LEAST_STEADY, SPLITS, STEADY = 30, 200, 0.4
"""Points that show whether their frame moved, number of rows at which it may have, and the share of
the scatter that then is left at most."""
DISAGREE_SHARE, LARGEST_SCATTER_MM = 0.25, 5.0


def check_coordinates(arm: Arm, observations: ArmObservations) -> None:
    """Refuses coordinates that cannot be those of the named markers on this arm."""
    if not observations.coordinates:
        return
    data = ArmObservations(coordinates=observations.coordinates).stacked
    _check_enough(arm, observations, data)
    at = initial_unknowns(arm, data)
    try:
        _check_unit(data, at)
        _check_frames(data, at)
        at = settle_frames(data, at)
        _check_frames(data, at)
    except OperationError as error:
        raise explain_misfit(arm, observations.coordinates, error) from error
    found = residuals(data, at, Scatter())
    turned = data.coordinates.has_rotation
    if turned.any():
        _check_rotations(found.angles_rad[turned])
    if observations.groups_count and TIP in {one.name for one in data.coordinates.markers}:
        _check_marker_is_tip(arm, at)


def _check_enough(arm: Arm, observations: ArmObservations, data: StackedObservations) -> None:
    found = data.coordinates
    for i, name in enumerate(found.frames):
        count = int(np.sum(found.frame_of == i))
        if name != BASE and count < LEAST_IN_FRAME:
            raise OperationError(
                "too-few-points",
                message("frame-has-points", name=name, count=count),
                message("least-needed-to-know-frame", least=LEAST_IN_FRAME),
                message("measure-more-there-or-delete-rows"),
            )
    if observations.groups_count:
        return
    figures, unknown = _figures_and_unknowns(arm, observations)
    per_pose = figures / len(found.q_rad)
    # what is left while a fold is held out must determine them, too
    least = ceil(FOLDS / (FOLDS - 1) * unknown / per_pose) + 1
    if len(found.q_rad) < least:
        raise OperationError(
            "too-few-points",
            message("coordinates-give-figures", poses=len(found.q_rad), figures=figures),
            message("arm-and-frame-have-unknowns", unknown=unknown),
            message("measure-more-poses", least=least, wanted=WANTED_POSES),
        )


def coordinate_warnings(arm: Arm, observations: ArmObservations) -> list[Text]:
    """Warns if coordinates alone hardly check the parameters that they determine."""
    if observations.groups_count or not observations.coordinates:
        return []
    figures, unknown = _figures_and_unknowns(arm, observations)
    if figures >= FEW * unknown:
        return []
    poses = observations.coordinates_count
    return [
        message("few-poses", poses=poses, figures=figures, unknown=unknown, wanted=WANTED_POSES)
    ]


def _figures_and_unknowns(arm: Arm, observations: ArmObservations) -> tuple[int, int]:
    """Number of measured values of coordinates, and of all that they could determine."""
    data = observations.stacked
    found = data.coordinates
    figures = 3 * len(found.q_rad) + 3 * int(found.has_rotation.sum())
    return figures, len(candidates_of(arm, observations).order) + data.others.count


def _check_unit(data: StackedObservations, at: Unknowns) -> None:
    found = data.coordinates
    predicted = marker_points(data, at)
    for i, name in enumerate(found.frames):
        own = found.frame_of == i
        measured_mm, expected_mm = (
            _spread_mm(points[own]) for points in (found.points_mm, predicted)
        )
        if expected_mm / SAME_UNIT <= measured_mm <= expected_mm * SAME_UNIT:
            continue
        ratio = expected_mm / max(measured_mm, 1e-9)
        unit = "m" if 200 < ratio < 5000 else mistaken_unit(ratio, OTHER_SPREAD)
        raise OperationError(
            "coordinates-unit",
            message(
                "coordinates-spread",
                name=name,
                measured=quantity(measured_mm, "mm", 3 if unit else 0),
                expected=quantity(expected_mm, "mm"),
            ),
            message("lengths-of-unit-expected-mm", unit=unit)
            if unit
            else message("another-unit-arm-or-marker"),
            message("convert-columns-x-mm-y-mm") if unit else message("check-unit-arm-and-rows"),
        )


def _spread_mm(points: Floats) -> float:
    """Typical distance (mm) of points from their middle."""
    return median(np.linalg.norm(points - np.median(points, axis=0), axis=1))


def _check_frames(data: StackedObservations, at: Unknowns) -> None:
    off_mm = residuals(data, at, Scatter()).distances_mm
    for i, name in enumerate(data.coordinates.frames):
        own = np.flatnonzero(data.coordinates.frame_of == i)
        _check_one_frame(name, own, data, at, off_mm[own])


def _check_one_frame(
    name: str, own: Indices, data: StackedObservations, at: Unknowns, off_mm: Floats
) -> None:
    """Refuses points (indices ``own``) of another arm, or of two frames under one name."""
    typical_mm = float(np.quantile(off_mm, TYPICAL))
    if typical_mm > OTHER_ARM_MM:
        raise OperationError(
            "arm-does-not-fit",
            message("markers-lie-far", name=name, off=quantity(typical_mm, "mm")),
            message("points-were-taken-another-arm-file"),
            message("check-signs-lengths-joints-order"),
        )
    far = own[off_mm > max(FAR * typical_mm, FAR_MM)]
    if name == BASE or len(far) < max(LEAST_IN_FRAME, FAR_SHARE * len(own)):
        return
    predicted, measured = marker_points(data, at)[far], data.coordinates.points_mm[far]
    T = align_frame(predicted, measured)
    left_mm = np.linalg.norm(apply(T, measured) - predicted, axis=1)
    if median(left_mm) > max(AS_CLOSE * typical_mm, AS_CLOSE_MM):
        return
    lines = [data.coordinates.lines[i] for i in far]
    raise OperationError(
        "frames-mixed",
        message(
            "points-lie-in-another-frame",
            name=name,
            far=len(far),
            points=len(own),
            first=min(lines),
            last=max(lines),
            off=quantity(median(off_mm[np.isin(own, far)]), "mm", 1),
        ),
        message("instrument-or-base-moved"),
        message("name-frame-of-each-set-up"),
    )


def _check_rotations(angles_rad: Floats) -> None:
    typical = median(angles_rad)
    if typical > OTHER_ROTATION_RAD:
        raise OperationError(
            "rotations-do-not-fit",
            message("rotations-differ", angle=quantity(np.rad2deg(typical), "°")),
            message("rotations-other-order-or-direction"),
            message("give-rotation-of-marker-in-frame"),
        )


def _check_marker_is_tip(arm: Arm, at: Unknowns) -> None:
    """Refuses coordinates of another marker, if the tip itself was seated as well."""
    far_mm = float(np.linalg.norm(at.arm.tip.centre_mm - arm.tip.centre_mm))
    if far_mm > OTHER_MARKER_MM:
        raise OperationError(
            "marker-not-tip",
            message("measured-points-not-tip", far=quantity(far_mm, "mm", 1)),
            message("without-marker-coordinates-are-tips"),
            message("name-marker-in-column"),
        )


def _check_steady(name: str, off_mm: Floats, points_mm: Floats, lines: Sequence[int]) -> None:
    """Refuses points (m, 3) of a frame most of whose scatter is one step between two rows."""
    count = len(off_mm)
    if count < LEAST_STEADY:
        return
    splits = range(LEAST_IN_FRAME, count - LEAST_IN_FRAME + 1, max(1, count // SPLITS))
    by_turn = skews(points_mm - points_mm.mean(axis=0))
    rigid_rows = np.concatenate([np.tile(np.eye(3), (count, 1, 1)), by_turn], axis=2)
    spread = [_rest_after_step(off_mm, rigid_rows, split) for split in splits]
    best = splits[int(np.argmin(spread))]
    if min(spread) > STEADY * float(np.sum((off_mm - off_mm.mean(axis=0)) ** 2)):
        return
    step_mm = np.median(off_mm[best:], axis=0) - np.median(off_mm[:best], axis=0)
    raise OperationError(
        "frames-mixed",
        message(
            "points-moved-from-line-on",
            name=name,
            line=lines[best],
            off=quantity(float(np.linalg.norm(step_mm)), "mm", 2),
        ),
        message("instrument-or-base-moved"),
        message("name-frame-of-each-set-up"),
    )


def _rest_after_step(off_mm: Floats, rigid_rows: Floats, split: int) -> float:
    """Sum of squares (mm²) that a small motion of the frame at one row leaves.

    Args:
        rigid_rows: (m, 3, 6) derivative of the points by the motion.
    """
    steps = np.concatenate([np.tile(np.eye(3), (len(off_mm), 1, 1)), rigid_rows], axis=2)
    steps[:split, :, 3:] = 0.0
    A, b = steps.reshape(-1, 9), off_mm.ravel()
    return float(np.sum((b - A @ np.linalg.lstsq(A, b, rcond=None)[0]) ** 2))


def check_coordinates_agree(data: StackedObservations, fit: ArmFit) -> None:
    """Refuses a frame many of whose points disagree, or that moved between two rows, and
    coordinates the arm does not explain."""
    found = data.coordinates
    off_mm = residuals(data, fit.at, fit.scatter).vectors_mm[data.touches :]
    for i, name in enumerate(found.frames):
        if name != BASE:
            own = np.flatnonzero((found.frame_of == i) & fit.inliers[data.touches :])
            _check_steady(name, off_mm[own], found.points_mm[own], [found.lines[k] for k in own])
    for i, name in enumerate(found.frames):
        own = found.frame_of == i
        out = int(np.sum(~fit.inliers[data.touches :][own]))
        if out >= 3 and out > DISAGREE_SHARE * own.sum():
            raise OperationError(
                "place-disagrees",
                message("points-of-frame-disagree", name=name, out=out, points=int(own.sum())),
                message("instrument-moved-or-angles-of-other-pose"),
                message("measure-again-or-delete-rows"),
            )
    if len(found.q_rad) and fit.scatter.point_mm > LARGEST_SCATTER_MM:
        scatter: Text = quantity(fit.scatter.point_mm, "mm", 1)
        raise OperationError(
            "identification-explains-nothing",
            message("even-best-arm-points-still-scatter", scatter=scatter),
            message("not-of-such-an-arm-or-tip-not-seated"),
            message("check-encoders-arm-json-how-points"),
        )
