"""Identifies an arm: fits its geometry to measured places and checks the fit on held-out places."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.identification.checks.artefacts import (
    check_bars,
    check_spheres,
    check_tip_diameter,
)
from crenel.metrology.arm.identification.checks.coordinates import (
    check_coordinates,
    check_coordinates_agree,
    coordinate_warnings,
)
from crenel.metrology.arm.identification.checks.places import check_places_fixed
from crenel.metrology.arm.identification.checks.points import (
    check_arm_fits,
    check_disjoint,
    check_enough,
    check_scatter,
    identification_warnings,
)
from crenel.metrology.arm.identification.cross_validation import (
    Validation,
    compare_arms,
    cross_validate,
    without_points,
)
from crenel.metrology.arm.identification.least_squares import residuals
from crenel.metrology.arm.identification.observations import ArmObservations, StackedObservations
from crenel.metrology.arm.identification.parameter_selection import (
    REASONS,
    FixedReason,
    candidates_of,
)
from crenel.metrology.arm.identification.parameters import parameter_names, parameter_values
from crenel.metrology.arm.identification.robust_solve import ArmFit, fit_arm
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.identification.volumetric_error import (
    volumetric_difference_mm,
    volumetric_uncertainty_mm,
)
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.transforms import Floats, inverse
from crenel.progress import Progress, no_progress

CORRELATED = 0.95
"""Parameters with a larger correlation are reported."""
BETTER = 1.05
"""Held-out deviations must be reduced at least by this factor."""

LARGE_DEVIATION = 1.4
"""Held-out deviations, in standard deviations, above which more places would help."""
SMALL_DEVIATION = 0.5
"""Held-out deviations, in standard deviations, below which more is stated than there is."""


@dataclass(frozen=True)
class ParameterChange:
    """A parameter that the points determine: mm or rad by its name, standard uncertainty k = 1."""

    name: str
    before: float
    after: float
    standard_uncertainty: float


@dataclass(frozen=True)
class FixedParameter:
    """A parameter that kept its value, and why."""

    name: str
    reason: FixedReason

    @property
    def why(self) -> Text:
        return REASONS[self.reason]


@dataclass(frozen=True)
class Outlier:
    """A point that was excluded."""

    place: Text
    number: int
    """The number of a touch at its place, counted from 1; for a coordinate the line in its file."""
    distance_mm: float
    is_coordinate: bool = False


@dataclass(frozen=True)
class FoundFrame:
    """Where an instrument saw the arm's base."""

    name: str
    T_frame_arm: Floats
    """(4, 4)"""
    standard_uncertainty_mm: float | None
    """The standard uncertainty of each coordinate of the base's origin, rms; None if the frame was
    given."""


@dataclass(frozen=True)
class FoundMarker:
    """A marker on the last link, in the flange frame."""

    name: str
    offset_mm: Floats
    """(3,)"""
    standard_uncertainty_mm: Floats | None
    """(3,); None if the place was given, or is that of the tip, which the arm has."""
    rotation: Floats | None
    """(3, 3), if its full pose was measured."""


@dataclass(frozen=True)
class Identification:
    """The identified arm, and the data it is based on."""

    arm: Arm
    changes: tuple[ParameterChange, ...]
    fixed: tuple[FixedParameter, ...]
    covariance: Floats
    """(p, p) of ``moved``, mm and rad, k = 1."""
    correlations: tuple[tuple[str, str, float], ...]
    """Pairs of ``moved`` beyond ±0.95, the strongest first."""
    touched: bool
    """Whether the tip measured seats, spheres or bars."""
    scatter: Scatter
    """Beyond what the encoders and the stated uncertainties explain."""
    radius_excess_mm: float
    """How much larger the spheres are measured than the radii of sphere and tip state."""
    radius_excess_sd_mm: float | None
    """None without spheres."""
    frames: tuple[FoundFrame, ...]
    markers: tuple[FoundMarker, ...]
    outliers: tuple[Outlier, ...]
    validation: Validation
    volume_before_mm: float
    """Rms difference of the tip over the arm's reach between the given and the identified arm."""
    volume_after_mm: float
    """Rms standard uncertainty of the tip over the reach, due to the moved parameters.

    It does not include the arm's scale unless a ball bar determined it.
    """
    warnings: tuple[Text, ...]

    @property
    def size_known(self) -> bool:
        """Whether a calibrated length determined the arm's scale."""
        return all(held.reason != "scale" for held in self.fixed)


