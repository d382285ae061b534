/* Before step 5: the grey level from which on the line's core is flat, and shows no position.
 *
 * A sensor clips at its full scale, but compression, tints and grey of colour move that level and
 * spread it; other lines are flat by themselves. A bell is not: of its rows above half its height,
 * a quarter lie within 4 % of its top. Included with BITS defined. */
#include "pixel.h"

#ifndef CRENEL_STRIPE_PLATEAU
#define CRENEL_STRIPE_PLATEAU
/* Columns looked at, no more than a padded row has, and rows up and down. */
enum { PLATEAU_COLUMNS = 64, PLATEAU_ROWS = 64 };
/* The plateau's lowest level in shares of its top, which so many columns reach; its rows at least,
 * and in shares of those above half its height, in most of them. */
static const double PLATEAU_LEVEL = 0.93, PLATEAU_SHARE = 0.4;
enum { FEWEST_FLAT_ROWS = 4, FEWEST_FLAT_COLUMNS = 6 };
/* So many rows inside the plateau that lie below full scale, in shares of it, are chance. */
static const double BELOW_FULL = 0.1;
#endif

/* How many rows from `at` on, one after another in one way, have a level at least; `below` counts
 * those that lie below full scale. */
static int OF(count_rows)(const Workspace *work, const PIXEL *at, int64_t row, int way, double least,
                          double full, int *below)
{
    int found = 0;
    for (; found < PLATEAU_ROWS && row >= 0 && row < work->height && *at >= least; found++) {
        *below += *at < full;
        row += way;
        at += way * work->width;
    }
    return found;
}

/* The row of the highest pixel about a column's chosen peak; -1 where there is none. */
static int64_t OF(top_row)(const Workspace *work, int64_t column)
{
    if (work->best[column] < 0)
        return -1;
    const int64_t first = work->peak_rows[work->best[column]];
    const PIXEL *pixels = (const PIXEL *)work->pixels + column;
    int64_t top = first;
    for (int64_t row = first + 1; row < min_i64(first + CORE_ROWS, work->height); row++)
        if (pixels[row * work->width] > pixels[top * work->width])
            top = row;
    return top;
}

/* Whether the top of a column's peak is flat: its rows from the level `least` on. */
static bool OF(is_flat)(const Workspace *work, int64_t column, int64_t row, double least,
                        double full, int *below)
{
    const PIXEL *top = (const PIXEL *)work->pixels + row * work->width + column;
    int other = 0, within = -2; /* its first and last row may lie below */
    const int up = OF(count_rows)(work, top, row, -1, least, full, &within);
    const int down = OF(count_rows)(work, top, row, 1, least, full, &within);
    const int flat = up + down - 1;
    if (flat < FEWEST_FLAT_ROWS)
        return false;
    const int half = OF(count_rows)(work, top, row, -1, least / 2, full, &other) +
                     OF(count_rows)(work, top, row, 1, least / 2, full, &other) - 1;
    *below += within > BELOW_FULL * flat;
    return flat > PLATEAU_SHARE * half;
}

/* The level from which on pixels count as clipped: `full` scale, or lower where the line's top is
 * flat below it. */
static float OF(clipping_level)(Workspace *work, float full)
{
    float tops[PLATEAU_COLUMNS];
    int64_t rows[PLATEAU_COLUMNS], columns[PLATEAU_COLUMNS];
    int found = 0, high = 0, flat = 0, below = 0;
    for (int k = 0; k < PLATEAU_COLUMNS; k++) {
        const int64_t column = (2 * k + 1) * work->width / (2 * PLATEAU_COLUMNS);
        const int64_t row = OF(top_row)(work, column);
        if (row < 0)
            continue;
        columns[found] = column;
        rows[found] = row;
        work->levels[found] = ((const PIXEL *)work->pixels)[row * work->width + column];
        tops[found] = work->levels[found];
        found++;
    }
    if (found < FEWEST_FLAT_COLUMNS)
        return full;
    const double least =
        PLATEAU_LEVEL * nth_of(work->levels, found, found - FEWEST_FLAT_COLUMNS);
    for (int k = 0; k < found; k++) {
        if (tops[k] < least)
            continue;
        high++;
        flat += OF(is_flat)(work, columns[k], rows[k], least, full, &below);
    }
    if (flat < FEWEST_FLAT_COLUMNS || 2 * flat < high || 2 * below < flat)
        return full;
    return ceilf((float)least);
}
