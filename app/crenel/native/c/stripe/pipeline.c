/* A frame's way from pixels to points. Included with BITS defined. */
#include "pixel.h"

#ifndef CRENEL_STRIPE_PIPELINE
#define CRENEL_STRIPE_PIPELINE
/* A peak stands out of the noise by this many standard deviations of its score; what noise passes
 * makes no run. The variance of a score, in those of a pixel. */
static const double STANDS_OUT = 4, SCORE_VARIANCE = 7.0 / 12;
/* Rows about some peaks that show the usual width; rows about a peak, by that width. */
enum { USUAL_REACH = 20 };
static const float REACH_SIGMAS = 3.6f, REACH_MORE = 4;
/* Steps of a fit, and of one that needs more of everything. */
enum { STEPS = 3, MORE_STEPS = 30 };
/* The gain before it is known: grey levels squared per level, of a full scale of 255. */
static const double FIRST_GAIN = 0.01 / 255;
/* Clipped pixels in a column from which on its flanks may say more than its core. */
enum { CLIPPED_CORE = 4 };

/* The median width of a block's started fits, as a standard deviation. */
static float usual_start(const Block *block)
{
    float some[BLOCK];
    int found = 0;
    for (int i = 0; i < BLOCK; i++)
        if (block->state[i] == PEAK)
            some[found++] = block->sigma[i];
    return found ? median_of(some, found) : 1;
}

/* The grey level at which pixels of 16 bits are clipped, by the brightest: the sensor's own depth
 * where that shows it (1023, 4095, ..., also shifted to the upper bits), else 65535. */
static float saturation_level(uint32_t brightest)
{
    if (brightest) {
        const uint32_t significant = brightest >> __builtin_ctz(brightest);
        if ((significant & (significant + 1)) == 0 && significant >= 0x100)
            return (float)brightest;
    }
    return 65535;
}

/* The most pixels that are clipped in one of n fitted peaks. */
static float most_clipped(const Workspace *work, int64_t n)
{
    const float *clipped = work->fits + CLIPPED * work->padded;
    float most = 0;
    for (int64_t i = 0; i < n; i++)
        most = max_f32(most, clipped[i]);
    return most;
}

/* Whether the operator says what the line is like, or where it is. */
static bool is_specified(const Workspace *work)
{
    return !isnan(work->threshold) || !isnan(work->narrowest_px) || !isnan(work->widest_px) ||
           work->allowed || work->rule != CONTINUITY;
}

/* What its mirror in Python must be as long as. */
EXPORT(int64_t, workspace_bytes)(void) { return (int64_t)sizeof(Workspace); }

/* What its field `clipped` must be as long as. */
EXPORT(int64_t, clipped_bytes)(int64_t width)
{
    Clipped clipped;
    return cut_clipped(&clipped, width, NULL);
}

/* Steps 11 and 12: the points (4, N) of n peaks that lie in runs, with their standard deviations; how many. */
static int64_t finish(Workspace *work, int64_t n, double saturated)
{
    const int64_t width = work->width;
    const double *peaks = work->peaks;
    double *points = work->points;
    const int64_t found = keep_long_runs(peaks + ALONG * width, peaks + ACROSS * width,
                                         peaks + BROAD * width, n, work->shortest_run, work->climb,
                                         work->rows);
    for (int row = ALONG; row <= UNSURE; row++)
        for (int64_t i = 0; i < found; i++)
            points[row * width + i] = peaks[row * width + work->rows[i]];
    for (int64_t i = 0; i < found; i++)
        points[HEIGHT * width + i] = min_f64(points[HEIGHT * width + i], saturated);
    double *unsure = points + UNSURE * width;
    double share;
    const double scatter = speckle_variance(points + ALONG * width, points + ACROSS * width, unsure,
                                            found, SPECKLE_LAG, 0, work->scratch, &share);
    for (int64_t i = 0; i < found; i++)
        unsure[i] = sqrt(share * unsure[i] + scatter);
    return found;
}
#endif

/* Starts a block of peaks evenly taken of n: the `number`-th of `count` such blocks. */
static void OF(sample)(Workspace *work, int64_t n, int number, int count, int reach,
                       float saturated)
{
    int32_t columns[BLOCK], rows[BLOCK];
    for (int64_t i = 0; i < BLOCK; i++) {
        const int64_t one = (i * count + number) * n / ((int64_t)count * BLOCK);
        columns[i] = work->columns[one];
        rows[i] = work->rows[one];
    }
    OF(gather)(work, columns, rows, BLOCK, reach, work->profiles[number]);
    start_fits(&work->blocks[number], work->profiles[number], reach, saturated);
}

