"""The meaning of the cloud's colours: quantity, limits and scale."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.points import Points
from crenel.messages.message import Text, message
from crenel.metrology.colormaps import APART, BALANCE, SCALE, Bytes, map_colours, scale_stops
from crenel.metrology.transforms import Floats

Measure = Literal["height", "intensity", "uncertainty", "age", "deviation"]
Distances = Callable[[Floats], Floats]
"""Signed distances (N,) in mm of points (N, 3) from a fitted shape."""
Points32 = NDArray[np.float32]
"""(N, 3) mm, relative to the origin of the cloud."""
PointAttributes = NDArray[np.void]
"""(N,) of ``ATTRIBUTES``."""

ATTRIBUTES = np.dtype(
    [
        ("intensity", "<f4"),
        ("uncertainty_um", "<f4"),
        ("taken_s", "<f4"),
        ("spacing_mm", "<f2"),
        ("brightness", "u1"),
        ("view", "i1", 3),
        ("weak", "u1"),
        ("cut", "?"),
    ]
)
"""Data stored with the position of each shown point: the time since its scan began, how it looks
among its neighbours (see ``surface_look``), the direction to the camera in parts of 127 (zero:
unknown), a sum of ``WEAK``, and whether it is cut away."""


Weakness = Literal["fast", "steep", "few"]
WEAK: dict[Weakness, tuple[int, tuple[int, int, int]]] = {
    "few": (4, (124, 124, 132)),
    "steep": (2, (244, 96, 20)),
    "fast": (1, (222, 30, 130)),
}
"""Why a point is weak, the gravest last: its bit, and its colour. The sensor passed too fast, the
surface was seen too steeply, or has points in few lines only."""


@dataclass(frozen=True, eq=False)
class Circumstances:
    """How points (N,) were captured."""

    taken_s: Floats
    """(N,) since the scan began."""
    views: Floats | None = None
    """(N, 3) unit directions from the points to the camera; None if they are not known."""
    too_fast: bool | NDArray[np.bool_] = False
    """Whether the sensor passed too fast, of all or of each."""

    def __getitem__(self, which: slice | NDArray[np.int64]) -> "Circumstances":
        fast = self.too_fast if isinstance(self.too_fast, bool) else self.too_fast[which]
        views = None if self.views is None else self.views[which]
        return Circumstances(self.taken_s[which], views, fast)


def join_circumstances(parts: Sequence[Circumstances]) -> Circumstances:
    """Joins the points of all parts, one after the other; without directions if a part has none."""
    views = [part.views for part in parts if part.views is not None]
    return Circumstances(
        np.concatenate([part.taken_s for part in parts]),
        np.concatenate(views) if len(views) == len(parts) else None,
        np.concatenate([np.broadcast_to(part.too_fast, len(part.taken_s)) for part in parts]),
    )


def point_attributes(points: Points, taken: Circumstances) -> PointAttributes:
    """For points (N,), whose neighbours are not known yet."""
    traits = np.zeros(len(points), ATTRIBUTES)
    if taken.views is not None:
        traits["view"] = np.rint(127 * taken.views)
    traits["weak"] = np.where(taken.too_fast, WEAK["fast"][0], 0)
    traits["brightness"] = 255
    traits["intensity"] = points["intensity"]
    traits["uncertainty_um"] = points["uncertainty_um"]
    traits["taken_s"] = taken.taken_s
    return traits


@dataclass(frozen=True)
class _MeasureScale:
    unit: Text
    scale: Bytes
    percentiles: tuple[float, float]
    """Share that the automatic range excludes at either end."""
    least_span: float


MEASURE_SCALES: dict[Measure, _MeasureScale] = {
    "height": _MeasureScale("mm", SCALE, (0.2, 99.8), 1.0),
    "intensity": _MeasureScale(message("grey-levels"), SCALE, (2.0, 98.0), 10.0),
    "uncertainty": _MeasureScale("µm", SCALE, (1.0, 98.0), 2.0),
    "age": _MeasureScale("s", SCALE[::-1], (0.0, 100.0), 5.0),
    "deviation": _MeasureScale("µm", BALANCE, (0.0, 100.0), 4.0),
}
# An automatic range changes when it is off by this share of itself.
OFF_SHARE = 0.08
# The age advances in steps of this share of its range.
AGE_STEP = 0.05
# Points further from a shape than this multiple of the range do not belong to it.
APART_RANGES = 4.0
FIT_SIGMAS = 3.0


@dataclass(frozen=True)
class Legend:
    """The legend next to the view."""

    measure: Measure
    unit: Text
    low: float
    high: float
    automatic: bool
    colours: tuple[str, ...]
    """Colours of the scale, evenly spaced from low to high."""


@dataclass(frozen=True)
class ReferenceShape:
    """The shape for deviations."""

    distances: Distances
    rms_mm: float


class CloudColouring:
    """Not thread-safe: its owner holds a lock.

    ``version`` increases whenever points need new colours.
    """

    def __init__(self) -> None:
        self.version = 0
        self.measure: Measure = "height"
        self.reference: ReferenceShape | None = None
        self.weak_shown = True
        """Weak points have the colours of ``WEAK``."""
        self._low, self._high = 0.0, 1.0
        self._ranged = False
        self._is_manual = False

    @property
    def legend(self) -> Legend | None:
        """None before there is anything to colour."""
        if not self._ranged:
            return None
        kind = MEASURE_SCALES[self.measure]
        return Legend(
            self.measure,
            kind.unit,
            self._low,
            self._high,
            not self._is_manual,
            scale_stops(kind.scale),
        )

    def show(self, measure: Measure, limits: tuple[float, float] | None) -> None:
        """Selects the quantity, with limits in its unit, or automatic ones."""
        self.measure = measure
        self._is_manual = limits is not None
        self._ranged = limits is not None
        if limits is not None:
            self._low, self._high = limits
        self.version += 1

    def mark_weak(self, on: bool) -> None:
        """Shows weak points in colours of their own, or like the others."""
        self.version += on != self.weak_shown
        self.weak_shown = on

    def forget_range(self) -> None:
        """If nothing is shown any more, the next data sets an automatic range again."""
        self._ranged = self._is_manual

    def aim_at(self, target: ReferenceShape | None) -> None:
        """The shape for deviations; without one, heights are shown instead."""
        self.reference = target
        if self.measure != "deviation":
            return
        if target is None:
            self.show("height", None)
        else:
            self.show("deviation", (self._low, self._high) if self._is_manual else None)

    def values(
        self, points: Floats, traits: PointAttributes, newest_s: float
    ) -> NDArray[np.floating]:
        """The values (N,) for colouring points (N, 3) of the arm frame."""
        if self.measure == "height":
            return np.asarray(points[:, 2])
        if self.measure == "deviation":
            assert self.reference is not None
            return 1e3 * self.reference.distances(points)
        if self.measure == "age":
            return np.asarray(newest_s - traits["taken_s"])
        name = "intensity" if self.measure == "intensity" else "uncertainty_um"
        return np.asarray(traits[name])

    def age_step(self, newest_s: float) -> int:
        """Increases as the colours of ages become outdated."""
        if self.measure != "age":
            return 0
        return int(newest_s / (AGE_STEP * max(self._high - self._low, 1e-6)))

    def beyond_age(self, newest_s: float, node_newest_s: float) -> bool:
        """Whether all points of a node are older than the range, so that its colours stay."""
        return self.measure == "age" and newest_s - node_newest_s > self._high

    def colours(self, points: Floats, traits: PointAttributes, newest_s: float) -> Bytes:
        """Colours (N, 3) of points (N, 3) of the arm frame."""
        if self.measure == "age":  # at the end of the step: nothing is younger than new
            step_s = AGE_STEP * max(self._high - self._low, 1e-6)
            newest_s = step_s * self.age_step(newest_s)
        values = self.values(points, traits, newest_s)
        found = map_colours(values, self._low, self._high, MEASURE_SCALES[self.measure].scale)
        if self.measure == "deviation":
            middle, half = (self._low + self._high) / 2, (self._high - self._low) / 2
            found[np.abs(values - middle) > APART_RANGES * half] = APART
        if self.weak_shown and traits["weak"].any():
            for bit, colour in WEAK.values():
                found[traits["weak"] & bit > 0] = colour
        return np.asarray(found * (traits["brightness"][:, None] / np.float32(255)), np.uint8)

    def settle_range(self, sample: NDArray[np.floating]) -> None:
        """Adjusts an automatic range to the values (N,) of everything shown."""
        if self._is_manual:
            return
        wanted = self._range_of(sample[np.isfinite(sample)])
        if wanted is None:
            return
        low, high = wanted
        off = max(abs(low - self._low), abs(high - self._high))
        if not self._ranged or off > OFF_SHARE * (high - low):
            self._ranged = True
            self._low, self._high = low, high
            self.version += 1

    def _range_of(self, sample: NDArray[np.floating]) -> tuple[float, float] | None:
        kind = MEASURE_SCALES[self.measure]
        if self.measure == "deviation":
            if self.reference is None:
                return None
            half = max(1e3 * FIT_SIGMAS * self.reference.rms_mm, kind.least_span / 2)
            return -half, half
        if not len(sample):
            return None
        low, high = (float(x) for x in np.percentile(sample, kind.percentiles))
        if self.measure == "age":
            return 0.0, max(high, kind.least_span)
        short = max(kind.least_span - (high - low), 0.0)
        low, high = low - short / 2, high + short / 2
        if self.measure != "height" and low < 0.0:
            low, high = 0.0, high - low
        return low, high