def identify(
    arm: Arm,
    observations: ArmObservations,
    check: ArmObservations | None = None,
    progress: Progress = no_progress,
) -> Identification:
    """Fits Denavit-Hartenberg parameters, error terms between parallel axes, and the tip.

    Parameters that the points cannot determine keep their values. The result is checked on
    places that the fit did not use.

    Args:
        arm: the arm by its datasheet; the start of the fit.
        check: places that are kept out of the fit to test it; None: every k-th place is held out
            in turn.
        progress: called with the share done and the current step.

    Returns:
        The arm with covariance (mm and rad, k = 1), outliers, and errors before and after.

    Raises:
        OperationError: too few or unsuitable points (``too-few-places``, ``too-few-points``,
            ``points-twice``, ``arm-hardly-moved``, ``joint-still``, ``check-seen``); points that
            contradict the arm or each other (``arm-does-not-fit``, ``seat-moved``,
            ``place-disagrees``, ``bar-length``, ``sphere-diameter``, ``tip-diameter``);
            coordinates in another unit, frame or of another marker (``coordinates-unit``,
            ``frames-mixed``, ``rotations-do-not-fit``, ``marker-not-tip``); or no useful result
            (``identification-diverges``, ``identification-explains-nothing``,
            ``identification-no-better``).

    Source:
        The model is Eq. 2 and 3 of the article.
    """
    check_enough(arm, observations)
    check_arm_fits(arm, observations)
    check_coordinates(arm, observations)
    if check is not None:
        check_disjoint(observations, check)
    data = observations.stacked
    progress(0.1, message("fitting-arm"))
    fit = fit_arm(arm, data, candidates_of(arm, observations))
    spheres = check_spheres(data, fit)
    check_places_fixed(arm, observations, data, fit)
    check_coordinates_agree(data, fit)
    bars = check_bars(arm, observations, fit)
    check_scatter(fit)
    check_tip_diameter(arm, data, fit)
    progress(0.4, message("checking-places-held-out"))
    good = without_points(observations, fit.inliers)
    if check is None:
        validation = cross_validate(arm, good, fit.scatter)
    else:
        validation = compare_arms(arm, fit, data, check)
    if validation.ratio < BETTER:
        raise _no_improvement_error(validation)
    progress(0.9, "")
    on_spheres = bool(observations.spheres)
    return Identification(
        arm=fit.at.arm,
        changes=_parameter_changes(arm, fit),
        fixed=_list_fixed(arm, fit),
        covariance=fit.covariance,
        correlations=_correlations(arm, fit),
        touched=data.touches > 0,
        scatter=fit.scatter,
        radius_excess_mm=fit.at.radius_excess_mm if on_spheres else 0.0,
        radius_excess_sd_mm=float(np.sqrt(fit.others_covariance[0, 0])) if on_spheres else None,
        frames=_frames(data, fit),
        markers=_markers(data, fit),
        outliers=_outliers(data, fit),
        validation=validation,
        volume_before_mm=volumetric_difference_mm(arm, fit.at.arm),
        volume_after_mm=volumetric_uncertainty_mm(fit.at.arm, fit.moved, fit.covariance),
        warnings=(
            *bars,
            *spheres,
            *coordinate_warnings(arm, observations),
            *identification_warnings(arm, observations, fit),
            *_deviation_warning(validation),
        ),
    )


