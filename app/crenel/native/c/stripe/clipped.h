/* What the steps of a clipped line pass to each other.
 *
 * Where the line's core is clipped, only its two flanks show where it lies. The steps:
 * clipped_runs.c finds the clipped pixels, cores.c those that are the line's core, flanks.c reads
 * the pixels beside it, flank_step.c, flank_noise.c and flank_fit.c fit them, smooth.c smooths and
 * join.c joins the points with the rest of the line. */
#ifndef CRENEL_CLIPPED_H
#define CRENEL_CLIPPED_H

#include "../export.h"
#include "lanes.h"

enum {
    RUNS = 6,           /* clipped runs kept in a column */
    NARROWEST_CORE = 5, /* widths of a clipped core in px */
    WIDEST_CORE = 64,
    HALO_CORE = 8,      /* one so wide shows a position by itself */
    FLANK = 11,         /* pixels looked at beside the core on each side */
    BACKGROUND_PX = 13, /* those further out that show the background */
    FEWEST_COLUMNS = 40 /* that the flanks' shared shape needs */
};
/* The signal of a pixel that is clipped or beyond the picture: it counts for nothing. */
static const float UNSEEN = -1e9f;
/* Cells beside the columns that the smoothing reaches over. */
enum { SMOOTH_MARGIN = WIDEST_CORE + LANES };

/* W columns; arrays of n begin with those in use. */
typedef struct {
    int64_t width;
    /* Clipped runs: where the open one of each column began and last was lit (W); how many are
     * closed (W), their first and last rows and their tracks (W, RUNS). */
    int32_t *begun, *lit, *runs, *run_first, *run_last, *run_track;
    /* Of each track (W RUNS): how many runs or cores it has, the first and the last of them. */
    int32_t *length, *opens, *closes;
    /* The clipped core of n columns, rows and track alike, and their usual width in px. */
    int64_t cores;
    int32_t *column, *first, *last, *track;
    double core_width;
    double half_fall; /* rows over which the flanks fall to half, beside the core */
    /* Beside each core, above and below it (n): background and height of clipping over it, in
     * grey levels; in whole blocks of LANES columns: signals (blocks, 2 FLANK, LANES) in shares
     * of the height of clipping above. */
    float *background[2], *top[2], *signal;
    /* The fit of each core (n): half the core's width, by how much the flanks' middle lies below
     * the core's, logarithm of the brightness in shares of top[0], the last step's length, the
     * middle's variance (NaN where there is no fit), chi squared by degrees of freedom, pixels. */
    float *half, *shift, *log_height, *move, *variance, *misfit, *count;
    /* The flanks' middles (flanks): their columns, rows, variances by noise, and what two
     * brightnesses of the surface may shift the middle by, squared. */
    int64_t flanks;
    int32_t *flank_column;
    double *centre, *by_noise, *by_surface;
    /* The line smoothed along itself, in cells of a column each. With SMOOTH_MARGIN more at both
     * ends: rows over a common level, and weights. Without: what a line through the cells about
     * each one says of its row, that row's variance, what the bend adds to it, and the misfit;
     * whether the cells there are straight. */
    float *level, *weight, *here, *spread, *pulled, *scatter;
    uint8_t *straight;
    /* The line with its clipped part (W): columns, rows, which peak or flank each point is, which
     * of them are kept; rows by the smoothing; workspace (2 W). */
    double *along, *across, *mean, *workspace;
    int32_t *source, *kept;
} Clipped;

/* The next bytes of the memory, beginning on a line of the caches. */
static void *cut(uint8_t *memory, int64_t *used, int64_t bytes)
{
    void *piece = memory ? memory + *used : NULL;
    *used += (bytes + 63) / 64 * 64;
    return piece;
}

/* Cuts the memory of a picture's width into arrays; returns how many bytes that takes.
 *
 * memory: begins on a line of the caches; NULL to ask only. */
static int64_t cut_clipped(Clipped *c, int64_t width, uint8_t *memory)
{
    int64_t used = 0, whole = (width + LANES - 1) / LANES * LANES;
    int64_t ints = 4 * whole, floats = 4 * whole, doubles = 8 * whole;
    c->width = width;
    int32_t **columns[] = {&c->begun,  &c->lit,   &c->runs,         &c->column, &c->first,
                           &c->last,   &c->track, &c->flank_column, &c->source, &c->kept};
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
        *columns[i] = cut(memory, &used, ints);
    int32_t **runs[] = {&c->run_first, &c->run_last, &c->run_track,
                        &c->length,    &c->opens,    &c->closes};
    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++)
        *runs[i] = cut(memory, &used, RUNS * ints);
    float **fits[] = {&c->background[0], &c->background[1], &c->top[0],     &c->top[1],
                      &c->half,          &c->shift,         &c->log_height, &c->move,
                      &c->variance,      &c->misfit,        &c->count,      &c->here,
                      &c->spread,        &c->pulled,        &c->scatter};
    for (size_t i = 0; i < sizeof fits / sizeof *fits; i++)
        *fits[i] = cut(memory, &used, floats);
    c->signal = cut(memory, &used, 2 * FLANK * floats);
    double **points[] = {&c->centre, &c->by_noise, &c->by_surface, &c->along, &c->across, &c->mean};
    for (size_t i = 0; i < sizeof points / sizeof *points; i++)
        *points[i] = cut(memory, &used, doubles);
    c->workspace = cut(memory, &used, 2 * doubles);
    c->level = cut(memory, &used, floats + 4 * 2 * SMOOTH_MARGIN);
    c->weight = cut(memory, &used, floats + 4 * 2 * SMOOTH_MARGIN);
    c->straight = cut(memory, &used, whole);
    return used;
}

#endif
