/* Step 14: whether the points are a line at all: long, and brighter than what else is in the
 * picture. Included with BITS defined. */
#include "pixel.h"

#ifndef CRENEL_STRIPE_EVIDENCE
#define CRENEL_STRIPE_EVIDENCE
/* A long line has such a piece, or points in so many columns, in shares of the picture's width.
 * More clutter than a share of its height in most columns makes it none, and a short one sooner. */
static const double LONG_LINE = 0.3, MANY_COLUMNS = 0.5;
static const double MOST_CLUTTER = 0.67, MOST_CLUTTER_SHORT = 0.5;
/* It is so much higher than the grey that so much of the picture is below; one in many columns
 * need not be if it stands nearly alone, with less clutter than this. */
static const double NEARLY_ALONE = 0.25;
static const double ABOVE_GREY = 1.3, ABOVE_GREY_SHORT = 1.8, GREY_SHARE = 0.95;
/* One in nearly all columns may have more beside dim pieces of it, as over the black squares of a
 * board, if its long pieces stand nearly alone. */
static const double NEARLY_ALL_COLUMNS = 0.85;
/* A line over most of the picture may have any clutter, and be hardly higher than the grey. */
static const double MOST_OF_PICTURE = 0.6, HARDLY_ABOVE_GREY = 0.95;
/* In the dark, where the line is so many times as high as that grey, other light in its columns is
 * mostly the laser's: the line on what is behind, and its reflections. A line of so many points,
 * or one in so many columns, may have as much of it. */
static const double IN_THE_DARK = 6, CLUTTER_IN_THE_DARK = 1.05;
enum { POINTS_IN_THE_DARK = 80 };
/* Rows and columns from one pixel that shows the picture's grey to the next; levels counted. */
enum { GREY_ROWS = 8, GREY_COLUMNS = 4, GREY_LEVELS = 256 };

/* The length of n pieces of line, as that of one piece which shows as much, and their height. */
static double effective_length(const Piece *pieces, int64_t n, double *height)
{
    double squares = 0, light = 0;
    for (int64_t k = 0; k < n; k++) {
        const double square = (double)(pieces[k].count * pieces[k].count);
        squares += square;
        light += square * pieces[k].height;
    }
    *height = squares > 0 ? light / squares : 0;
    return sqrt(squares);
}

/* What the clutter in most columns is at most, in shares of one height. */
static double clutter_below(const Workspace *work, double height)
{
    memcpy(work->levels, work->clutter, (size_t)work->width * sizeof *work->levels);
    return nth_of(work->levels, work->width, (int64_t)(CLUTTER_SHARE * (double)work->width)) /
           height;
}
#endif

/* The grey that a share of the parts that were read is below, beside the line. */
static double OF(grey_below)(const Workspace *work, const int32_t *point_at, double brightest)
{
    const PIXEL *pixels = work->pixels;
    const double per_level = (GREY_LEVELS - 1) / max_f64(brightest, 1);
    const double *across = work->points + ACROSS * work->width;
    int64_t count[GREY_LEVELS] = {0}, seen = 0, below = 0, level = 0;
    for (const int64_t *part = work->parts; part < work->parts + 4 * work->part_count; part += 4) {
        for (int64_t row = part[0]; row < part[1]; row += GREY_ROWS) {
            for (int64_t i = part[2]; i < part[3]; i += GREY_COLUMNS) {
                if (point_at[i] >= 0 && fabs(across[point_at[i]] - (double)row) <= BESIDE_LINE)
                    continue;
                count[(int64_t)(per_level * pixels[row * work->width + i])]++;
                seen++;
            }
        }
    }
    while (level < GREY_LEVELS - 1 && (double)(below += count[level]) < GREY_SHARE * (double)seen)
        level++;
    return (double)level / per_level;
}

/* Why `count` pieces are a line or none, by n peaks; those from NO_POINTS on are none. Fills work->length, their length as that of one
 * piece in shares of the picture's width, and work->evidence, the geometric mean of that and of the
 * share of columns that have a point, times their height. */
static int64_t OF(judge_line)(Workspace *work, int64_t count, int64_t n, double brightest)
{
    double height, clutter = 0;
    const int64_t points = count_points(work, count);
    int32_t *point_at = work->columns;
    const double columns = (double)points / (double)work->width;
    work->length = effective_length(work->pieces, count, &height) / (double)work->width;
    work->evidence = sqrt(work->length * columns) * height;
    if (!points)
        return NO_POINTS;
    const bool is_long = work->length >= LONG_LINE || columns >= MANY_COLUMNS;
    const double most = is_long ? MOST_CLUTTER : MOST_CLUTTER_SHORT;
    const double few = (1 - CLUTTER_SHARE) * (double)work->width;
    /* a point that was fitted has a peak, which is no clutter; one between flanks may have none */
    if ((double)(n - points + work->flanks) <= few && columns >= MANY_COLUMNS)
        return AS_NO_RIVAL;
    list_points(work, count, point_at);
    /* in a gap, the line's own peaks are no clutter */
    bridge_gaps(work, count, work->levels);
    if ((double)find_clutter(work, n, point_at, work->levels) > few)
        clutter = clutter_level(work, point_at, 0, work->width, height);
    if (columns >= MANY_COLUMNS && clutter < NEARLY_ALONE)
        return AS_ALONE;
    const double grey = OF(grey_below)(work, point_at, brightest);
    if (work->length >= MOST_OF_PICTURE && height > HARDLY_ABOVE_GREY * grey)
        return AS_LONG;
    if (is_long && columns >= NEARLY_ALL_COLUMNS && height >= ABOVE_GREY * grey &&
        clutter_below(work, height) < NEARLY_ALONE)
        return AS_WIDE;
    if (height >= IN_THE_DARK * grey && clutter <= CLUTTER_IN_THE_DARK &&
        work->length * (double)work->width >= POINTS_IN_THE_DARK)
        return AS_DARK;
    if (clutter > most)
        return NO_CLUTTERED;
    return height >= (is_long ? ABOVE_GREY : ABOVE_GREY_SHORT) * grey ? AS_BRIGHT : NO_DIM;
}
