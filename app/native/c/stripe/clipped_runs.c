/* A clipped line, step 1: the runs of clipped pixels in every column.
 *
 * Hardly a pixel is clipped, so many side by side are asked at once whether one of them is.
 * Included with BITS defined. */
#include "pixel.h"

#ifndef CRENEL_CLIPPED_RUNS
#define CRENEL_CLIPPED_RUNS
enum { BREAK = 2 };      /* unclipped pixels that break no run */
enum { AT_ONCE = 4 * 64 }; /* pixels that are asked at once */
#endif

/* Keeps the open run of a column, if it is as wide as a core and lies where the line may.
 *
 * Where bands are looked at, it may go on beyond them. */
static void OF(close_run)(const Workspace *work, Clipped *c, int64_t column, PIXEL level)
{
    const PIXEL *pixels = (const PIXEL *)work->pixels + column;
    const int64_t width = work->width, height = work->height;
    int64_t first = c->begun[column], last = c->lit[column];
    for (int64_t r = first - 1; r >= 0 && first - r <= BREAK + 1 && last - first < WIDEST_CORE; r--)
        if (pixels[r * width] >= level)
            first = r;
    for (int64_t r = last + 1; r < height && r - last <= BREAK + 1 && last - first < WIDEST_CORE; r++)
        if (pixels[r * width] >= level)
            last = r;
    const int64_t rows = last - first + 1, at = column * RUNS + c->runs[column];
    const bool allowed = !work->allowed || work->allowed[(first + last) / 2 * width + column];
    if (NARROWEST_CORE <= rows && rows <= WIDEST_CORE && c->runs[column] < RUNS && allowed) {
        c->run_first[at] = (int32_t)first;
        c->run_last[at] = (int32_t)last;
        c->runs[column]++;
    }
}

/* A clipped pixel goes on with its column's run, or begins a new one. */
static void OF(add_clipped)(const Workspace *work, Clipped *c, int64_t column, int64_t row,
                            PIXEL level)
{
    if (row - c->lit[column] > BREAK + 1) {
        if (c->begun[column] >= 0)
            OF(close_run)(work, c, column, level);
        c->begun[column] = (int32_t)row;
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
        OF(greys) some = i + 64 <= right ? OF(load_greys)(own + i) : OF(load_some)(own + i, right - i);
        for (uint64_t bits = OF(bits_of)(OF(over)(some, below)); bits; bits &= bits - 1)
            OF(add_clipped)(work, c, i + __builtin_ctzll(bits), row, level);
    }
}

/* Finds the runs in the parts that are read; a pixel in two parts counts once. */
static void OF(find_runs)(const Workspace *work, Clipped *c, PIXEL level)
{
    for (int64_t i = 0; i < work->width; i++) {
        c->begun[i] = c->lit[i] = -1 - BREAK - 1;
        c->runs[i] = 0;
    }
    for (int64_t row = 0; row < work->height; row++)
        for (const int64_t *part = work->parts; part < work->parts + 4 * work->part_count; part += 4)
            if (part[0] <= row && row < part[1])
                OF(find_in_row)(work, c, row, part[2], part[3], level);
    for (int64_t i = 0; i < work->width; i++)
        if (c->begun[i] >= 0)
            OF(close_run)(work, c, i, level);
}