/* Step 9: fills known[0..2] with the noise's terms and known[3] with the usual width. */
static void OF(estimate_noise)(Workspace *work, int64_t n, double read, float saturated,
                               float *known)
{
    const int count = n <= BLOCK ? 1 : NOISE_BLOCKS;
    int rows[NOISE_BLOCKS];
    OF(sample)(work, n, 0, count, USUAL_REACH, saturated);
    known[0] = (float)read;
    known[1] = (float)(FIRST_GAIN * saturated);
    known[2] = 0;
    known[3] = usual_start(work->blocks);
    const int reach = (int)min_f32(ceilf(REACH_SIGMAS * known[3] + REACH_MORE), WIDEST_REACH);
    for (int b = 0; b < count; b++) {
        /* the first was begun with enough rows for most widths */
        const int far = b == 0 && reach < USUAL_REACH ? USUAL_REACH : reach;
        if (b > 0 || far > USUAL_REACH)
            OF(sample)(work, n, b, count, far, saturated);
        set_windows(&work->blocks[b], work->profiles[b], far, saturated);
        rows[b] = 2 * far + 1;
    }
    learn_noise(work->blocks, (const Profile *)work->profiles, rows, count, saturated, known);
}

/* Steps 5 to 8 for up to BLOCK peaks; fills a table of fits. */
static void OF(fit_some)(Workspace *work, const int32_t *columns, const int32_t *rows, int64_t n,
                         int reach, float saturated, const float *noise, int steps, float *table,
                         int64_t row_length)
{
    OF(gather)(work, columns, rows, n, reach, work->profiles[0]);
    fit_block(work->blocks, work->profiles[0], reach, noise, saturated, steps);
    keep_fits(work->blocks, reach, table, row_length);
}

/* Fits those of n peaks again that needed more rows or more steps. */
static void OF(fit_wider)(Workspace *work, int64_t n, float saturated, const float *noise)
{
    const float *became = work->fits + BECAME * work->padded;
    float again[FIT_ROWS * BLOCK];
    int32_t which[BLOCK], columns[BLOCK], rows[BLOCK];
    for (int64_t i = 0; i < n;) {
        int found = 0;
        for (; i < n && found < BLOCK; i++) {
            if (became[i] == WIDER) {
                which[found] = (int32_t)i;
                columns[found] = work->columns[i];
                rows[found++] = work->rows[i];
            }
        }
        if (!found)
            return;
        OF(fit_some)(work, columns, rows, found, WIDEST_REACH, saturated, noise, MORE_STEPS, again,
                     BLOCK);
        for (int row = 0; row < FIT_ROWS; row++)
            for (int k = 0; k < found; k++)
                work->fits[row * work->padded + which[k]] = again[row * BLOCK + k];
    }
}

/* Steps 5 to 10 for the n columns chosen: fills the table of peaks; returns how many there are. */
static int64_t OF(fit_peaks)(Workspace *work, int64_t n, double read, double threshold,
                             float saturated, float *known)
{
    if (n == 0)
        return 0;
    OF(move_to_brightest)(work, n);
    if (!(known[0] > 0))
        OF(estimate_noise)(work, n, read, saturated, known);
    const int reach = (int)min_f32(ceilf(REACH_SIGMAS * known[3] + REACH_MORE), WIDEST_REACH);
    for (int64_t b = 0; b < n; b += BLOCK)
        OF(fit_some)(work, work->columns + b, work->rows + b, min_i64(BLOCK, n - b), reach,
                     saturated, known, STEPS, work->fits + b, work->padded);
    OF(fit_wider)(work, n, saturated, known);
    return sift(work, n, threshold, saturated);
}

/* Finds the clipped cores that may be the line's, in all parts; returns how many. */
static int64_t OF(find_cores)(Workspace *work, Clipped *clipped, float saturated)
{
    cut_clipped(clipped, work->width, work->clipped);
    OF(find_runs)(work, clipped, (PIXEL)saturated);
    take_cores(clipped);
    return drop_short_tracks(clipped);
}

/* The same alone; fills the cores' columns, first and last rows (3, width). */
EXPORT(int64_t, OF(find_cores))(int64_t width, Workspace *work, double saturated, int32_t *cores)
{
    Clipped clipped;
    const int64_t n = OF(find_cores)(work, &clipped, (float)saturated);
    memcpy(cores, clipped.column, (size_t)n * sizeof *cores);
    memcpy(cores + width, clipped.first, (size_t)n * sizeof *cores);
    memcpy(cores + 2 * width, clipped.last, (size_t)n * sizeof *cores);
    return n;
}

