"""Form of a scanned plane, over all points without a filter."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.fitting.reference_sphere import dispersion_mm
from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class PlaneOfPoints:
    """The least-squares plane of all points, and what they are off it."""

    centre_mm: Floats  # (3,)
    normal: Floats  # (3,) unit length, arbitrary sign
    form_mm: float
    """Largest minus smallest distance."""
    dispersion_mm: float
    """Width of the narrowest slab parallel to it that holds 95 % of all points."""


def least_squares_plane(points_mm: Floats) -> PlaneOfPoints:
    """The plane of least squares of the distances, of all points, unweighted.

    Args:
        points_mm: (N, 3), N >= 3, not on a line.

    Raises:
        OperationError: ``points-on-a-line``.

    Source:
        ISO 10360-8: E_Form.Pla.D95%, here for a scanner on an arm.
    """
    centre = points_mm.mean(axis=0)
    _, singular, axes = np.linalg.svd(points_mm - centre, full_matrices=False)
    if len(points_mm) < 3 or singular[1] <= 1e-6 * singular[0]:
        raise OperationError(
            "points-on-a-line", message("points-lie-one-line"), message("they-fix-no-plane")
        )
    off = (points_mm - centre) @ axes[2]
    return PlaneOfPoints(centre, axes[2], float(np.ptp(off)), dispersion_mm(off))
