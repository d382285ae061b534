/* A clipped line, step 1: the runs of clipped pixels in every column.
 *
 * Two clipped pixels of a column are of one run where at most BREAK between them are not. So every
 * third row shows which runs there are, and the columns where they begin and end. Hardly a pixel
 * is clipped: many side by side are asked at once whether one of them is. Included with BITS
 * defined. */
#include "pixel.h"

#ifndef CRENEL_CLIPPED_RUNS
#define CRENEL_CLIPPED_RUNS
enum { BREAK = 2, ROW_STEP = BREAK + 1 };
enum { AT_ONCE = 4 * 64 }; /* pixels that are asked at once */
#endif

/* The last clipped pixel of a run, followed from a row on, up (-1) or down (1) the column; no
 * further than makes it too wide. Where bands are looked at, it may go on beyond them. */
static int64_t OF(run_end)(const Workspace *work, int64_t column, int64_t row, int64_t way,
                           PIXEL level)
{
    const PIXEL *pixels = (const PIXEL *)work->pixels + column;
    int64_t end = row;
    for (int64_t unclipped = 0, off = 1; unclipped <= BREAK && off <= WIDEST_CORE; off++) {
        const int64_t r = row + way * off;
        if (r < 0 || r >= work->height)
            break;
        unclipped++;
        if (pixels[r * work->width] >= level) {
            end = r;
            unclipped = 0;
        }
    }
    return end;
}

/* Keeps a run, if it is as wide as a core and lies where the line may. */
static void OF(keep_run)(const Workspace *work, Clipped *c, int64_t column, int64_t last,
                         PIXEL level)
{
    const int64_t first = OF(run_end)(work, column, c->begun[column], -1, level);
    const int64_t rows = last - first + 1, at = column * RUNS + c->runs[column];
    if (rows < NARROWEST_CORE || rows > WIDEST_CORE || c->runs[column] == RUNS)
        return;
    if (work->allowed && !work->allowed[(first + last) / 2 * work->width + column])
        return;
    c->run_first[at] = (int32_t)first;
    c->run_last[at] = (int32_t)last;
    c->runs[column]++;
}

/* A clipped pixel goes on with its column's run, or begins a new one. */
static void OF(add_clipped)(const Workspace *work, Clipped *c, int64_t column, int64_t row,
                            PIXEL level)
{
    if (c->begun[column] < 0) {
        c->begun[column] = (int32_t)row;
    } else if (row - c->lit[column] > ROW_STEP) {
        const int64_t last = OF(run_end)(work, column, c->lit[column], 1, level);
        if (last < row) {
            OF(keep_run)(work, c, column, last, level);
            c->begun[column] = (int32_t)row;
        }
    }
    c->lit[column] = (int32_t)row;
}

/* Looks at the columns of a row from `left` to before `right`. */
static void OF(find_in_row)(const Workspace *work, Clipped *c, int64_t row, int64_t left,
                            int64_t right, PIXEL level)
{
    const PIXEL *own = (const PIXEL *)work->pixels + row * work->width;
    const OF(greys) below = OF(all_greys)(level - 1);
    for (int64_t i = left; i < right; i += 64) {
        OF(greys) lit = {0};
        for (int k = 0; k < AT_ONCE && i + AT_ONCE <= right; k += 64)
            lit |= OF(over)(OF(load_greys)(own + i + k), below);
        if (i + AT_ONCE <= right && !OF(bits_of)(lit)) {
            i += AT_ONCE - 64;
            continue;
        }
        const int64_t count = min_i64(64, right - i);
        const OF(greys) some =
            count == 64 ? OF(load_greys)(own + i) : OF(load_some)(own + i, count);
        for (uint64_t bits = OF(bits_of)(OF(over)(some, below)); bits; bits &= bits - 1)
            OF(add_clipped)(work, c, i + __builtin_ctzll(bits), row, level);
    }
}

/* Finds the runs in the parts that are read; a pixel in two parts counts once. */
static void OF(find_runs)(const Workspace *work, Clipped *c, PIXEL level)
{
    for (int64_t i = 0; i < work->width; i++) {
        c->begun[i] = -1;
        c->runs[i] = 0;
    }
    const int64_t *end = work->parts + 4 * work->part_count;
    for (int64_t row = 0; row < work->height; row += ROW_STEP)
        for (const int64_t *part = work->parts; part < end; part += 4)
            if (part[0] <= row && row < part[1])
                OF(find_in_row)(work, c, row, part[2], part[3], level);
    for (int64_t i = 0; i < work->width; i++)
        if (c->begun[i] >= 0)
            OF(keep_run)(work, c, i, OF(run_end)(work, i, c->lit[i], 1, level), level);
}