/* Steps 5 to 10 for the columns that hold no core; returns how many peaks there are. */
static int64_t OF(fit_beside)(Workspace *work, const Clipped *clipped, double read,
                              double threshold, float saturated)
{
    float known[4] = {0}; /* of these peaks alone: the next frame may have others */
    const int64_t chosen = list_chosen(work, clipped->column, clipped->cores);
    return OF(fit_peaks)(work, chosen, read, threshold, saturated, known);
}

/* The points of a line that is clipped in some columns, and placed by its flanks there. */
static int64_t OF(place_by_flanks)(Workspace *work, Clipped *clipped, double read,
                                   double threshold, float saturated)
{
    const double *along = work->peaks + ALONG * work->width;
    const double *across = work->peaks + ACROSS * work->width;
    const int64_t cores = clipped->cores;
    int64_t found = OF(fit_beside)(work, clipped, read, threshold, saturated);
    if (select_cores(clipped, along, across, found, work->shortest_run) < cores)
        found = OF(fit_beside)(work, clipped, read, threshold, saturated);
    if (clipped->cores == 0)
        return finish(work, found, saturated);
    work->core_rows = clipped->core_width;
    work->climb = max_f64(work->climb, core_climb(clipped->core_width));
    clipped->flanks = 0;
    if (OF(read_flanks)(clipped, work->pixels, work->height, saturated))
        fit_flanks(clipped, saturated, read);
    work->half_fall = clipped->flanks ? clipped->half_fall : 0;
    found = join_flanks(clipped, work->peaks, found, saturated, work->shortest_run, work->points,
                        work->width);
    work->flanks = clipped->flanks;
    return found;
}

/* Steps 5 to 12: fills the points for the peaks chosen; returns how many. */
static int64_t OF(place_points)(Workspace *work, double read, double threshold, float saturated,
                                bool overexposed)
{
    int64_t chosen, found = 0;
    work->is_clipped = false;
    work->core_rows = work->half_fall = 0;
    work->flanks = 0;
    if (!overexposed) {
        chosen = list_chosen(work, NULL, 0);
        found = OF(fit_peaks)(work, chosen, read, threshold, saturated, work->known);
    }
    if (overexposed || most_clipped(work, chosen) >= CLIPPED_CORE) {
        Clipped clipped;
        work->is_clipped = OF(find_cores)(work, &clipped, saturated) > 0;
        if (work->is_clipped)
            return OF(place_by_flanks)(work, &clipped, read, threshold, saturated);
    }
    if (overexposed) {
        chosen = list_chosen(work, NULL, 0);
        found = OF(fit_peaks)(work, chosen, read, threshold, saturated, work->known);
    }
    return finish(work, found, saturated);
}

/* Fills the points (4, N) of the stripe in a frame: along, across, height, standard deviation.
 * Returns how many. */
EXPORT(int64_t, OF(extract))(Workspace *work)
{
    PIXEL brightest;
    const PIXEL highest_core = OF(search)(work, &brightest);
    const float full = BITS == 8 ? 255 : saturation_level(brightest);
    /* after the search, which has fetched the pixels */
    const double read = work->known[0] > 0 ? work->known[0] : OF(read_noise)(work);
    const double threshold =
        isnan(work->threshold) ? STANDS_OUT * sqrt(SCORE_VARIANCE * read) : work->threshold;
    const int64_t peaks = OF(list_peaks)(work, threshold);
    const bool linked = choose_peaks(work, peaks);
    const float saturated = OF(clipping_level)(work, full);
    work->saturated = saturated;
    const int64_t found =
        OF(place_points)(work, read, threshold, saturated, highest_core >= saturated);
    int64_t pieces = list_pieces(work, found);
    work->left = 0;
    if (work->rule == CONTINUITY)
        pieces = keep_line(work, pieces, peaks, linked);
    work->decision = OF(judge_line)(work, pieces, peaks, BITS == 8 ? 255 : brightest);
    const int64_t points = count_points(work, pieces);
    if (work->decision < NO_POINTS || is_specified(work)) {
        list_reasons(work, pieces);
        return points;
    }
    leave_points(work, 0, points, LEFT_NO_LINE);
    work->evidence = 0;
    return 0;
}
