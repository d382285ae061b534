/* A clipped line, step 8: the line's points, clipped and not, in runs only. */

/* Where most of the line is clipped, points dimmer than this share of it are none of it. */
static const double DIM = 0.25;
/* Flanks that fall to half over fewer rows are seen by too few pixels: errors by their phase go on
 * along a line that is nearly parallel to the rows, and no scatter shows them. */
static const double LEAST_FALL = 2;

/* The table of peaks or of points: its rows, `stride` long each. */
typedef struct {
    double *along, *across, *height, *unsure;
} PointTable;

static PointTable table_of(double *table, int64_t stride)
{
    return (PointTable){table, table + stride, table + 2 * stride, table + 3 * stride};
}

/* Keeps the peaks that are high enough; returns how many. */
static int64_t keep_high(PointTable peaks, int64_t n, double least)
{
    int64_t kept = 0;
    for (int64_t i = 0; i < n; i++) {
        if (peaks.height[i] <= least)
            continue;
        peaks.along[kept] = peaks.along[i];
        peaks.across[kept] = peaks.across[i];
        peaks.height[kept] = peaks.height[i];
        peaks.unsure[kept++] = peaks.unsure[i];
    }
    return kept;
}

/* Merges n peaks and the flanks by columns: a source of n and more is a flank. */
static int64_t merge(Clipped *c, PointTable peaks, int64_t n)
{
    int64_t found = 0, i = 0, j = 0;
    while (i < n || j < c->flanks) {
        double peak = i < n ? peaks.along[i] : INFINITY;
        double flank = j < c->flanks ? c->flank_column[j] : INFINITY;
        bool clipped = flank <= peak;
        c->along[found] = clipped ? flank : peak;
        c->across[found] = clipped ? c->centre[j] : peaks.across[i];
        c->source[found++] = (int32_t)(clipped ? n + j : i);
        i += peak <= flank;
        j += clipped;
    }
    return found;
}

/* Keeps those of the merged points that lie in runs; of their flanks, too. Returns how many. */
static int64_t keep_runs(Clipped *c, int64_t found, int64_t n, int64_t shortest)
{
    int64_t kept = keep_long_runs(c->along, c->across, NULL, found, shortest,
                                  core_climb(c->core_width), c->kept);
    c->flanks = 0;
    for (int64_t i = 0; i < kept; i++) {
        int64_t j = c->source[c->kept[i]] - n, to = c->flanks;
        c->source[i] = c->source[c->kept[i]];
        if (j < 0)
            continue;
        c->flank_column[to] = c->flank_column[j];
        c->centre[to] = c->centre[j];
        c->by_noise[to] = c->by_noise[j];
        c->by_surface[to] = c->by_surface[j];
        c->source[i] = (int32_t)(n + c->flanks++);
    }
    return kept;
}

/* What the unclipped points scatter by beyond the noise, in px squared. */
static double speckle_beside(Clipped *c, PointTable peaks, int64_t kept, int64_t n)
{
    double *variance = c->mean;
    int64_t rest = 0;
    for (int64_t i = 0; i < kept; i++) {
        int64_t k = c->source[i];
        if (k >= n)
            continue;
        c->along[rest] = peaks.along[k];
        c->across[rest] = peaks.across[k];
        variance[rest++] = peaks.unsure[k];
    }
    return speckle_variance(c->along, c->across, variance, rest, SPECKLE_LAG, 0, c->workspace, NULL);
}

/* What the smoothed clipped points scatter by. Those that share no column are as far apart as the
 * core is wide.
 *
 * share: of their variances by noise, what they scatter by where that is less: flanks of another
 * shape than the fit's leave what looks like noise. Two brightnesses shift neighbours alike, so
 * that no scatter shows it. */
static double speckle_of_flanks(Clipped *c, double *share)
{
    double *variance = c->mean;
    int64_t lag = (int64_t)c->core_width + 1;
    for (int64_t i = 0; i < c->flanks; i++) {
        c->along[i] = c->flank_column[i];
        variance[i] = c->by_noise[i] + c->by_surface[i];
    }
    const double rough =
        speckle_variance(c->along, c->centre, variance, c->flanks, lag, lag, c->workspace, NULL);
    *share = 1.0;
    if (rough == 0 && c->half_fall >= LEAST_FALL)
        speckle_variance(c->along, c->centre, c->by_noise, c->flanks, lag, lag, c->workspace, share);
    return rough;
}

/* Joins n peaks beside the cores and the flanks; fills the points; returns how many there are.
 *
 * peaks, points: rows of `stride`: columns, rows, heights, variances (of points, deviations);
 * peaks are reordered. */
static int64_t join_flanks(Clipped *c, double *peak_table, int64_t n, double saturated,
                           int64_t shortest, double *points_table, int64_t stride)
{
    PointTable peaks = table_of(peak_table, stride), points = table_of(points_table, stride);
    if (c->flanks > n)
        n = keep_high(peaks, n, DIM * saturated);
    int64_t kept = keep_runs(c, merge(c, peaks, n), n, shortest);
    double scatter = speckle_beside(c, peaks, kept, n), rough = 0.0, share = 1.0;
    if (c->flanks) {
        smooth_flanks(c);
        rough = speckle_of_flanks(c, &share);
        /* a few points between clipped ones lie on the same rough surface */
        scatter = max_f64(scatter, rough);
    }
    for (int64_t i = 0; i < kept; i++) {
        int64_t k = c->source[i], j = k - n;
        points.along[i] = j < 0 ? peaks.along[k] : c->flank_column[j];
        points.across[i] = j < 0 ? peaks.across[k] : c->centre[j];
        points.height[i] = j < 0 ? min_f64(peaks.height[k], saturated) : saturated;
        points.unsure[i] = sqrt(j < 0 ? peaks.unsure[k] + scatter
                                      : share * c->by_noise[j] + c->by_surface[j] + rough);
    }
    return kept;
}
