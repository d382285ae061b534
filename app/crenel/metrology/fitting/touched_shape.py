"""Which contact points lie on one plane or sphere: those without which the rest agrees best."""

from collections.abc import Callable
from itertools import combinations

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.fitting.outlier_search import Agreement, Mask, find_agreement
from crenel.metrology.transforms import Floats

CONTACT_SD_MM = 0.1
"""Generously, of one contact point: what is off by far more was taken elsewhere."""
TOUCH_SD_MM = 0.001
"""The least, of the touch itself, in addition to the arm's noise."""
RADIUS_SD_MM = 0.5
"""The prior of the radius of sphere and tip together: another tip may be on."""
MOST_IN_SUBSETS = 30
"""With more points, one or two do not pull the fit to all of them far."""
LEAST_SPREAD_MM = 0.5
STEPS = 12


def agree_on_plane(
    tips_mm: Floats, covariances_mm2: Floats, most_sd_mm: float = CONTACT_SD_MM
) -> Agreement:
    """The contact points on the plane of the others.

    Args:
        tips_mm: (N, 3) tip centres, N >= 3.
        covariances_mm2: (N, 3, 3) of each by the arm's noise, which is the least that it has.
        most_sd_mm: the most that it has along the normal.

    Returns:
        (N,) which agree, and (N,) those of which one does not while the others cannot tell which.
    """
    tips = tips_mm - tips_mm.mean(axis=0)
    subsets = _subsets(len(tips), 3)
    middles = subsets @ tips / subsets.sum(axis=1)[:, None]
    spreads = np.einsum("bn,ni,nj->bij", subsets, tips, tips) / subsets.sum(axis=1)[:, None, None]
    values = np.linalg.eigvalsh(spreads - middles[:, :, None] * middles[:, None, :])
    values[values[:, 1] < LEAST_SPREAD_MM**2, 0] = np.inf  # points on a line fix no plane

    def equations(kept: Mask) -> tuple[Floats, Floats]:
        middle = tips[kept].mean(axis=0)
        along = np.linalg.svd(tips[kept] - middle)[2]
        sds = _sds_mm(covariances_mm2, np.tile(along[2], (len(tips), 1)))
        J = np.column_stack([np.ones(len(tips)), (tips - middle) @ along[:2].T])
        return J / sds[:, None], (tips - middle) @ along[2] / sds

    return _agree(equations, subsets[int(np.argmin(values[:, 0]))], most_sd_mm, covariances_mm2, 0)


def distances_from_plane_mm(tips_mm: Floats, kept: Mask) -> Floats:
    """(N,) of contact points from the plane through those that are kept, positive upward."""
    middle = tips_mm[kept].mean(axis=0)
    normal = np.linalg.svd(tips_mm[kept] - middle)[2][2]
    return np.asarray((tips_mm - middle) @ normal * (1.0 if normal[2] >= 0 else -1.0))


def agree_on_sphere(
    tips_mm: Floats, covariances_mm2: Floats, reach_mm: float, most_sd_mm: float = CONTACT_SD_MM
) -> Agreement:
    """The contact points on the sphere of the others.

    Args:
        tips_mm: (N, 3) tip centres, N >= 4.
        covariances_mm2: (N, 3, 3) of each by the arm's noise, which is the least that it has.
        reach_mm: radius of sphere and tip together, known to ``RADIUS_SD_MM``.
        most_sd_mm: the most that a contact point has along the normal.

    Returns:
        (N,) which agree, and (N,) those of which one does not while the others cannot tell which.
    """
    tips = tips_mm - tips_mm.mean(axis=0)
    subsets = _subsets(len(tips), 4)
    misfits = _spheres_through(tips, subsets, reach_mm)[2]

    def equations(kept: Mask) -> tuple[Floats, Floats]:
        centres, radii, _ = _spheres_through(tips, kept[None], reach_mm)
        away = tips - centres[0]
        far = np.linalg.norm(away, axis=1)
        outward = away / far[:, None]
        sds = _sds_mm(covariances_mm2, outward)
        J = np.column_stack([-outward / sds[:, None], -1 / sds])
        given = [0.0, 0.0, 0.0, 1 / RADIUS_SD_MM]
        off = [*((far - radii[0]) / sds), (radii[0] - reach_mm) / RADIUS_SD_MM]
        return np.vstack([J, given]), np.array(off)

    return _agree(equations, subsets[int(np.argmin(misfits))], most_sd_mm, covariances_mm2, 1)


