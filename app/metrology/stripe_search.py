"""Finding the peaks of an image's columns in one reading of the image.

The image is read once, by rows, and every loop handles a whole row at a time.
"""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import vector_kernel
from app.metrology.grey_lanes import (
    GREYS,
    Grey,
    Greys,
    Level,
    all_greys,
    excess,
    higher,
    load_greys,
    lower,
    mean,
    over,
    pick,
    store_greys,
)
from app.metrology.stripe_prefetch import prefetch

# A core is looked at every STEP rows; its surroundings lie AWAY cores above and below.
STEP = 2
AWAY = 6
CORE_ROWS = 4
# Of so many cores that follow one another the highest is kept: one peak a strip and column.
STRIP = 8
STRIP_ROWS = STRIP * STEP
# Fewer rows hold no core with its surroundings.
LEAST_ROWS = (AWAY + 2) * STEP + CORE_ROWS
# Cores kept while their surroundings are read; rows fetched ahead of their use; columns
# of tables are a multiple of PADDING, for whole vectors.
RING = 2 * AWAY + 2
AHEAD = 12
PADDING = 64
LINE_BYTES = 64

Place = TypeVar("Place", Greys, np.uint8)


@vector_kernel
def core(a: Level, b: Level, c: Level, d: Level) -> Level:
    """The lesser of the means of a and c, and of b and d: a hot pixel is in one of them only."""
    return lower(mean(a, c), mean(b, d))


@vector_kernel
def core_rows(
    pixels: Grey, width: int, first: int, ring: Grey, to: int, other: int, columns: int
) -> None:
    """The cores of four rows, and of those from STEP rows further on.

    All arrays are one row after the other: a view of a row would cost more than its loop.

    Args:
        pixels, width: an image, and how long its rows are.
        first: the pixel of the first row's first column.
        ring, to, other: filled with so many ``columns``, from two places on.
    """
    line = np.uintp(width)
    whole = columns - columns % GREYS
    for i in range(0, whole, GREYS):
        a = np.uintp(first + i)
        c = a + line + line
        e = c + line + line
        third, fourth = load_greys(pixels, c), load_greys(pixels, c + line)
        upper = core(load_greys(pixels, a), load_greys(pixels, a + line), third, fourth)
        lowest = core(third, fourth, load_greys(pixels, e), load_greys(pixels, e + line))
        store_greys(ring, np.uintp(to + i), upper)
        store_greys(ring, np.uintp(other + i), lowest)
    for i in range(whole, columns):
        a = np.uintp(first + i)
        c = a + line + line
        e = c + line + line
        ring[np.uintp(to + i)] = core(pixels[a], pixels[a + line], pixels[c], pixels[c + line])
        ring[np.uintp(other + i)] = core(pixels[c], pixels[c + line], pixels[e], pixels[e + line])


@vector_kernel
def highest(row: Grey) -> int:
    """The highest of a row."""
    top = row.dtype.type(0)
    for i in range(len(row)):
        top = max(top, row[i])
    return int(top)


@vector_kernel
def darken(core: Grey, allowed: NDArray[np.bool_]) -> None:
    """Takes away the cores that may be no peak."""
    none = core.dtype.type(0)
    for i in range(len(core)):
        core[i] = core[i] if allowed[i] else none


@vector_kernel
def higher_core(
    one: tuple[Level, Level, Level],
    other: tuple[Level, Level, Level],
    places: tuple[Place, Place],
    kept: Level,
    kept_at: Place,
) -> tuple[Level, Place]:
    """The highest of two cores and the one kept, and its place.

    Args:
        one, other: a core and its surroundings above and below, the brighter of which counts:
            so the edge of a lit face counts for nothing.
        places: theirs.
    """
    over0 = excess(one[0], higher(one[1], one[2]))
    over1 = excess(other[0], higher(other[1], other[2]))
    highest = higher(over0, over1)
    here = pick(over(over1, over0), places[1], places[0])
    return higher(highest, kept), pick(over(highest, kept), here, kept_at)


