"""The pixels about peaks, taken for a block of them."""

import numpy as np
import pytest

from app.metrology.stripe_block import LANES, PROFILE_ROWS, gather

REACH = 7
HEIGHT, WIDTH = 60, 150


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@pytest.mark.parametrize(
    ("columns", "rows"),
    [
        (np.arange(64) + 5, np.full(64, 30)),
        (np.arange(64) + 5, 30 + np.arange(64) % 5),
        (np.arange(64) + 86, 15 + np.arange(64) // 2),
        (np.arange(64) + 5, 30 + 13 * (np.arange(64) % 2)),
        (np.arange(64) + 5, 15 + np.random.default_rng(2).permutation(64) % 30),
        (np.arange(64) + 5, 8 + 35 * (np.arange(64) % 2)),
        (2 * np.arange(64) + 5, 30 + np.arange(64) % 3),
        (np.arange(40) + 20, 25 + np.arange(40) % 3),
        (np.arange(64) + 5, np.arange(64) % HEIGHT),
    ],
    ids=[
        "level",
        "jagged",
        "sloped",
        "apart",
        "all-ways",
        "too-far",
        "every-other",
        "not-full",
        "over-the-border",
    ],
)
def test_each_lane_holds_the_pixels_about_its_peak(
    kind: type[np.uint8] | type[np.uint16], columns: np.ndarray, rows: np.ndarray
) -> None:
    image = np.random.default_rng(1).integers(0, np.iinfo(kind).max, (HEIGHT, WIDTH)).astype(kind)
    size = PROFILE_ROWS * LANES
    profile = np.full(size, -1, np.float32)
    places = columns.astype(np.int32), rows.astype(np.int32)
    gather(image.reshape(-1), WIDTH, *places, REACH, np.zeros(size, kind), profile)

    lane = np.minimum(np.arange(LANES), len(columns) - 1)
    seen = np.clip(rows[lane] + np.arange(-REACH, REACH + 1)[:, None], 0, HEIGHT - 1)
    assert np.array_equal(profile.reshape(-1, LANES)[: 2 * REACH + 1], image[seen, columns[lane]])
