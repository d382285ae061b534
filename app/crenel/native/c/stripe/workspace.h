/* What one extraction works on and in: the picture, the settings, and the memory for all stages.
 *
 * app/crenel/metrology/stripe/workspace.py mirrors this structure, gives all memory, and keeps it from
 * frame to frame. Rows of tables are `padded` long: the picture's width, made a multiple of 64. */
#ifndef CRENEL_STRIPE_WORKSPACE_H
#define CRENEL_STRIPE_WORKSPACE_H

#include "../export.h"

/* Columns that are fitted together, so that every step is one for all of them. */
enum { BLOCK = 64 };

/* The normal matrix's lower half, row by row, of the parameters centre, height, width,
 * background; the first three in shares of the width and the height. */
enum { N00, N10, N11, N20, N21, N22, N30, N31, N32, N33, NORMAL_ROWS };

/* The fits of a block of columns, one lane each. */
typedef struct {
    float normal[NORMAL_ROWS][BLOCK], gradient[4][BLOCK], chi2[BLOCK], used[BLOCK];
    float centre[BLOCK], height[BLOCK], sigma[BLOCK], background[BLOCK];
    float first[BLOCK], last[BLOCK]; /* pixels that the fit takes */
    float state[BLOCK];              /* NO_PEAK, WIDER or PEAK */
    float moved[BLOCK];              /* the last step, in shares of the width */
    float variance[BLOCK];           /* of the centre */
    float clipped[BLOCK];            /* pixels of the window that are clipped */
} Block;

/* No peak; a peak that needs more rows or steps than it had; a peak. */
static const float NO_PEAK = 0, WIDER = 1, PEAK = 2;

/* Rows about a peak that are looked at where the usual number does not do, and rows of a profile:
 * neighbouring columns whose peaks are MOST_APART rows apart are taken together. */
enum { WIDEST_REACH = 40, MOST_APART = 31, PROFILE_ROWS = 2 * WIDEST_REACH + 1 + MOST_APART };

/* The pixels about the peaks of a block, row by row. */
typedef float Profile[PROFILE_ROWS][BLOCK];

/* Rows of the table of fits; the centre counts from the peak's row on. */
enum { CENTRE, AMPLITUDE, SIGMA, VARIANCE, CHI2, PIXELS, CLIPPED, BECAME, FIT_ROWS };

/* Rows of the table of peaks; points have all but the last, with UNSURE a standard deviation. */
enum { ALONG, ACROSS, HEIGHT, UNSURE, BROAD, PEAK_ROWS };

/* Blocks of peaks that give the noise; lists in which pixels' differences are counted. */
enum { NOISE_BLOCKS = 2, COUNT_LISTS = 4 };

/* Which of several peaks of a column is the stripe. */
enum { CONTINUITY, STRENGTH, FIRST, LAST };

/* What takes a piece for the line's, or leaves it: it shows most of the light, is brighter than the
 * clutter, or the line goes on in it; it is no brighter than the clutter, goes on beneath the line,
 * or there is no line at all. */
enum { TAKEN_MAIN, TAKEN_BRIGHT, TAKEN_ON, LEFT_DIM, LEFT_GHOST, LEFT_NO_LINE };

/* What decides that there is a line: it has columns and hardly a rival, stands nearly alone, is over
 * most of the picture or in nearly all columns, is in the dark, or outshines what else there is; that
 * there is none: no points, as much clutter, or a picture as bright. */
enum { AS_NO_RIVAL, AS_ALONE, AS_LONG, AS_WIDE, AS_DARK, AS_BRIGHT, NO_POINTS, NO_CLUTTERED, NO_DIM };

/* A piece of line: points from `begin` on, their number and mean height, and what takes it. */
typedef struct {
    int64_t begin, count;
    double height;
    bool kept;
    int32_t why;
} Piece;

typedef struct {
    /* the picture, turned so that the stripe crosses its columns */
    const void *pixels;
    int64_t height, width;
    const uint8_t *allowed; /* (height, width) pixels that may hold a peak; NULL for all */
    const int64_t *parts;   /* (part_count, 4) first row, behind the last; columns alike */
    int64_t part_count;

    /* the settings; NaN leaves a value to the picture */
    int64_t rule, shortest_run;
    double threshold, narrowest_px, widest_px; /* widths as standard deviations */
    double climb; /* rows by which a line may climb from one column to the next */

    /* (4) the noise's three terms and the usual width, by earlier frames; 0 where not known */
    float *known;

    /* memory */
    int64_t padded, strips, most_peaks;
    void *ring;                                        /* (RING + 2, padded) pixels */
    void *score;                                       /* (strips, padded) pixels */
    uint8_t *place;                                    /* (strips, padded) */
    int32_t *peak_columns, *peak_rows, *peak_heights;  /* (most_peaks) */
    int32_t *track, *track_order, *reached, *track_count; /* (most_peaks) */
    double *track_total, *worth;                       /* (most_peaks) */
    int32_t *best, *second;                            /* (width) */
    int32_t *begin;                                    /* (width + 1) */
    int32_t *columns, *rows; /* (width); at last, rows has why each point is taken, then left */
    int32_t *counts;                                   /* (COUNT_LISTS, count_levels) */
    int64_t count_levels;
    Block *blocks;    /* (NOISE_BLOCKS) */
    Profile *profiles; /* (NOISE_BLOCKS) */
    float *fits;      /* (FIT_ROWS, padded) */
    double *peaks;    /* (PEAK_ROWS, width) */
    double *points;   /* (4, width), the result */
    double *scratch;  /* (2, width) */
    Piece *pieces;    /* (width) */
    float *clutter; /* (width) */
    float *levels;  /* (padded) */
    uint8_t *clipped; /* (clipped_bytes) for lines whose core is clipped */

    /* results: how much of a line the points are, and how long, see evidence.c */
    double evidence, length;
    double saturated; /* the level from which on pixels count as clipped */
    double core_rows; /* usual width of the line's clipped core; 0 where it has none */
    double half_fall; /* rows over which the core's flanks fall to half; 0 where it has none */
    int64_t is_clipped; /* some points lie where the line is clipped, and have no peak */
    int64_t flanks;     /* so many of them */
    int64_t decision;   /* why there is a line or none */
    int64_t left;       /* points of pieces that are left, in `scratch`: along, across */
} Workspace;

#endif
