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
/* A line over most of the picture may have any clutter, and be hardly higher than the grey. */
static const double MOST_OF_PICTURE = 0.6, HARDLY_ABOVE_GREY = 0.95;
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

/* Whether `count` pieces are a line, by n peaks. Fills work->length, their length as that of one
 * piece in shares of the picture's width, and work->evidence, the geometric mean of that and of the
 * share of columns that have a point, times their height. */
static bool OF(is_line)(Workspace *work, int64_t count, int64_t n, double brightest)
{
    double height, clutter = 0;
    const int64_t points = count_points(work, count);
    int32_t *point_at = work->columns;
    const double columns = (double)points / (double)work->width;
    work->length = effective_length(work->pieces, count, &height) / (double)work->width;
    work->evidence = sqrt(work->length * columns) * height;
    if (!points)
        return false;
    const bool is_long = work->length >= LONG_LINE || columns >= MANY_COLUMNS;
    const double most = is_long ? MOST_CLUTTER : MOST_CLUTTER_SHORT;
    const double few = (1 - CLUTTER_SHARE) * (double)work->width;
    /* a point that was fitted has a peak, which is no clutter; one between flanks may have none */
    if ((double)(n - points + work->flanks) <= few && columns >= MANY_COLUMNS)
        return true;
    list_points(work, count, point_at);
    /* in a gap, the line's own peaks are no clutter */
    bridge_gaps(work, count, work->levels);
    if ((double)find_clutter(work, n, point_at, work->levels) > few)
        clutter = clutter_level(work, point_at, 0, work->width, height);
    if (columns >= MANY_COLUMNS && clutter < NEARLY_ALONE)
        return true;
    const double grey = OF(grey_below)(work, point_at, brightest);
    if (work->length >= MOST_OF_PICTURE && height > HARDLY_ABOVE_GREY * grey)
        return true;
    return clutter <= most && height >= (is_long ? ABOVE_GREY : ABOVE_GREY_SHORT) * grey;
}
