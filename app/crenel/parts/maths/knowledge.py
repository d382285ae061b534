"""What is known of all features together: one covariance, by the source of each error.

Errors of sensor, arm and tip are shared by all features, those of a frame by all features that the
frame crosses. The parameters of all features stand in one vector, in their order.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_matrix

from crenel.metrology.transforms import Floats
from crenel.parts.maths.feature_fit import FittedFeature
from crenel.parts.maths.point_errors import SHARED_SOURCES
from crenel.parts.maths.shapes import Shape

SOURCES = (*SHARED_SOURCES, "encoders", "stripe", "touches", "form")
STEP_MM, STEP_RAD = 1e-4, 1e-7


@dataclass(frozen=True)
class MeasuredFeature:
    """A fitted feature, and the recording or table that it is from, by number.

    ``touched`` tells touches from scans.
    """

    fitted: FittedFeature
    source: int
    touched: bool


@dataclass(frozen=True)
class Knowledge:
    """The covariance (M, M) of the parameters of all features, split by source."""

    shapes: tuple[Shape, ...]
    parts: dict[str, Floats]

    @property
    def total(self) -> Floats:
        return np.asarray(np.sum(list(self.parts.values()), axis=0))

    def block(self, number: int) -> Floats:
        """(m, m) covariance of one feature's parameters."""
        ends = np.cumsum([0, *(shape.freedom.count for shape in self.shapes)])
        own = slice(ends[number], ends[number + 1])
        return np.asarray(self.total[own, own])

    def gradients(self, values: Callable[[Sequence[Shape]], Floats]) -> Floats:
        """Derivatives (K, M) of K values by the parameters of all features."""
        rows = []
        for number, shape in enumerate(self.shapes):
            for k, is_angle in enumerate(shape.freedom.are_angles):
                step = np.zeros(shape.freedom.count)
                step[k] = STEP_RAD if is_angle else STEP_MM
                ahead, behind = (
                    values(
                        [
                            shape.apply_step(way * step) if other == number else one
                            for other, one in enumerate(self.shapes)
                        ]
                    )
                    for way in (1, -1)
                )
                rows.append((ahead - behind) / (2 * step[k]))
        return np.array(rows).T

    def with_quantity(self, source: str, standard_uncertainty: float) -> "Knowledge":
        """With one more quantity behind all parameters, independent of them."""
        parts = {name: np.pad(part, (0, 1)) for name, part in self.parts.items()}
        parts[source] = np.zeros_like(next(iter(parts.values())))
        parts[source][-1, -1] = standard_uncertainty**2
        return Knowledge(self.shapes, parts)

    def contributions(self, gradient: Floats) -> dict[str, float]:
        """Standard uncertainties of a value by source, whose squares add up to its own.

        Where errors of two sources cancel, what remains counts for the larger one.
        """
        squares = {name: float(gradient @ part @ gradient) for name, part in self.parts.items()}
        total = sum(squares.values())
        positive = {name: max(square, 0.0) for name, square in squares.items()}
        scale = total / sum(positive.values()) if total > 0 else 0.0
        return {name: float(np.sqrt(square * scale)) for name, square in positive.items()}


def join_features(features: Sequence[MeasuredFeature], shared: Floats) -> Knowledge:
    """The covariance of all features, from that of the shared errors (P, P)."""
    A = np.concatenate([one.fitted.sums.shared for one in features])
    M = len(A)
    by_shared = A @ shared
    parts = {name: _part(A, by_shared, some) for name, some in SHARED_SOURCES.items()}
    parts["encoders"] = _by_readings(features, M)
    for name in ("stripe", "touches", "form"):
        parts[name] = np.zeros((M, M))
    at = 0
    for one in features:
        own = slice(at, at + len(one.fitted.own))
        parts["touches" if one.touched else "stripe"][own, own] = one.fitted.own
        runs = one.fitted.runs
        parts["form"][own, own] = one.fitted.form if runs is None else runs.excess(shared)
        at = own.stop
    return Knowledge(tuple(one.fitted.shape for one in features), parts)


def _part(A: Floats, by_shared: Floats, some: slice) -> Floats:
    """What some of the shared errors have of the covariance; all parts add up to the whole."""
    part = by_shared[:, some] @ A[:, some].T
    return np.asarray((part + part.T) / 2)


def _by_readings(features: Sequence[MeasuredFeature], M: int) -> Floats:
    """(M, M) by the noise of the readings, each common to a frame of a recording."""
    rows, columns, numbers = [], [], []
    at = 0
    start: dict[int, int] = {}
    for one in features:
        frames = int(one.fitted.sums.frames.max(initial=-1)) + 1
        start[one.source] = max(start.get(one.source, 0), frames)
    total = 0
    first: dict[int, int] = {}
    for source, frames in start.items():
        first[source], total = total, total + frames
    joints = features[0].fitted.sums.by_readings.shape[2]
    for one in features:
        by = one.fitted.sums.by_readings
        own = np.arange(at, at + by.shape[1])
        at += by.shape[1]
        frame = first[one.source] + one.fitted.sums.frames
        column = joints * frame[:, None, None] + np.arange(joints)
        row = np.broadcast_to(own[None, :, None], by.shape)
        rows.append(row.ravel())
        columns.append(np.broadcast_to(column, by.shape).ravel())
        numbers.append(by.ravel())
    B = csr_matrix(
        (np.concatenate(numbers), (np.concatenate(rows), np.concatenate(columns))),
        (M, max(total * joints, 1)),
    )
    return np.asarray((B @ B.T).toarray())
