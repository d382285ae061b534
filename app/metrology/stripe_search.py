"""Finding the peaks of an image's columns in one reading of the image.

The image is read once, by rows, and every loop handles a whole row at a time.
"""

import numpy as np
from numpy.typing import NDArray

from app.metrology.compiled import vector_kernel
from app.metrology.stripe_prefetch import prefetch

# A core is looked at every STEP rows; its surroundings lie AWAY cores above and below.
STEP = 2
AWAY = 6
CORE_ROWS = 4
# Of so many cores that follow one another the highest is kept: one peak a strip and column.
STRIP = 8
STRIP_ROWS = STRIP * STEP
# Peaks in neighbouring strips are two peaks where so many cores lie between them.
APART = 6
# Fewer rows hold no core with its surroundings.
LEAST_ROWS = (AWAY + 2) * STEP + CORE_ROWS
# Cores kept while their surroundings are read; rows fetched ahead of their use; columns
# of tables are a multiple of PADDING, for whole vectors and words.
RING = 2 * AWAY + 2
AHEAD = 24
PADDING = 64
LINE_BYTES = 64

Grey = NDArray[np.uint8] | NDArray[np.uint16]
Wide = NDArray[np.uint16] | NDArray[np.uint32]


@vector_kernel
def core_row(image: Grey, r: int, left: int, wide: Wide, core: Grey) -> None:
    """The cores of the four rows from r on, by columns from ``left`` on.

    The lesser of the means of the first and third row and of the second and fourth: a hot
    pixel is in one of them only.

    Args:
        wide: any array of a type that holds the sum of two pixels.
    """
    # views made here, not by the caller, so that the compiler knows how they lie
    right = left + len(core)
    a, b = image[r][left:right], image[r + 1][left:right]
    c, d = image[r + 2][left:right], image[r + 3][left:right]
    T, W = core.dtype.type, wide.dtype.type
    for i in range(len(core)):
        odd = T(W(W(W(a[i]) + W(c[i])) + W(1)) >> W(1))
        even = T(W(W(W(b[i]) + W(d[i])) + W(1)) >> W(1))
        core[i] = min(odd, even)


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
def keep_highest(
    ring: Grey,
    centres: tuple[int, int],
    above: tuple[int, int],
    below: tuple[int, int],
    place: int,
    score: Grey,
    at: NDArray[np.uint8],
) -> None:
    """Keeps, by columns, the highest of a strip's cores over the brighter of its surroundings.

    So the edge of a lit face counts for nothing.

    Args:
        ring: (n, W) cores of rows.
        centres, above, below: of two cores, where they and their surroundings are in ring.
        place: of the first core in its strip.
        score, at: (W,) the strip's highest score so far, and its core's place.
    """
    width = len(score)
    c0, a0, b0 = ring[centres[0]][:width], ring[above[0]][:width], ring[below[0]][:width]
    c1, a1, b1 = ring[centres[1]][:width], ring[above[1]][:width], ring[below[1]][:width]
    T = ring.dtype.type
    first, second = np.uint8(place), np.uint8(place + 1)
    for i in range(width):
        around = max(a0[i], b0[i])
        over0 = T(max(c0[i], around) - around)
        around = max(a1[i], b1[i])
        over1 = T(max(c1[i], around) - around)
        over = max(over0, over1)
        here = second if over1 > over0 else first
        kept = score[i]
        at[i] = here if over > kept else at[i]
        score[i] = max(over, kept)