def doubt_error(doubtful: Mask) -> OperationError | None:
    """The error ``contact-off-unknown-which`` if there are contact points of which one is off while
    the others cannot tell which; it names them."""
    if not doubtful.any():
        return None
    numbers = ", ".join(str(i + 1) for i in np.flatnonzero(doubtful))
    return OperationError(
        "contact-off-unknown-which",
        message("one-of-points-off", points=numbers),
        message("others-cannot-tell-which"),
        message("touch-again-beside-these"),
    )


def refuse_doubt(doubtful: Mask) -> None:
    """Raises ``OperationError``, as ``doubt_error``, if there is one."""
    if (error := doubt_error(doubtful)) is not None:
        raise error


def _agree(
    equations: Callable[[Mask], tuple[Floats, Floats]],
    start: Floats,
    most_sd_mm: float,
    covariances_mm2: Floats,
    given: int,
) -> Agreement:
    least = float(np.min(np.trace(covariances_mm2, axis1=1, axis2=2))) / 3 + TOUCH_SD_MM**2
    everything = np.ones(len(covariances_mm2), np.bool_)
    most = max(most_sd_mm**2 / least, 1.0)
    return find_agreement(equations, start > 0, everything, most, given)


def _sds_mm(covariances_mm2: Floats, normals: Floats) -> Floats:
    variances = np.einsum("ni,nij,nj->n", normals, covariances_mm2, normals)
    return np.asarray(np.sqrt(variances + TOUCH_SD_MM**2))


def _subsets(count: int, unknowns: int) -> Floats:
    """(B, N) of ones and zeros: all points but two, or but one of few; all of many."""
    spare = count - unknowns
    left_out = 0 if spare < 2 or count > MOST_IN_SUBSETS else 1 if spare < 4 else 2
    choices = list(combinations(range(count), left_out))
    subsets = np.ones((len(choices), count))
    for subset, out in zip(subsets, choices, strict=True):
        subset[list(out)] = 0.0
    return subsets


def _spheres_through(
    tips: Floats, subsets: Floats | Mask, reach_mm: float
) -> tuple[Floats, Floats, Floats]:
    """Centres (B, 3), radii (B,) and sums of squares (B,) of the spheres of each subset (B, N)."""
    weights = np.asarray(subsets, dtype=np.float64)
    system = np.column_stack([2 * tips, np.ones(len(tips))])
    normal = np.einsum("bn,ni,nj->bij", weights, system, system)
    right = np.einsum("bn,ni,n->bi", weights, system, np.sum(tips**2, axis=1))
    start = np.einsum("bij,bj->bi", np.linalg.pinv(normal, rcond=1e-9, hermitian=True), right)
    centres, radii = start[:, :3], np.full(len(weights), reach_mm)
    for _ in range(STEPS):
        away = tips - centres[:, None]
        far = np.maximum(np.linalg.norm(away, axis=2), 1e-9)
        J = np.concatenate([away / far[:, :, None], np.ones((*far.shape, 1))], axis=2)
        off = far - radii[:, None]
        normal = np.einsum("bn,bni,bnj->bij", weights, J, J)
        right = np.einsum("bn,bni,bn->bi", weights, J, off)
        # the prior of the radius, beside contact points of a tenth of what is generous
        known = (0.1 * CONTACT_SD_MM / RADIUS_SD_MM) ** 2
        normal[:, 3, 3] += known
        right[:, 3] += known * (reach_mm - radii)
        change = np.einsum("bij,bj->bi", np.linalg.pinv(normal, rcond=1e-12, hermitian=True), right)
        centres, radii = centres + change[:, :3], radii + change[:, 3]
    off = np.linalg.norm(tips - centres[:, None], axis=2) - radii[:, None]
    return centres, radii, np.sum(weights * off**2, axis=1)
