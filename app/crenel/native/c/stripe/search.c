/* Step 1: finds the peaks of the picture's columns, in one reading of the picture by rows.
 *
 * The score of a place is how far its core, four rows high, stands out of the brighter of its
 * surroundings, six cores above and below: so the edge of a lit face counts for nothing. A core is
 * the lesser of two means of two rows each: a hot pixel is in one of them only. Of eight cores
 * that follow one another in a column, a strip, the highest score is kept, and its place.
 * Included with BITS defined. */
#include "pixel.h"

#ifndef CRENEL_STRIPE_SEARCH
#define CRENEL_STRIPE_SEARCH
/* Rows from core to core, cores to the surroundings, rows of a core, cores of a strip. */
enum { STEP = 2, AWAY = 6, CORE_ROWS = 4, STRIP = 8 };
/* Cores kept while their surroundings are read, and two more for those that a mask darkens. */
enum { RING = 2 * AWAY + 2 };
/* Rows that are fetched ahead of their use. */
enum { AHEAD = 12 };

/* Where two cores, and their surroundings, begin in the ring. */
typedef struct {
    int64_t core[2], above[2], below[2];
} Cores;
#endif

static inline OF(greys) OF(core_of)(OF(greys) a, OF(greys) b, OF(greys) c, OF(greys) d)
{
    return OF(lower)(OF(mean)(a, c), OF(mean)(b, d));
}

/* The cores of four rows, and of those STEP rows further on; returns the highest of `most` and of
 * the rows' levels, which only pictures of 16 bits need. */
static inline OF(greys) OF(cores_at)(const PIXEL *at, int64_t line, int64_t count, PIXEL *one,
                                     PIXEL *other, OF(greys) most)
{
    OF(greys) row[6];
    for (int i = 0; i < 6; i++)
        row[i] = count == 64 ? OF(load_greys)(at + i * line) : OF(load_some)(at + i * line, count);
    OF(store_greys)(one, OF(core_of)(row[0], row[1], row[2], row[3]));
    OF(store_greys)(other, OF(core_of)(row[2], row[3], row[4], row[5]));
#if BITS == 16
    for (int i = 0; i < 6; i++)
        most = OF(higher)(most, row[i]);
#endif
    return most;
}

static OF(greys) OF(fill_cores)(const PIXEL *first, int64_t line, int64_t columns, PIXEL *one,
                                PIXEL *other, OF(greys) most)
{
    int64_t i = 0;
    for (; i + 64 <= columns; i += 64)
        most = OF(cores_at)(first + i, line, 64, one + i, other + i, most);
    if (i < columns)
        most = OF(cores_at)(first + i, line, columns - i, one + i, other + i, most);
    return most;
}

/* Keeps, by columns, the highest score of a strip; `place` is that of the first of two cores. */
static void OF(keep_highest)(const PIXEL *ring, const Cores *cores, int place, PIXEL *score,
                             uint8_t *at, int64_t columns)
{
    typedef uint8_t bytes __attribute__((vector_size(64), aligned(1), may_alias));
    typedef uint8_t places __attribute__((vector_size(64)));
    const PIXEL *core0 = ring + cores->core[0], *core1 = ring + cores->core[1];
    const PIXEL *above0 = ring + cores->above[0], *above1 = ring + cores->above[1];
    const PIXEL *below0 = ring + cores->below[0], *below1 = ring + cores->below[1];
    const places here0 = (uint8_t)place - (places){0}, here1 = here0 + 1;
    for (int64_t i = 0; i < columns; i += 64) {
        OF(greys) around0 = OF(higher)(OF(load_greys)(above0 + i), OF(load_greys)(below0 + i));
        OF(greys) around1 = OF(higher)(OF(load_greys)(above1 + i), OF(load_greys)(below1 + i));
        OF(greys) over0 = OF(excess)(OF(load_greys)(core0 + i), around0);
        OF(greys) over1 = OF(excess)(OF(load_greys)(core1 + i), around1);
        OF(greys) high = OF(higher)(over0, over1), kept = OF(load_greys)(score + i);
        places second = __builtin_convertvector(OF(over)(over1, over0), places);
        places better = __builtin_convertvector(OF(over)(high, kept), places);
        places here = (second & here1) | (~second & here0), before = *(const bytes *)(at + i);
        OF(store_greys)(score + i, OF(higher)(high, kept));
        *(bytes *)(at + i) = (better & here) | (~better & before);
    }
}

