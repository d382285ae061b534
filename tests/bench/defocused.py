"""How wide lines of a defocused sensor are found in real rooms: lines painted on real pictures.

    python -m tests.bench defocused FOLDER [--json]

The folder has pictures of rooms without a laser line, in it or in folders below. Each is darkened
as the room's light would be by a short exposure, a laser line is added to it, by the brightness of
the surface, and the sum is blurred by the lens: by a disc as by an ideal one, or by a Gaussian.
A picture counts as found if at least 30 % of its columns have a point on the line; a point further
off than a quarter of the width is beside it.
"""

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.stripe import Stripe, StripeSettings, extract_stripe
from crenel.metrology.transforms import Floats
from tests.bench.rows import bench_parser, measured_rows

Grey = NDArray[np.uint8]
WIDTHS_PX = (22, 36, 50)
ROOMS = (0.15, 0.4, 1.0)
"""Of the room's light as it was in the picture."""
HEIGHTS = (80.0, 160.0, 260.0)
"""Grey levels of the line on the brightest surfaces; the last is clipped."""
NOISE, BEAM_SD_PX, DARKEST = 1.5, 1.5, 0.25
FOUND, BESIDE = 0.3, 0.25
SET = StripeSettings(min_width_px=12, max_width_px=70)


@dataclass
class Tally:
    """What was found in the pictures of one kind."""

    pictures: int = 0
    found: int = 0
    found_as_set: int = 0
    points: int = 0
    beside: int = 0


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("folder", type=Path)
    given = parser.parse_args()
    rooms = list(read_rooms(given.folder))
    with measured_rows(given.json) as rows:
        rows.say(f"{len(rooms)} rooms, lines {WIDTHS_PX} px wide")
        for light in ROOMS:
            for height in HEIGHTS:
                tally = Tally()
                for number, room in enumerate(rooms):
                    measure(room, light, height, number, tally)
                rows.add(f"room {light:g}, line {height:.0f}", asdict(tally))


def read_rooms(folder: Path) -> Iterator[Grey]:
    """Those of at most 1400 pixels a side: larger ones would only take longer."""
    for path in sorted(folder.rglob("*")):
        grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        if grey is not None and max(grey.shape) <= 1400:
            yield np.asarray(grey, np.uint8)


def measure(room: Grey, light: float, height: float, seed: int, tally: Tally) -> None:
    for width_px in WIDTHS_PX:
        for lens in (disc(width_px), bell(width_px)):
            picture, line_rows = paint(room, light, height, lens, 100 * seed + width_px)
            on, beside = compare(extract_stripe(picture), line_rows, width_px)
            on_as_set, _ = compare(extract_stripe(picture, settings=SET), line_rows, width_px)
            tally.pictures += 1
            tally.found += on > FOUND * len(line_rows)
            tally.found_as_set += on_as_set > FOUND * len(line_rows)
            tally.points += on
            tally.beside += beside


def compare(stripe: Stripe, line_rows: Floats, width_px: int) -> tuple[int, int]:
    """How many points are on the line, and how many beside it."""
    off_px = np.abs(stripe.v - line_rows[np.rint(stripe.u).astype(int)])
    on = int((off_px < BESIDE * width_px).sum())
    return on, len(off_px) - on


def paint(
    room: Grey, light: float, height: float, lens: NDArray[np.float32], seed: int
) -> tuple[Grey, Floats]:
    """The picture, and the row of the line in each of its columns."""
    rng = np.random.default_rng(seed)
    rows, columns = room.shape
    along = np.arange(columns)
    tilt, bend, phase = rng.uniform(-0.15, 0.15), 30 * rng.random(), 2 * np.pi * rng.random()
    line_rows = (
        rows * rng.uniform(0.3, 0.7)
        + tilt * (along - columns / 2)
        + bend * np.sin(6 * along / columns + phase)
    )
    away = np.arange(rows)[:, None] - line_rows
    reflected = DARKEST + (1 - DARKEST) * room / 255
    laser = (np.exp(-0.5 * (away / BEAM_SD_PX) ** 2) * reflected).astype(np.float32)
    laser = cv2.filter2D(laser, -1, lens)
    laser *= height / np.percentile(laser, 99.5)
    seen = cv2.filter2D(room.astype(np.float32) * light, -1, lens) + laser
    noisy = seen + rng.normal(0, NOISE, seen.shape)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8), line_rows


def disc(width_px: float) -> NDArray[np.float32]:
    half = int(np.ceil(width_px / 2))
    y, x = np.mgrid[-half : half + 1, -half : half + 1]
    weights = np.clip(width_px / 2 + 0.5 - np.hypot(x, y), 0, 1)
    return np.asarray(weights / weights.sum(), np.float32)


def bell(width_px: float) -> NDArray[np.float32]:
    """A Gaussian that is as wide at half its height."""
    sd_px = width_px / 2.3548
    weights = cv2.getGaussianKernel(2 * int(np.ceil(4 * sd_px)) + 1, sd_px)
    return np.asarray(weights @ weights.T, np.float32)


if __name__ == "__main__":
    main()
