"""A laser line in real pictures: what Crenel finds of it beside three peers, and how quietly.

There is no truth. What three methods agree on stands for it: the **agreed** columns are those
in which all three peers have a point, no further apart than 3 px (a fifth of the line's width
where that is more), in runs of at least 20 columns and three widths, so that round spots are none.

- **missed**: Crenel has no point in an agreed column.
- **false**: a method's point further than 3 px (or a fifth of the width) from the points of all
  the other three methods, where at least one of them has a point in the column. If these do not
  agree on a line there, points of a run of which half is confirmed elsewhere are not false: a
  bright spot beside the line misleads the others.
- **noise**: what a quadratic through 21 columns leaves of the middle one (divided by the share of
  its own noise that the fit leaves it), over the columns in which all four methods agree;
  1.4826 times the median of its absolute values.
- **scatter / σ**, of at least five repeated frames of one scene: the deviation of a column's
  points from their mean over the frames, divided by the stated σ, as 1.4826 times the median of
  its absolute values. The mean shift of a whole frame does not count, nor do columns with points
  in fewer than four of five frames.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from app.bench.real.agreement import APART_PX, agree, apart_px, find_agreed, find_false
from app.bench.real.peers import PEERS, find_by_peers, measure_width_px
from app.metrology.image import Image
from app.metrology.stripe import Stripe, extract_stripe
from app.metrology.stripe.extraction import orient_image
from app.metrology.transforms import Floats

CRENEL = "crenel"
METHODS = (CRENEL, *PEERS)
WINDOW, LEAST_OF_WINDOW = 21, 15
SIGMA_OF_MEDIAN = 1.4826
LEAST_FRAMES = 5
OFTEN = 0.8
"""Share of the frames in which a column must have a point, to tell its scatter."""
MOST_MEASURED = 8
"""Pictures of a set in which its width and axis are measured."""


@dataclass
class LineSet:
    """What was found in a set of pictures with a line, summed over them."""

    name: str
    axis: str
    width_px: float | None
    """Of the line at half its height, by its own profile; None where the peers see no line."""
    pictures: int = 0
    with_line: int = 0
    """Pictures in which Crenel has a point in at least half of the agreed columns."""
    points: int = 0
    agreed: int = 0
    missed: int = 0
    false: dict[str, int] = field(default_factory=dict)
    """By method; empty where several lines may be taken."""
    noise_px: dict[str, float] = field(default_factory=dict)
    sigma_px: float | None = None
    """Median of what Crenel states of the columns in which all agree."""
    scatter_ratio: float | None = None


@dataclass
class NoLineSet:
    """What was found in a set of pictures without a laser line."""

    name: str
    pictures: int = 0
    columns: int = 0
    points: int = 0

    @property
    def share(self) -> float:
        return self.points / self.columns if self.columns else 0.0


@dataclass(frozen=True)
class _Columns:
    """Row and stated σ of Crenel's point in every column (W,), NaN where there is none."""

    rows: Floats
    sigma_px: Floats


def measure_lines(
    name: str,
    pictures: Callable[[], Iterable[Image]],
    axis: str | None = None,
    width_px: float | None = None,
    several: bool = False,
    repeated: bool = False,
) -> LineSet:
    """Measures a set of pictures with a line.

    Args:
        pictures: a function, because they are looked at twice: for the axis and the width.
        axis: of the stripe; None: the one along which the peers agree more often.
        width_px: of the line at half height; None: measured.
        several: more than one line may be taken: no point is false.
        repeated: the pictures are frames of one scene that does not move.
    """
    some = _some(pictures())
    if axis is None:
        axis = max(("u", "v"), key=lambda one: _number_agreed(some, one, width_px))
    if width_px is None:
        width_px = measure_width_px(orient_image(picture, axis) for picture in some)
    result = LineSet(name, axis, width_px, false={} if several else dict.fromkeys(METHODS, 0))
    left: dict[str, list[Floats]] = {method: [] for method in METHODS}
    stated: list[Floats] = []
    frames = []
    for picture in pictures():
        result.pictures += 1
        own = _columns(extract_stripe(picture, axis), _width(picture, axis))
        result.points += int(np.isfinite(own.rows).sum())
        frames.append(own)
        if width_px is None:
            continue
        rows = {CRENEL: own.rows, **find_by_peers(orient_image(picture, axis), width_px)}
        common = _count(result, rows, width_px)
        stated.append(own.sigma_px[common])
        for method in METHODS:
            left[method].append(noise_of_columns(np.where(common, rows[method], np.nan)))
    result.noise_px = {
        method: deviation
        for method, parts in left.items()
        if (deviation := robust_deviation(parts)) is not None
    }
    if any(len(part) for part in stated):
        result.sigma_px = float(np.median(np.concatenate(stated)))
    if repeated and len(frames) >= LEAST_FRAMES:
        result.scatter_ratio = _scatter_ratio(frames)
    return result