/* Copies a core's row with the columns taken out in which the mask allows no peak. */
static void OF(darken)(const PIXEL *core, const uint8_t *allowed, int64_t columns, PIXEL *out)
{
    for (int64_t i = 0; i < columns; i++)
        out[i] = allowed[i] ? core[i] : 0;
    for (int64_t i = columns; i % 64; i++)
        out[i] = 0;
}

static PIXEL OF(highest_in_row)(const PIXEL *row, int64_t columns)
{
    OF(greys) top = {0};
    for (int64_t i = 0; i < columns; i += 64) /* behind the columns are zeros */
        top = OF(higher)(top, OF(load_greys)(row + i));
    return OF(highest_of)(top);
}

/* The two cores from j on and their surroundings; next to the picture's border only the other
 * side shows the surroundings. */
static Cores OF(cores_from)(int64_t j, int64_t first, int64_t behind, int64_t row_px)
{
    Cores found;
    int64_t above = j - AWAY >= first ? j - AWAY : j + AWAY;
    int64_t below = j + AWAY < behind ? j + AWAY : above;
    for (int n = 0; n < 2; n++) {
        found.core[n] = (j + n) % RING * row_px;
        found.above[n] = (above + n) % RING * row_px;
        found.below[n] = (below + n) % RING * row_px;
    }
    return found;
}

/* Fills the strips' highest scores and their places for a part of the picture.
 *
 * Returns the height of the highest core of every fourth; `most` is raised to the highest levels.
 * The score's first and last strip stay empty; cores count from the picture's first row. */
static PIXEL OF(search_part)(Workspace *work, const int64_t *part, OF(greys) *most)
{
    const int64_t left = part[2], columns = part[3] - part[2];
    const int64_t line = work->width, row_px = work->padded;
    const PIXEL *pixels = work->pixels;
    PIXEL *ring = work->ring, *score = work->score, top = 0;
    /* cores are taken by two */
    const int64_t first = (part[0] + 2 * STEP - 1) / (2 * STEP) * 2;
    const int64_t cores = (part[1] - CORE_ROWS) / STEP + 1 - first;
    const int64_t behind = first + cores / 2 * 2;
    for (int64_t k = first; k < behind + AWAY; k += 2) {
        /* asked for row by row between the loops: many at once hold up what is read next */
        const int64_t next = k * STEP + AHEAD;
        const PIXEL *ahead = pixels + (next < work->height - 4 ? next : work->height - 4) * line + left;
        if (k < behind) {
            PIXEL *one = ring + k % RING * row_px, *other = ring + (k + 1) % RING * row_px;
            OF(fetch)(ahead, columns);
            *most = OF(fill_cores)(pixels + k * STEP * line + left, line, columns, one, other, *most);
            OF(fetch)(ahead + line, columns);
            if (k % 4 == 0) {
                PIXEL high = OF(highest_in_row)(one, columns);
                top = high > top ? high : top;
            }
            OF(fetch)(ahead + 2 * line, columns);
        }
        OF(fetch)(ahead + 3 * line, columns);
        const int64_t j = k - AWAY; /* its surroundings are known by now */
        if (j < first)
            continue;
        /* where a part ends amid the picture, what lies beyond may show an edge, not a peak */
        if ((part[0] > 0 && j < first + AWAY) || (part[1] < work->height && j + AWAY >= behind))
            continue;
        Cores here = OF(cores_from)(j, first, behind, row_px);
        for (int n = 0; n < 2 && work->allowed; n++) {
            /* the core itself is wanted as another's surroundings */
            const uint8_t *allowed = work->allowed + ((j + n) * STEP + 1) * line + left;
            OF(darken)(ring + here.core[n], allowed, columns, ring + (RING + n) * row_px);
            here.core[n] = (RING + n) * row_px;
        }
        const int64_t strip = (j / STRIP + 1) * row_px + left;
        OF(keep_highest)(ring, &here, (int)(j % STRIP), score + strip, work->place + strip, columns);
    }
    return top;
}

/* Fills the strips' highest scores for all parts; returns the height of the highest core. */
static PIXEL OF(search)(Workspace *work, PIXEL *brightest)
{
    PIXEL top = 0;
    OF(greys) most = {0};
    memset(work->score, 0, (size_t)(work->strips * work->padded) * sizeof(PIXEL));
    for (int64_t p = 0; p < work->part_count; p++) {
        PIXEL high = OF(search_part)(work, work->parts + 4 * p, &most);
        top = high > top ? high : top;
    }
    *brightest = OF(highest_of)(most);
    return top;
}

/* The search alone: fills score and place, and returns the height of the highest core. */
EXPORT(int64_t, OF(search))(Workspace *work)
{
    PIXEL brightest;
    return OF(search)(work, &brightest);
}