def _no_improvement_error(validation: Validation) -> OperationError:
    before, after = validation.before.normalised, validation.after.normalised
    if max(before, after) < SMALL_DEVIATION:
        return OperationError(
            "uncertainty-too-large",
            message(
                "places-held-out-arms-errors-go",
                before=quantity(before, "", 2),
                after=quantity(after, "", 2),
            ),
            message("points-scatter-less-than-stated"),
            message("state-uncertainty-in-mm"),
        )
    explained = before < 1.3
    decimals = 2 if explained else 1
    return OperationError(
        "identification-no-better",
        message(
            "places-held-out-arms-errors-go",
            before=quantity(before, "", decimals),
            after=quantity(after, "", decimals),
        ),
        message("arms-parameters-already-explain-points-well")
        if explained
        else message("fit-follows-these-points-arm"),
        message("keep-arm-json-use") if explained else message("take-more-places-all-over-reach"),
    )


def _deviation_warning(validation: Validation) -> tuple[Text, ...]:
    left = validation.after.normalised
    if left < SMALL_DEVIATION:
        return (message("places-held-out-agree-too-well", times=quantity(left, "", 2)),)
    if left < LARGE_DEVIATION:
        return ()
    return (message("places-held-out-still-deviate", times=quantity(left, "", 1)),)


def _parameter_changes(arm: Arm, fit: ArmFit) -> tuple[ParameterChange, ...]:
    names, before, after = parameter_names(arm), parameter_values(arm), parameter_values(fit.at.arm)
    sds = np.sqrt(np.diag(fit.covariance))
    return tuple(
        ParameterChange(names[i], float(before[i]), float(after[i]), float(sd))
        for i, sd in zip(fit.moved, sds, strict=True)
    )


def _list_fixed(arm: Arm, fit: ArmFit) -> tuple[FixedParameter, ...]:
    names = parameter_names(arm)
    return tuple(FixedParameter(names[i], fit.fixed[i]) for i in sorted(fit.fixed))


def _correlations(arm: Arm, fit: ArmFit) -> tuple[tuple[str, str, float], ...]:
    names = parameter_names(arm)
    sds = np.sqrt(np.diag(fit.covariance))
    rho = fit.covariance / np.outer(sds, sds)
    first, second = np.nonzero(np.triu(np.abs(rho) > CORRELATED, 1))
    pairs = zip(first.tolist(), second.tolist(), strict=True)
    found = [(names[fit.moved[i]], names[fit.moved[j]], float(rho[i, j])) for i, j in pairs]
    return tuple(sorted(found, key=lambda pair: -abs(pair[2])))


def _frames(data: StackedObservations, fit: ArmFit) -> tuple[FoundFrame, ...]:
    found: list[FoundFrame] = []
    names = data.coordinates.frames
    for name, T, own in zip(names, fit.at.T_arm_frames, data.others.frames, strict=True):
        sd: float | None = None
        if own is not None:
            # the base's origin as the frame has it: moved by the frame's own rotation, too
            by_twist = np.hstack([np.zeros((3, 3)), -T[:3, :3].T])
            covariance = by_twist @ fit.others_covariance[own, own] @ by_twist.T
            sd = float(np.sqrt(np.trace(covariance) / 3))
        found.append(FoundFrame(name, inverse(T), sd))
    return tuple(found)


def _markers(data: StackedObservations, fit: ArmFit) -> tuple[FoundMarker, ...]:
    found: list[FoundMarker] = []
    for k, marker in enumerate(data.coordinates.markers):
        own = data.others.offsets[k]
        sds = None if own is None else np.sqrt(np.diag(fit.others_covariance[own, own]))
        offset = fit.at.arm_with(k, marker).tip.centre_mm
        rotation = fit.at.R_flange_markers[k] if marker.has_rotation else None
        found.append(FoundMarker(marker.name, offset, sds, rotation))
    return tuple(found)


def _outliers(data: StackedObservations, fit: ArmFit) -> tuple[Outlier, ...]:
    off = residuals(data, fit.at, fit.scatter).distances_mm
    found: list[Outlier] = []
    for i in np.flatnonzero(~fit.inliers):
        if i < data.touches:
            place = data.places[data.place_of[i]]
            label, number = place.label, int(i) - place.rows.start + 1
        else:
            measured = data.coordinates
            label = message(
                "frame-named", name=measured.frames[measured.frame_of[i - data.touches]]
            )
            number = measured.lines[i - data.touches]
        found.append(Outlier(label, number, float(off[i]), bool(i >= data.touches)))
    return tuple(found)
