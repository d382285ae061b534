"""Whether features that were measured twice lie where they did, for all that errs in common."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import gammaincc

from crenel.metrology.transforms import Floats
from crenel.parts.maths.knowledge import MeasuredFeature, join_features
from crenel.parts.maths.shapes import Shape

SAMPLES = 60
LEAST_SHARE = 1e-9
"""Of the largest variance: a smaller one is of a direction in which nothing was compared."""


@dataclass(frozen=True)
class Overlap:
    """How two groups of points differ in the features that both have.

    ``chance`` is that of a chi-square as large or larger if nothing moved between them;
    ``largest_mm`` how far a feature is off at most, and ``u_mm`` what is known of that, k = 1.
    """

    chance: float
    largest_mm: float
    u_mm: float
    feature: int


def compare_features(
    pairs: Sequence[tuple[MeasuredFeature, MeasuredFeature]],
    points_mm: Sequence[Floats],
    shared: Floats,
) -> Overlap:
    """Features that two groups of points both determine, taken together.

    Args:
        pairs: the same feature by the first and by the second group.
        points_mm: (N, 3) of each pair, arm frame, where its surfaces are compared.
        shared: (P, P) covariance of the shared errors, most of which cancel.
    """
    knowledge = join_features([one for pair in pairs for one in pair], shared)
    places = [points[:: max(len(points) // SAMPLES, 1)] for points in points_mm]
    bases = [
        np.linalg.svd(first.fitted.shape.linearise(at)[2], full_matrices=False)[0]
        for (first, _), at in zip(pairs, places, strict=True)
    ]

    def off_at_places(shapes: Sequence[Shape]) -> list[Floats]:
        return [
            shapes[2 * k + 1].distances(at) - shapes[2 * k].distances(at)
            for k, at in enumerate(places)
        ]

    def differences(shapes: Sequence[Shape]) -> Floats:
        each = zip(bases, off_at_places(shapes), strict=True)
        return np.concatenate([basis.T @ off for basis, off in each])

    off = differences(knowledge.shapes)
    G = knowledge.gradients(differences)
    C = np.asarray(G @ knowledge.total @ G.T)
    values, axes = np.linalg.eigh((C + C.T) / 2)
    good = values > LEAST_SHARE * values.max()
    chi_square = float(np.sum((axes[:, good].T @ off) ** 2 / values[good]))
    ends = np.cumsum([0, *(basis.shape[1] for basis in bases)])
    found = []
    for k, (basis, each) in enumerate(zip(bases, off_at_places(knowledge.shapes), strict=True)):
        own = C[ends[k] : ends[k + 1], ends[k] : ends[k + 1]]
        worst = int(np.argmax(np.abs(each)))
        u = float(np.sqrt(max(basis[worst] @ own @ basis[worst], 0.0)))
        found.append((abs(float(each[worst])), u, k))
    largest, u, feature = max(found, key=lambda one: one[0] / max(one[1], 1e-9))
    return Overlap(float(gammaincc(good.sum() / 2, chi_square / 2)), largest, u, feature)
