"""Lines that are hard to find in grey pictures: rendered scenes of four kinds, beside three peers.

    python -m tests.bench hard-lines [--half unseen] [--count 12] [--json]

- **turntable**: a short line on a small object, and what else a dark room shows of the laser.
- **halo**: a clipped core in an uneven halo of a hundred pixels.
- **tunnel**: a long bright line that goes on dim, broken and speckled.
- **board**: a line over black and white squares, as JPEG.

A column counts as shown if the line exceeds its surroundings there by three standard deviations of
the noise. It is found with a point within a quarter of the line's width (2 px, if that is more). A
point further off than half of the width (3 px), or where nothing is shown, is false. Scenes of odd
numbers, the unseen half, were not looked at while the search was made.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe import find_stripe
from crenel.metrology.transforms import Floats
from tests.bench.real.peers import find_by_peers
from tests.bench.rows import bench_parser, measured_rows

CRENEL = "crenel"
SHOWN_SDS, NEAR_WIDTHS, NEAR_PX, FAR_WIDTHS, FAR_PX = 3.0, 0.25, 2.0, 0.5, 3.0


@dataclass(frozen=True)
class HardLine:
    """A rendered picture. ``rows``, ``shown``: (W,) the line's row, and whether it can be seen;
    ``behind``: where the same laser meets what is behind the object, NaN where it does not."""

    picture: Image
    rows: Floats
    shown: NDArray[np.bool_]
    width_px: float
    behind: Floats | None = None


@dataclass
class Count:
    """What a method found, summed over pictures."""

    shown: int = 0
    found: int = 0
    false: int = 0


@dataclass
class Result:
    """Of a kind of scene, by method."""

    pictures: int = 0
    refused: int = 0
    """Pictures in which Crenel finds no line."""
    counts: dict[str, Count] = field(default_factory=dict)


def main() -> None:
    parser = bench_parser(__doc__ or "")
    parser.add_argument("--half", choices=("seen", "unseen"), default="unseen")
    parser.add_argument("--count", type=int, default=12, help="scenes of each kind")
    given = parser.parse_args()
    first = 1 if given.half == "unseen" else 0
    with measured_rows(given.json) as rows:
        for kind, render in KINDS.items():
            lines = (render(np.random.default_rng([7, 2 * n + first])) for n in range(given.count))
            result = measure(lines)
            for name, count in result.counts.items():
                refused = result.refused if name == CRENEL else 0
                missed = 1 - count.found / count.shown
                false = count.false / count.shown
                values = {"refused": refused, "missed %": 100 * missed, "false %": 100 * false}
                rows.add(f"{kind}, {name}", values)


def measure(lines: Iterator[HardLine]) -> Result:
    """What is found of lines, by Crenel and by peers who know the width."""
    result = Result()
    for line in lines:
        stripe = find_stripe(line.picture).stripe
        own = np.full(line.picture.shape[1], np.nan)
        own[np.rint(stripe.u).astype(int)] = stripe.v
        result.pictures += 1
        result.refused += not len(stripe.u)
        for name, rows in {CRENEL: own, **find_by_peers(line.picture, line.width_px)}.items():
            count = result.counts.setdefault(name, Count())
            off_px = np.abs(rows - line.rows)
            count.shown += int(line.shown.sum())
            near_px = max(NEAR_WIDTHS * line.width_px, NEAR_PX)
            far_px = max(FAR_WIDTHS * line.width_px, FAR_PX)
            count.found += int((line.shown & (off_px <= near_px)).sum())
            true = line.shown & (off_px <= far_px)
            if line.behind is not None:
                true |= np.abs(rows - line.behind) <= far_px
            count.false += int((np.isfinite(rows) & ~true).sum())
    return result


def _bell(rows: NDArray[np.floating], height: int, sigma_px: float) -> Floats:
    v = np.arange(height)[:, None]
    return np.asarray(np.exp(-0.5 * ((v - rows) / sigma_px) ** 2))


def _speckle(shape: tuple[int, ...], contrast: float, rng: np.random.Generator) -> Floats:
    grains = rng.normal(0, 1, shape)
    return np.asarray(np.exp(contrast * cv2.GaussianBlur(grains, (0, 0), 1.2) * 4))


def _take(
    light: Floats, noise: float, rng: np.random.Generator, quality: int | None = None
) -> Image:
    """The picture of light in grey levels: shot and read noise, clipped, JPEG where asked for."""
    seen = light + rng.normal(0, 1, light.shape) * np.sqrt(noise**2 + 0.05 * np.maximum(light, 0))
    grey = np.clip(np.rint(seen), 0, 255).astype(np.uint8)
    if quality is None:
        return grey
    encoded = cv2.imencode(".jpg", grey, [cv2.IMWRITE_JPEG_QUALITY, quality])[1]
    return np.asarray(cv2.imdecode(encoded, cv2.IMREAD_GRAYSCALE), np.uint8)


def _smooth(width: int, amount: float, scale: float, rng: np.random.Generator) -> Floats:
    """(W,) a smooth random course."""
    course = cv2.GaussianBlur(rng.normal(0, 1, (1, width)), (0, 0), scale)[0]
    return np.asarray(amount * course / max(float(course.std()), 1e-9))


def turntable(rng: np.random.Generator) -> HardLine:
    """A line on a small object and one on the wall behind it; things that catch light."""
    height, width = 480, 640
    u = np.arange(width)
    begin, length = int(rng.integers(180, 300)), int(rng.integers(90, 220))
    on_object = (u >= begin) & (u < begin + length)
    rows: Floats = 200 + rng.uniform(-40, 60) + _smooth(width, 12, 40, rng) + 0.1 * (u - width / 2)
    sigma = rng.uniform(1.2, 2.4)
    peak = rng.uniform(120, 300) * np.exp(_smooth(width, 0.3, 15, rng))
    light = np.full((height, width), rng.uniform(2, 8))
    light += np.where(on_object, peak, 0) * _bell(rows, height, sigma)
    wall = 60.0 + rng.uniform(-20, 40) + rng.uniform(-0.1, 0.1) * (u - width / 2)
    lit = _smooth(width, 1, 60, rng) > rng.uniform(-1.5, 0.5)
    light += np.where(lit, rng.uniform(0.1, 0.9), 0) * peak.max() * _bell(wall, height, sigma * 1.3)
    for _ in range(int(rng.integers(6, 16))):  # a bag, a helmet, a rug
        at = rng.uniform((0, 0), (width, height))
        size = rng.uniform(2, 26, 2)
        blob = np.zeros((height, width), np.float32)
        ends = (int(at[0]), int(at[1])), (int(size[0]), int(size[1]))
        cv2.ellipse(blob, *ends, float(rng.uniform(0, 180)), 0, 360, 1.0, int(rng.integers(1, 4)))
        light += rng.uniform(15, 110) * cv2.GaussianBlur(blob, (0, 0), 1.0)
    light *= 1 + 0.1 * (_speckle(light.shape, 0.5, rng) - 1)
    shown = on_object & (peak > SHOWN_SDS * 2)
    behind = np.where(lit, wall, np.nan)
    return HardLine(_take(light, 1.5, rng), rows, shown, 2.355 * sigma, behind)


def halo(rng: np.random.Generator) -> HardLine:
    """A core that clips over 6 to 20 rows, in a halo that is wider on one side, and uneven."""
    height, width = 600, 800
    u = np.arange(width)
    rows = 300 + rng.uniform(-60, 60) + _smooth(width, 10, 60, rng) + rng.uniform(-0.1, 0.1) * u
    for at in rng.integers(0, width, int(rng.integers(0, 3))):
        rows[at:] += rng.uniform(-30, 30)
    sigma = rng.uniform(3, 6)
    light = np.full((height, width), rng.uniform(3, 12)) + rng.uniform(400, 1500) * _bell(
        rows, height, sigma
    )
    for wide in (rng.uniform(6, 16), rng.uniform(25, 50)):
        beside = rows + rng.uniform(-1.2, 1.2) * wide + _smooth(width, wide / 3, 30, rng)
        strength = rng.uniform(25, 160) * np.exp(_smooth(width, 0.4, 12, rng))
        light += strength * _bell(beside, height, wide)
    light *= 1 + 0.25 * (_speckle(light.shape, 0.4, rng) - 1)
    core_px = 2 * sigma * np.sqrt(2 * np.log(max(light.max() / 255, 1.5)))
    return HardLine(_take(light, 2.0, rng), rows, np.ones(width, np.bool_), float(core_px))


def tunnel(rng: np.random.Generator) -> HardLine:
    """A bright line over half of the width, and beyond it dim, broken, speckled pieces of it."""
    height, width = 800, 1200
    u = np.arange(width)
    rows = 350 + rng.uniform(-80, 80) + _smooth(width, 25, 120, rng) + rng.uniform(-0.1, 0.1) * u
    sigma = rng.uniform(1.5, 3.0)
    bright_end = int(rng.uniform(0.45, 0.7) * width)
    dim = rng.uniform(0.08, 0.3)
    peak = np.where(u < bright_end, 1.0, dim) * rng.uniform(120, 230)
    peak = peak * np.exp(_smooth(width, 0.35, 6, rng))
    broken = (_smooth(width, 1, 12, rng) > rng.uniform(0.4, 1.0)) & (u > bright_end)
    peak[broken] = 0
    if rng.random() < 0.5:
        rows = np.where(u > bright_end, rows + rng.uniform(20, 120), rows)
    light = np.full((height, width), rng.uniform(4, 15)) + peak * _bell(rows, height, sigma)
    light *= _speckle(light.shape, 0.25, rng)
    noise = rng.uniform(1.5, 3.0)
    shown = peak > SHOWN_SDS * np.hypot(noise, 1.0) * 1.5
    picture = _take(light, noise, rng, int(rng.integers(70, 95)))
    return HardLine(picture, rows, shown, 2.355 * sigma)


def board(rng: np.random.Generator) -> HardLine:
    """A line over black and white squares in dim light; black ones give a tenth of it back."""
    height, width = 720, 960
    u = np.arange(width)
    square = int(rng.integers(50, 110))
    turned = cv2.getRotationMatrix2D((width / 2, height / 2), float(rng.uniform(-25, 25)), 1.0)
    i, j = np.meshgrid(np.arange(3 * width) // square, np.arange(3 * height) // square)
    squares = ((i + j) % 2).astype(np.float32)[height : 2 * height, width : 2 * width]
    white = cv2.GaussianBlur(cv2.warpAffine(squares, turned, (width, height)), (0, 0), 0.9)
    albedo = 0.1 + 0.8 * white
    sigma = rng.uniform(1.5, 3.0)
    straight = 360 + rng.uniform(-120, 120) + rng.uniform(-0.15, 0.15) * (u - width / 2)
    rows = np.asarray(straight, np.float64)
    ambient = rng.uniform(3, 40)
    light = albedo * (ambient + rng.uniform(200, 700) * _bell(rows, height, sigma))
    light *= _speckle(light.shape, 0.15, rng)
    picture = _take(light, 2.0, rng, int(rng.integers(75, 95)))
    return HardLine(picture, rows, np.ones(width, np.bool_), 2.355 * sigma)


Render = Callable[[np.random.Generator], HardLine]
KINDS: dict[str, Render] = {"turntable": turntable, "halo": halo, "tunnel": tunnel, "board": board}


if __name__ == "__main__":
    main()