@vector_kernel
def fetch(image: Grey, r: int, behind: int, left: int, right: int) -> None:
    """Asks for a row that will be read soon, if there is one."""
    if r < behind:
        row = image[r]
        for i in range(left, right, LINE_BYTES // image.itemsize):
            prefetch(row, i)


@vector_kernel
def search_part(
    image: Grey,
    where: NDArray[np.bool_],
    rows: tuple[int, int],
    columns: tuple[int, int],
    ring: Grey,
    wide: Wide,
    score: Grey,
    at: NDArray[np.uint8],
) -> int:
    """Fills the strips' highest scores and where they are, for a part of the image.

    Args:
        image: (H, W).
        where: (H, W) pixels that may hold a peak, or (0, 0) for all.
        rows, columns: first and behind the last; at least ``LEAST_ROWS`` rows.
        ring: (RING + 2, W) room to work in.
        wide: see ``core_row``.
        score, at: (strips + 2, W) of the image's strips, from the second on; cores are
            counted from the image's first row, ``at`` from the strip's first core.

    Returns:
        The height of the highest core, of every fourth.
    """
    left, right = columns
    width = right - left
    # cores are taken by two
    first = (rows[0] + 2 * STEP - 1) // (2 * STEP) * 2
    behind = first + ((rows[1] - CORE_ROWS) // STEP + 1 - first) // 2 * 2
    masked = where.shape[0] > 0
    top = 0
    for k in range(first, behind + AWAY, 2):
        # asked for row by row between the loops: many at once hold up what is read next
        ahead = k * STEP + AHEAD
        fetch(image, ahead, rows[1], left, right)
        if k < behind:
            core_row(image, k * STEP, left, wide, ring[k % RING][:width])
            fetch(image, ahead + 1, rows[1], left, right)
            core_row(image, k * STEP + STEP, left, wide, ring[(k + 1) % RING][:width])
            fetch(image, ahead + 2, rows[1], left, right)
            if k % 4 == 0:
                top = max(top, highest(ring[k % RING][:width]))
        fetch(image, ahead + 3, rows[1], left, right)
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
                darken(ring[RING + n][:width], where[(j + n) * STEP + 1][left:right])
            centres = (RING, RING + 1)
        strip = j // STRIP + 1
        keep_highest(
            ring,
            centres,
            (above % RING, (above + 1) % RING),
            (below % RING, (below + 1) % RING),
            j % STRIP,
            score[strip][left:right],
            at[strip][left:right],
        )
    return top


@vector_kernel
def search(
    image: Grey,
    where: NDArray[np.bool_],
    parts: NDArray[np.int64],
    ring: Grey,
    wide: Wide,
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
        top = max(top, search_part(image, where, rows, columns, ring, wide, score, at))
    return top


@vector_kernel
def mark_peaks(
    score: Grey, at: NDArray[np.uint8], s: int, threshold: int, marks: NDArray[np.uint8]
) -> int:
    """Marks, by columns, where strip s holds a peak; 0 if nowhere.

    A peak is over the threshold, and no flank of a higher one in a neighbouring strip.
    """
    above, here, below = score[s - 1], score[s], score[s + 1]
    at_above, at_here, at_below = at[s - 1], at[s], at[s + 1]
    least = score.dtype.type(threshold)
    span = np.uint8(STRIP - APART)
    found = np.uint8(0)
    for i in range(len(marks)):
        # where a cell is empty its place says nothing, and its score is below any other
        over_above = (here[i] > above[i]) | (np.uint8(at_here[i] + span) >= at_above[i])
        over_below = (here[i] >= below[i]) | (np.uint8(at_below[i] + span) >= at_here[i])
        mark = np.uint8((here[i] > least) & over_above & over_below)
        marks[i] = mark
        found = np.uint8(found | mark)
    return int(found)


@vector_kernel
def list_peaks(
    score: Grey,
    at: NDArray[np.uint8],
    threshold: int,
    marks: NDArray[np.uint8],
    words: NDArray[np.uint64],
    columns: NDArray[np.int32],
    rows: NDArray[np.int32],
    heights: NDArray[np.int32],
) -> int:
    """All peaks above a score, strip after strip; returns how many.

    Args:
        score, at: see ``search_part``; the first and the last strip are empty.
        marks, words: (W,) and the same memory in words.
        columns, rows, heights: filled; a peak lies within a row or two of ``rows``.
    """
    found = 0
    for s in range(1, len(score) - 1):
        if not mark_peaks(score, at, s, threshold, marks):
            continue
        for w in range(len(words)):
            if words[w] == 0:
                continue
            for i in range(8 * w, 8 * w + 8):
                if marks[i] and found < len(columns):
                    columns[found] = i
                    rows[found] = ((s - 1) * STRIP + at[s][i]) * STEP + 1
                    heights[found] = score[s][i]
                    found += 1
    return found
