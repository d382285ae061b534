"""Size, form and dispersion of a probed or scanned sphere, over all points without a filter."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

HELD = 0.95
STEPS = 60
SINGULAR = 1e-9


@dataclass(frozen=True)
class SphereOfPoints:
    """The least-squares sphere of all points, and what they are off it."""

    centre_mm: Floats  # (3,)
    diameter_mm: float
    form_mm: float
    """Largest minus smallest distance from the centre."""
    scatter_mm: float
    """Standard deviation of a point along the radius; 0 of four points."""
    cofactor: Floats
    """(4, 4) of centre and radius, for independent radial noise of 1."""


def least_squares_sphere(points_mm: Floats) -> SphereOfPoints:
    """The sphere of least squares of the radial distances, of all points, unweighted.

    Args:
        points_mm: (N, 3), N >= 4.

    Raises:
        OperationError: ``points-fix-no-sphere``.

    Source:
        ISO 10360-5 and -12: associated feature without a filter; Gauss-Newton, which is exact to
        the last digits because every step starts at the residuals of the points themselves.
    """
    if len(points_mm) < 4:
        raise _no_sphere_error()
    origin = points_mm.mean(axis=0)
    points = points_mm - origin
    centre, radius = _algebraic_sphere(points)
    for _ in range(STEPS):
        away = points - centre
        distance = np.linalg.norm(away, axis=1)
        J = np.column_stack([-away / distance[:, None], -np.ones(len(points))])
        change, _, _, singular = np.linalg.lstsq(J, -(distance - radius), rcond=None)
        if singular[-1] < SINGULAR * singular[0]:
            raise _no_sphere_error()
        centre, radius = centre + change[:3], radius + float(change[3])
        if np.max(np.abs(change)) < 1e-13 * max(radius, 1.0):
            break
    distance = np.linalg.norm(points - centre, axis=1)
    squares = float(np.sum((distance - radius) ** 2))
    return SphereOfPoints(
        centre + origin,
        2 * radius,
        float(np.ptp(distance)),
        float(np.sqrt(squares / (len(points) - 4))) if len(points) > 4 else 0.0,
        np.linalg.inv(J.T @ J),
    )


def sphere_centre(points_mm: Floats, diameter_mm: float) -> Floats:
    """Centre (3,) of the sphere of known diameter that fits best; quieter than with a free one.

    Args:
        points_mm: (N, 3), N >= 3, not on one line.
    """
    centre = (
        least_squares_sphere(points_mm).centre_mm
        if len(points_mm) > 3
        else (points_mm.mean(axis=0))
    )
    for _ in range(STEPS):
        away = points_mm - centre
        distance = np.linalg.norm(away, axis=1)
        change = np.linalg.lstsq(away / distance[:, None], distance - diameter_mm / 2, rcond=None)[
            0
        ]
        centre = centre + change
        if np.max(np.abs(change)) < 1e-12:
            break
    return np.asarray(centre)


def dispersion_mm(distances_mm: Floats) -> float:
    """Width of the narrowest shell about the centre that holds 95 % of all points.

    Args:
        distances_mm: (N,) from the centre of the least-squares sphere of all points.

    Source:
        Probing dispersion D95 of ISO 10360-8, with a shell about that centre.

    Example:
        >>> dispersion_mm(np.array([*np.linspace(0.0, 1.0, 95), 9.0, 9.0, 9.0, 9.0, 9.0]))
        1.0
    """
    held = max(int(np.ceil(HELD * len(distances_mm))), 1)
    left_out = len(distances_mm) - held
    # the shell ends at one of the few largest and begins at one of the few smallest distances
    parted = np.partition(distances_mm, (left_out, held - 1))
    return float(np.min(np.sort(parted[held - 1 :]) - np.sort(parted[: left_out + 1])))


def free_dispersion_mm(points_mm: Floats, centre_mm: Floats) -> float:
    """The same with a free centre, by Nelder-Mead from the least-squares one.

    If it is much smaller than the centred one, the scan covers the sphere badly.
    """
    found = minimize(
        lambda centre: dispersion_mm(np.linalg.norm(points_mm - centre, axis=1)),
        centre_mm,
        method="Nelder-Mead",
        options={"xatol": 1e-5, "fatol": 1e-6, "initial_simplex": _simplex(centre_mm)},
    )
    return float(min(found.fun, dispersion_mm(np.linalg.norm(points_mm - centre_mm, axis=1))))


def _simplex(centre_mm: Floats) -> Floats:
    return np.vstack([centre_mm, centre_mm + 0.02 * np.eye(3)])


def _algebraic_sphere(points: Floats) -> tuple[Floats, float]:
    system = np.column_stack([2 * points, np.ones(len(points))])
    start, _, rank, _ = np.linalg.lstsq(system, np.sum(points**2, axis=1), rcond=None)
    if rank < 4:
        raise _no_sphere_error()
    centre = start[:3]
    return centre, float(np.sqrt(max(start[3] + centre @ centre, 1e-12)))


def _no_sphere_error() -> OperationError:
    return OperationError(
        "points-fix-no-sphere",
        message("points-lie-too-small-piece-sphere"),
        message("centre-radius-cannot-be-separated"),
        message("scan-more-sphere"),
    )
