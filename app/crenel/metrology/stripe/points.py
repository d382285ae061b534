"""The points of a laser stripe."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

STEP = 10
"""Points between two of which the steepness of the line is taken: more than its noise shows."""


@dataclass(frozen=True)
class Stripe:
    """Points of the laser stripe, at most one per column (axis u) or row (axis v).

    ``intensity`` is the height of the stripe above its background in grey levels, ``sigma_px`` the
    standard deviation of the measured coordinate: v for axis u, u for axis v.
    """

    u: Floats  # (N,)
    v: Floats  # (N,)
    intensity: Floats  # (N,)
    sigma_px: Floats  # (N,)
    axis: str = "u"

    @property
    def uv_px(self) -> Floats:
        """(N, 2)"""
        return np.column_stack([self.u, self.v])

    @property
    def along_across(self) -> tuple[Floats, Floats]:
        """(N,) each: the counting coordinate, and the measured one."""
        return (self.u, self.v) if self.axis == "u" else (self.v, self.u)

    @property
    def across(self) -> Floats:
        """(2,) unit pixel direction of ``sigma_px``."""
        return np.array([0.0, 1.0]) if self.axis == "u" else np.array([1.0, 0.0])

    def is_same(self, other: "Stripe | None") -> bool:
        """Whether both have the same points to the last digit, as the same pixels give; not if
        they have none."""
        return other is not None and len(self.u) > 0 and np.array_equal(self.uv_px, other.uv_px)


def usual_steepness(stripe: Stripe) -> float:
    """By how many pixels the line usually moves across from one column or row to the next.

    NaN of a stripe with too few points. Beyond 1, the line runs along the other axis.
    """
    along, across = stripe.along_across
    if len(along) <= STEP:
        return np.nan
    order = np.argsort(along)
    moved, passed = (values[order][STEP:] - values[order][:-STEP] for values in (across, along))
    return median(np.abs(moved / passed))


def stripe_from_points(points: Floats, axis: str) -> Stripe:
    """The stripe of points (4, N): along, across, height, standard deviation."""
    along, across, height, sigma = points
    return Stripe(*((along, across) if axis == "u" else (across, along)), height, sigma, axis)


def empty_stripe(axis: str) -> Stripe:
    """A stripe without points.

    Args:
        axis: ``u`` or ``v``, as in ``extract_stripe``.
    """
    return stripe_from_points(np.zeros((4, 0)), axis)


def concatenate_stripes(parts: Sequence[Stripe]) -> Stripe:
    """The points of several stripes, one after the other.

    Args:
        parts: at least one stripe, all with the same axis.
    """
    return Stripe(
        np.concatenate([part.u for part in parts]),
        np.concatenate([part.v for part in parts]),
        np.concatenate([part.intensity for part in parts]),
        np.concatenate([part.sigma_px for part in parts]),
        parts[0].axis,
    )
