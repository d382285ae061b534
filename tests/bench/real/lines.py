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

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.stripe import AUTOMATIC, Stripe, StripeSettings, extract_stripe
from crenel.metrology.stripe.extraction import orient_image
from crenel.metrology.transforms import Floats
from tests.bench.real.agreement import APART_PX, agree, apart_px, find_agreed, find_false
from tests.bench.real.layout import LazyPicture, PictureSetNotes
from tests.bench.real.peers import PEERS, find_by_peers, measure_width_px

CRENEL = "crenel"
METHODS = (CRENEL, *PEERS)
WINDOW, LEAST_OF_WINDOW = 21, 15
LEAST_FRAMES = 5
NOTHING_KNOWN = PictureSetNotes()
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
    noise_px: dict[str, float | None] = field(default_factory=dict)
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


@dataclass(frozen=True)
class PictureResult:
    """What was found in a picture, turned so that the line crosses its columns."""

    name: str
    axis: str
    turned: Image
    rows: Floats
    """(W,) of Crenel's points, NaN where there is none."""
    peer_rows: Floats
    """(W,) in the middle of the peers' points."""
    missed: NDArray[np.bool_]
    false: NDArray[np.bool_]


Show = Callable[[PictureResult], None]


def show_nothing(result: PictureResult) -> None:
    """For callers that do not look at single pictures."""


def measure_lines(
    name: str,
    pictures: Sequence[LazyPicture],
    about: PictureSetNotes = NOTHING_KNOWN,
    show: Show = show_nothing,
    settings: StripeSettings = AUTOMATIC,
) -> LineSet:
    """Measures a set of pictures with a line.

    Args:
        about: what is known of them: axis and width of the line, whether several may be taken,
            and whether the pictures are frames of one scene.
        show: called with what was found in each picture.
        settings: of Crenel's extraction.
    """
    axis, width_px = about.stripe_axis, about.width_px
    some = [picture.load() for picture in pictures[:: -(-len(pictures) // MOST_MEASURED)]]
    if axis is None:
        axis = "v" if _is_turned(some, width_px) else "u"
    if width_px is None:
        width_px = measure_width_px(orient_image(picture, axis) for picture in some)
    false = {} if about.several else dict.fromkeys(METHODS, 0)
    result = LineSet(name, axis, width_px, len(pictures), false=false)
    noise: dict[str, list[Floats]] = {method: [] for method in METHODS}
    stated: list[Floats] = []
    frames = []
    for picture in pictures:
        turned = orient_image(picture.load(), axis)
        own = _columns(extract_stripe(turned, settings=settings), turned.shape[1])
        result.points += int(np.isfinite(own.rows).sum())
        frames.append(own)
        if width_px is None:
            continue
        rows = {CRENEL: own.rows, **find_by_peers(turned, width_px)}
        show(_count(result, picture.name, turned, rows, width_px))
        common = agree(list(rows.values()), apart_px(width_px))
        stated.append(own.sigma_px[common])
        for method in METHODS:
            noise[method].append(noise_of_columns(np.where(common, rows[method], np.nan)))
    if any(len(part) for part in stated):
        result.noise_px = {method: robust_deviation(parts) for method, parts in noise.items()}
        result.sigma_px = float(np.median(np.concatenate(stated)))
    if about.repeated and len(frames) >= LEAST_FRAMES:
        result.scatter_ratio = _scatter_ratio(frames)
    return result


def measure_no_line(
    name: str,
    pictures: Sequence[LazyPicture],
    about: PictureSetNotes = NOTHING_KNOWN,
    show: Show = show_nothing,
) -> NoLineSet:
    """Counts the points in pictures without a line, along both axes where none is given."""
    result = NoLineSet(name, len(pictures))
    for picture in pictures:
        image = picture.load()
        for axis in ("u", "v") if about.stripe_axis is None else (about.stripe_axis,):
            turned = orient_image(image, axis)
            rows = _columns(extract_stripe(turned), turned.shape[1]).rows
            there = np.isfinite(rows)
            result.columns += len(rows)
            result.points += int(there.sum())
            nothing = np.full(len(rows), np.nan)
            missed = np.zeros(len(rows), np.bool_)
            show(PictureResult(picture.name, axis, turned, rows, nothing, missed, there))
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
    return sigma_from_median(np.abs(values)) if len(values) else None


def _is_turned(pictures: Sequence[Image], width_px: float | None) -> bool:
    """Whether the peers agree more often along the pictures' rows than along their columns."""
    return _number_agreed(pictures, "v", width_px) > _number_agreed(pictures, "u", width_px)


def _number_agreed(pictures: Sequence[Image], axis: str, width_px: float | None) -> int:
    turned = [orient_image(picture, axis) for picture in pictures]
    width_px = measure_width_px(turned) if width_px is None else width_px
    if width_px is None:
        return 0
    peers = (find_by_peers(one, width_px) for one in turned)
    return sum(int(find_agreed(list(rows.values()), width_px).sum()) for rows in peers)


def _count(
    result: LineSet, name: str, turned: Image, rows: dict[str, Floats], width_px: float
) -> PictureResult:
    """Adds a picture's columns to a set's counts."""
    theirs = [rows[peer] for peer in PEERS]
    agreed = find_agreed(theirs, width_px)
    missed = agreed & np.isnan(rows[CRENEL])
    result.agreed += int(agreed.sum())
    result.missed += int(missed.sum())
    result.with_line += bool(agreed.any() and missed.sum() <= agreed.sum() / 2)
    false = {method: find_false(rows, method, width_px) for method in result.false}
    for method, columns in false.items():
        result.false[method] += int(columns.sum())
    none = np.zeros(len(missed), np.bool_)
    middle = np.median(np.stack(theirs), axis=0)
    return PictureResult(
        name, result.axis, turned, rows[CRENEL], middle, missed, false.get(CRENEL, none)
    )


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
