"""The loops over whole rows of an image say the same as numpy, whatever the row's length."""

import numpy as np
import pytest

from app.metrology.stripe_search import core_rows, keep_highest

ROWS, AT = 6, 3


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@pytest.mark.parametrize("columns", [1, 63, 64, 65, 200])
def test_cores_are_the_lesser_of_two_rounded_means(kind: type, columns: int) -> None:
    top = np.iinfo(kind).max
    image = np.random.default_rng(columns).integers(0, top, (ROWS, 210), kind, endpoint=True)
    ring = np.zeros(2 * columns, kind)
    core_rows(image.reshape(-1), 210, AT, ring, 0, columns, columns)
    wide = image[:, AT : AT + columns].astype(np.int64)
    mean = (wide[:-2] + wide[2:] + 1) // 2
    assert np.array_equal(ring[:columns], np.minimum(mean[0], mean[1]))
    assert np.array_equal(ring[columns:], np.minimum(mean[2], mean[3]))


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@pytest.mark.parametrize("columns", [1, 64, 150])
def test_the_highest_over_the_brighter_of_its_surroundings_is_kept(
    kind: type, columns: int
) -> None:
    rng = np.random.default_rng(columns)
    ring = rng.integers(0, 200, (6, columns)).astype(kind)
    kept = rng.integers(0, 60, columns).astype(kind)
    score, at = kept.copy(), np.zeros(columns, np.uint8)
    begin = [row * columns for row in range(6)]
    keep_highest(
        ring.reshape(-1),
        (begin[0], begin[1]),
        (begin[2], begin[3]),
        (begin[4], begin[5]),
        4,
        score,
        at,
        0,
        columns,
    )
    wide = ring.astype(np.int64)
    over = np.maximum(wide[:2] - np.maximum(wide[2:4], wide[4:]), 0)
    best = np.maximum(over.max(axis=0), kept)
    place = np.where(over.max(axis=0) > kept, 4 + (over[1] > over[0]), 0)
    assert np.array_equal(score, best)
    assert np.array_equal(at, place)