@vector_kernel
def keep_highest(
    ring: Grey,
    centres: tuple[int, int],
    above: tuple[int, int],
    below: tuple[int, int],
    place: int,
    score: Grey,
    at: NDArray[np.uint8],
    strip: int,
    columns: int,
) -> None:
    """Keeps, by columns, the highest of a strip's cores over the brighter of its surroundings.

    Args:
        ring: cores, one row after the other.
        centres, above, below: of two cores, where they and their surroundings begin in ring.
        place: of the first core in its strip.
        score, at: the strips' highest scores so far, and their cores' places.
        strip, columns: where the strip begins there, and how many columns of it are looked at.
    """
    here = np.uint8(place), np.uint8(place + 1)
    everywhere = all_greys(here[0]), all_greys(here[1])
    c0, a0, b0 = np.uintp(centres[0]), np.uintp(above[0]), np.uintp(below[0])
    c1, a1, b1 = np.uintp(centres[1]), np.uintp(above[1]), np.uintp(below[1])
    to = np.uintp(strip)
    whole = np.uintp(columns - columns % GREYS)
    for i in range(np.uintp(0), whole, np.uintp(GREYS)):
        one = load_greys(ring, c0 + i), load_greys(ring, a0 + i), load_greys(ring, b0 + i)
        other = load_greys(ring, c1 + i), load_greys(ring, a1 + i), load_greys(ring, b1 + i)
        kept, kept_at = load_greys(score, to + i), load_greys(at, to + i)
        kept, kept_at = higher_core(one, other, everywhere, kept, kept_at)
        store_greys(score, to + i, kept)
        store_greys(at, to + i, kept_at)
    for i in range(whole, np.uintp(columns)):
        alone = ring[c0 + i], ring[a0 + i], ring[b0 + i]
        beside = ring[c1 + i], ring[a1 + i], ring[b1 + i]
        score[to + i], at[to + i] = higher_core(alone, beside, here, score[to + i], at[to + i])


@vector_kernel
def fetch(pixels: Grey, first: int, columns: int) -> None:
    """Asks for pixels that will be read soon."""
    for i in range(first, first + columns, LINE_BYTES // pixels.itemsize):
        prefetch(pixels, i)


@vector_kernel
def search_part(
    image: Grey,
    where: NDArray[np.bool_],
    rows: tuple[int, int],
    columns: tuple[int, int],
    ring: Grey,
    score: Grey,
    at: NDArray[np.uint8],
) -> int:
    """Fills the strips' highest scores and where they are, for a part of the image.

    Args:
        image: (H, W).
        where: (H, W) pixels that may hold a peak, or (0, 0) for all.
        rows, columns: first and behind the last; at least ``LEAST_ROWS`` rows.
        ring: (RING + 2, W) room to work in.
        score, at: (strips + 2, W) of the image's strips, from the second on; cores are
            counted from the image's first row, ``at`` from the strip's first core.

    Returns:
        The height of the highest core, of every fourth.
    """
    left, width = columns[0], columns[1] - columns[0]
    line, row_px = image.shape[1], ring.shape[1]
    pixels, cores = image.reshape(-1), ring.reshape(-1)
    scores, places = score.reshape(-1), at.reshape(-1)
    # cores are taken by two
    first = (rows[0] + 2 * STEP - 1) // (2 * STEP) * 2
    behind = first + ((rows[1] - CORE_ROWS) // STEP + 1 - first) // 2 * 2
    masked = where.shape[0] > 0
    top = 0
    for k in range(first, behind + AWAY, 2):
        # asked for row by row between the loops: many at once hold up what is read next
        ahead = min(k * STEP + AHEAD, len(image) - 4) * line + left
        if k < behind:
            one, other = k % RING * row_px, (k + 1) % RING * row_px
            fetch(pixels, ahead, width)
            core_rows(pixels, line, k * STEP * line + left, cores, one, other, width)
            fetch(pixels, ahead + line, width)
            if k % 4 == 0:
                top = max(top, highest(cores[one : one + width]))
            fetch(pixels, ahead + 2 * line, width)
        fetch(pixels, ahead + 3 * line, width)
        j = k - AWAY  # its surroundings are known by now
        if j < first:
            continue
        # where a part ends amid the image, what lies beyond may tell an edge from a peak
        if (rows[0] > 0 and j < first + AWAY) or (rows[1] < len(image) and j + AWAY >= behind):
            continue
        # next to the image's border only the other side shows the surroundings
        above = j - AWAY if j - AWAY >= first else j + AWAY
        below = j + AWAY if j + AWAY < behind else above
        centres = (j % RING, (j + 1) % RING)
        if masked:
            for n in range(2):
                # the core itself is wanted as another's surroundings
                ring[RING + n][:width] = ring[centres[n]][:width]
                darken(ring[RING + n][:width], where[(j + n) * STEP + 1][left : left + width])
            centres = (RING, RING + 1)
        keep_highest(
            cores,
            (centres[0] * row_px, centres[1] * row_px),
            (above % RING * row_px, (above + 1) % RING * row_px),
            (below % RING * row_px, (below + 1) % RING * row_px),
            j % STRIP,
            scores,
            places,
            (j // STRIP + 1) * score.shape[1] + left,
            width,
        )
    return top


@vector_kernel
def search(
    image: Grey,
    where: NDArray[np.bool_],
    parts: NDArray[np.int64],
    ring: Grey,
    score: Grey,
    at: NDArray[np.uint8],
) -> int:
    """Fills the strips' highest scores and where they are, for the parts (n, 4) of the image.

    A part is its first row and the one behind its last, and its columns alike; the other
    arguments and the result are those of ``search_part``.
    """
    score[:] = 0
    top = 0
    for p in range(len(parts)):
        rows, columns = (parts[p][0], parts[p][1]), (parts[p][2], parts[p][3])
        top = max(top, search_part(image, where, rows, columns, ring, score, at))
    return top
