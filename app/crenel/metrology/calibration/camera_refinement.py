"""Maximum-likelihood refinement of camera, lens, laser plane and block in one adjustment.

After Faugeras' linear step, everything that a capture shows enters one adjustment: points on the
block's straight edges (or its corners); the stripe, which follows one straight line on all crests
and another on all floors; and the certificate, whose coordinates are known to its standard
uncertainty.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.calibration.laser_plane_fit import LaserPlaneFit
from crenel.metrology.calibration.observation_model import (
    BLOCK,
    Rows,
    SceneModel,
    coordinates,
    corner_rows,
    edge_rows,
    empty_rows,
    stripe_rows,
)
from crenel.metrology.detection.detect_block import Corner, EdgePoints
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.projection import COUNT, LENS
from crenel.metrology.sensor.residual_correlation import variances_of_lines
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# Prior of any lens and sensor; it matters only if the picture contains no information: pixels
# square to this share, axis off by this share of the width.
ASPECT_SD = 0.002
AXIS_SD_WIDTHS = 0.25
LENS_SD = np.array([0.5, 2.0, 0.01, 0.01])  # k1, k2, p1, p2
# Lens terms in the order of trial, each kept if it exceeds its standard deviation by this factor:
# larger for terms that lenses seldom need.
LENS_TERMS = (((0,), 2.0), ((1,), 3.0), ((2, 3), 5.0))
OUTLIER_SIGMAS = 4.5
FEWEST_TO_JUDGE = 12
# Outliers and factors are judged in the first iterations only, so that the rest converge.
ROUNDS_OF_JUDGING = 6


@dataclass(frozen=True)
class GroupFit:
    """How well one kind of observation fits: rms in px, and which rows (N,) were kept."""

    rms_px: float
    inliers: NDArray[np.bool_]


@dataclass(frozen=True)
class CameraFit:
    """The adjusted scene and its covariance (P, P), parameters as in ``scene.names``.

    ``sources`` splits the covariance by source: ``edges``, ``stripe``, ``certificate`` and
    ``distortion`` (the contribution of an unknown lens). ``by_certificate`` (P, B) are the
    derivatives of the parameters by each coordinate of the certificate.
    """

    scene: SceneModel
    covariance: Floats
    sources: dict[str, Floats]
    by_certificate: Floats
    edges: GroupFit
    stripe: GroupFit

    @property
    def camera(self) -> Camera:
        return self.scene.camera

    @property
    def plane(self) -> LaserPlane:
        return self.scene.plane


@dataclass(frozen=True)
class ImageObservations:
    """The observations: edge points, or corners if there are none, and the stripe."""

    edges: Sequence[EdgePoints]
    corners: Sequence[Corner]
    stripe: Stripe
    levels: LaserPlaneFit

    def groups(self, scene: SceneModel) -> tuple[Rows, Rows]:
        if len(self.edges):
            shape = edge_rows(scene, self.edges)
        elif len(self.corners):
            shape = corner_rows(scene, self.corners)
        else:
            shape = empty_rows(scene)
        level = np.where(self.levels.used, self.levels.level, "")
        return shape, stripe_rows(scene, self.stripe, level)


def fit_camera(camera: Camera, block: Crenellated, seen: ImageObservations) -> CameraFit:
    """Maximum-likelihood camera, lens terms, laser plane and block from one pose.

    Lens terms are kept only if they clearly exceed their standard uncertainty.

    Args:
        camera: start values within a few pixels; sensor frame = object frame.
        block: the certificate, which enters with its standard uncertainty.
        seen: what the images show; edge points are preferred to corners, which are computed from
            them.

    Returns:
        The adjusted scene with its covariance (k = 1), and how well edges and stripe fit, px.

    Raises:
        OperationError: ``too-few-edges`` or ``camera-fit-failed``.
    """
    lens: tuple[int, ...] = ()
    start = SceneModel(replace(camera, distortion=np.zeros(5)), seen.levels.plane, block)
    best = _adjust(start, block, seen, lens)
    for term, significant in LENS_TERMS:
        tried = _adjust(best.scene, block, seen, (*lens, *term))
        at = [LENS.start + k for k in term]
        value = tried.camera.distortion[list(term)]
        square = value @ np.linalg.solve(tried.covariance[np.ix_(at, at)], value)
        if square > significant**2:
            lens, best = (*lens, *term), tried
    return best


def _adjust(
    scene: SceneModel, certificate: Crenellated, seen: ImageObservations, lens: tuple[int, ...]
) -> CameraFit:
    """Gauss-Newton on all parameters except the lens terms that are held at zero."""
    free = np.ones(len(scene.names), dtype=np.bool_)
    free[LENS] = np.isin(np.arange(4), lens)
    kept, inflation = _assess_rows(seen.groups(scene))
    for turn in range(40):
        groups = seen.groups(scene)
        if turn < ROUNDS_OF_JUDGING:
            kept, inflation = _assess_rows(groups)
        _require_enough(kept, int(free[: BLOCK.start].sum()))
        parts = [_normal(*group) for group in zip(groups, kept, inflation, strict=True)]
        parts.append(_prior(scene, certificate))
        N = np.sum([part for part, _ in parts], axis=0)
        g = np.sum([gradient for _, gradient in parts], axis=0)
        step = np.zeros(len(free))
        step[free] = -_inverse(N[np.ix_(free, free)]) @ g[free]
        scene = scene.apply_step(step)
        if float(np.max(np.abs(step) * np.sqrt(np.diag(N)))) < 1e-3:
            fits = [_group(*group) for group in zip(groups, kept, strict=True)]
            return _result(scene, fits, [part for part, _ in parts], free)
    raise OperationError(
        "camera-fit-failed",
        message("camera-parameters-do-not-converge"),
        message("picture-objects-certificate-contradict-each-other"),
        message("check-object-picture-take-picture-again"),
    )


def _assess_rows(groups: tuple[Rows, Rows]) -> tuple[list[NDArray[np.bool_]], list[Floats]]:
    """The rows of each group that agree, and the factors on their standard deviations."""
    kept = [_agreeing(rows) for rows in groups]
    return kept, [_inflation(rows, mask) for rows, mask in zip(groups, kept, strict=True)]


def _require_enough(kept: list[NDArray[np.bool_]], parameters: int) -> None:
    found = sum(int(mask.sum()) for mask in kept)
    if found < parameters + 4:
        raise OperationError(
            "too-few-edges",
            message("usable-edge-stripe-points", found=found),
            message("they-do-not-determine-camera"),
            message("bring-more-object-into-picture-sharp"),
        )


def _agreeing(rows: Rows) -> NDArray[np.bool_]:
    """Rows (N,) within the limit, measured by their own scatter if that is larger."""
    off = np.abs(rows.residuals / rows.sigma)
    spread = max(sigma_from_median(off), 1.0) if len(off) else 1.0
    return np.asarray(off < OUTLIER_SIGMAS * spread)


def _inflation(rows: Rows, kept: NDArray[np.bool_]) -> Floats:
    """Factors (N,) on the standard deviations, one for each line: scatter beyond the stated noise,
    correlation of adjacent points (speckle), and the error that all points of a line share."""
    off = rows.residuals / rows.sigma
    variance = variances_of_lines(off, rows.line, kept, rows.places, False, FEWEST_TO_JUDGE)
    # a shared error does not average out along the line
    lines, line = int(rows.line.max(initial=0)) + 1, rows.line[kept]
    shared = np.bincount(line, (rows.shared_px / rows.sigma[kept]) ** 2, lines)
    enough = np.bincount(line, minlength=lines) >= FEWEST_TO_JUDGE
    return np.asarray(np.sqrt(variance + np.where(enough, shared, 0.0)[rows.line]))


def _normal(rows: Rows, kept: NDArray[np.bool_], inflation: Floats) -> tuple[Floats, Floats]:
    weight = (rows.sigma * inflation)[kept] ** -2.0
    J = rows.jacobian[kept]
    return np.asarray((J * weight[:, None]).T @ J), np.asarray(
        J.T @ (weight * rows.residuals[kept])
    )


def _prior(scene: SceneModel, certificate: Crenellated) -> tuple[Floats, Floats]:
    """Priors: certificate, square pixels, an axis near the middle, little distortion; matrix and
    gradient."""
    count = len(scene.names)
    N, g = np.zeros((count, count)), np.zeros(count)
    camera = scene.camera
    K = camera.matrix
    weight = np.maximum(certificate.sds_mm, 1e-6) ** -2.0
    at = np.arange(count)[BLOCK]
    N[at, at] = weight
    g[at] = weight * (coordinates(scene.block) - coordinates(certificate))
    aspect = np.zeros(count)
    aspect[0], aspect[1] = -K[1, 1] / K[0, 0] ** 2, 1 / K[0, 0]
    N += np.outer(aspect, aspect) / ASPECT_SD**2
    g += aspect * (K[1, 1] / K[0, 0] - 1) / ASPECT_SD**2
    middle = (np.array([camera.width_px, camera.height_px]) - 1) / 2
    axis_weight = (AXIS_SD_WIDTHS * camera.width_px) ** -2.0
    N[[2, 3], [2, 3]] += axis_weight
    g[2:4] += axis_weight * (K[:2, 2] - middle)
    lens = np.arange(LENS.start, COUNT)
    N[lens, lens] += LENS_SD**-2.0
    g[lens] += camera.distortion[:4] * LENS_SD**-2.0
    return N, g


def _inverse(N: Floats) -> Floats:
    scale = 1 / np.sqrt(np.diag(N))
    return np.asarray(np.linalg.inv(N * np.outer(scale, scale)) * np.outer(scale, scale))


def _result(
    scene: SceneModel,
    fits: list[GroupFit],
    parts: list[Floats],
    free: NDArray[np.bool_],
) -> CameraFit:
    """Covariance, and its split by source, from the normal matrices of the parts."""
    shape, stripe, prior = parts
    N = shape + stripe + prior
    covariance = _free_covariance(N, free)
    known_lens = free.copy()
    known_lens[LENS] = False
    C = _free_covariance(N, known_lens)
    certificate = np.zeros_like(N)
    at = np.arange(len(N))[BLOCK]
    certificate[at, at] = prior[at, at]
    sources = {
        "edges": C @ (shape + prior - certificate) @ C,
        "stripe": C @ stripe @ C,
        "certificate": C @ certificate @ C,
        "distortion": covariance - C,
    }
    return CameraFit(scene, covariance, sources, C @ certificate[:, BLOCK], *fits)


def _group(rows: Rows, kept: NDArray[np.bool_]) -> GroupFit:
    residuals = rows.residuals[kept]
    rms = float(np.sqrt(np.mean(residuals**2))) if len(residuals) else 0.0
    return GroupFit(rms, kept)


def _free_covariance(N: Floats, free: NDArray[np.bool_]) -> Floats:
    """The covariance of the free parameters, with zeros for those that are held."""
    covariance = np.zeros_like(N)
    covariance[np.ix_(free, free)] = _inverse(N[np.ix_(free, free)])
    return covariance