def measure_no_line(name: str, pictures: Iterable[Image], axis: str | None = None) -> NoLineSet:
    """Counts the points in pictures without a line, along both axes where none is given."""
    result = NoLineSet(name)
    for picture in pictures:
        result.pictures += 1
        for one in ("u", "v") if axis is None else (axis,):
            result.columns += _width(picture, one)
            result.points += len(extract_stripe(picture, one).u)
    return result


def noise_of_columns(rows: Floats) -> Floats:
    """What quadratics through windows of 21 columns leave of their middle points.

    Args:
        rows: (W,), NaN where there is no point. A window needs its middle and 15 points.
    """
    windows = np.lib.stride_tricks.sliding_window_view(rows, WINDOW)
    there = np.isfinite(windows)
    kept = there[:, WINDOW // 2] & (there.sum(axis=1) >= LEAST_OF_WINDOW)
    windows, weights = windows[kept], there[kept].astype(np.float64)
    basis = np.vander(np.linspace(-1, 1, WINDOW), 3)
    middle = windows[:, WINDOW // 2]
    values = np.where(weights > 0, windows - middle[:, None], 0.0)  # small numbers lose no digits
    inverse = np.linalg.inv(np.einsum("nk,ki,kj->nij", weights, basis, basis))
    moments = (weights * values) @ basis
    at = basis[WINDOW // 2]
    fitted = np.einsum("i,nij,nj->n", at, inverse, moments)
    leverage = np.einsum("i,nij,j->n", at, inverse, at)
    return np.asarray(-fitted / np.sqrt(1 - leverage))


def robust_deviation(parts: Sequence[Floats]) -> float | None:
    """The standard deviation of all values by the median of their sizes; None without any."""
    values = np.concatenate([*parts, np.zeros(0)])
    return SIGMA_OF_MEDIAN * float(np.median(np.abs(values))) if len(values) else None


def _some(pictures: Iterable[Image]) -> list[Image]:
    """At most eight pictures, evenly spread."""
    held = list(pictures)
    return held[:: -(-len(held) // MOST_MEASURED)]


def _number_agreed(pictures: Sequence[Image], axis: str, width_px: float | None) -> int:
    turned = [orient_image(picture, axis) for picture in pictures]
    width_px = measure_width_px(turned) if width_px is None else width_px
    if width_px is None:
        return 0
    peers = (find_by_peers(one, width_px) for one in turned)
    return sum(int(find_agreed(list(rows.values()), width_px).sum()) for rows in peers)


def _count(result: LineSet, rows: dict[str, Floats], width_px: float) -> NDArray[np.bool_]:
    """Adds a picture's columns to a set's counts; the columns in which all four agree."""
    agreed = find_agreed([rows[peer] for peer in PEERS], width_px)
    missed = int((agreed & np.isnan(rows[CRENEL])).sum())
    result.agreed += int(agreed.sum())
    result.missed += missed
    result.with_line += bool(agreed.any() and missed <= agreed.sum() / 2)
    for method in result.false:
        result.false[method] += int(find_false(rows, method, width_px).sum())
    return agree([rows[method] for method in METHODS], apart_px(width_px))


def _scatter_ratio(frames: Sequence[_Columns]) -> float | None:
    """Observed over stated scatter of the columns that have a point in most frames."""
    rows = np.stack([frame.rows for frame in frames])
    sigma = np.stack([frame.sigma_px for frame in frames])
    often = np.isfinite(rows).mean(axis=0) >= OFTEN
    rows, sigma = rows[:, often], sigma[:, often]
    off = rows - np.nanmean(rows, axis=0)
    off[np.abs(off) > APART_PX] = np.nan  # another line, which is not noise
    shift = [np.nanmedian(one) if np.isfinite(one).any() else 0.0 for one in off]
    freedom = np.sqrt(len(frames) / (len(frames) - 1))
    ratio = freedom * (off - np.array(shift)[:, None]) / sigma
    return robust_deviation([ratio[np.isfinite(ratio)]])


def _columns(stripe: Stripe, width: int) -> _Columns:
    along, across = stripe.along_across
    rows, sigma = np.full(width, np.nan), np.full(width, np.nan)
    at = np.rint(along).astype(np.int64)
    rows[at], sigma[at] = across, stripe.sigma_px
    return _Columns(rows, sigma)


def _width(picture: Image, axis: str) -> int:
    return int(picture.shape[1] if axis == "u" else picture.shape[0])
