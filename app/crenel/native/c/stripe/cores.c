/* A clipped line, step 2: which runs of clipped pixels are the core of the line.
 *
 * Runs that follow one another from column to column make a track. Of several runs in a column,
 * the one of the longest track counts. A track is the line's if it is several times as long as
 * wide, and longer than all that is not clipped, or begins or ends where that ends or begins. */

enum {
    TRACK_SKIP = 3,  /* columns that a track may skip */
    LONG_CORE = 4,  /* its least length in widths of its core */
    JOINING = 8      /* columns within which a piece goes on where the rest of the line ends */
};
/* Rows by which a track may climb from one column to the next; the share of its columns that are
 * clipped; widths of its cores, in shares of the usual one. */
static const double TRACK_CLIMB = 4.0, RAGGED = 0.15, DENSE_TRACK = 0.7, NARROW_CORE = 0.45, WIDE_CORE = 2.2;

/* Rows by which the middle of a core so wide may climb from one column to the next: its edges are
 * as ragged as the light that the surface scatters. */
static double core_climb(double rows) { return TRACK_CLIMB + RAGGED * rows; }

/* The run before this one that it follows, or -1: the nearest of the last columns that has one. */
static int64_t run_before(const Clipped *c, int64_t column, double middle)
{
    for (int64_t back = 1; back <= min_i64(TRACK_SKIP, column); back++) {
        double nearest = INFINITY;
        int64_t found = -1, begin = (column - back) * RUNS;
        for (int64_t r = begin; r < begin + c->runs[column - back]; r++) {
            double climb = fabs(middle - 0.5 * (c->run_first[r] + c->run_last[r]));
            double most = core_climb(c->run_last[r] - c->run_first[r] + 1) * (double)back;
            if (climb <= most && climb < nearest) {
                nearest = climb;
                found = r;
            }
        }
        if (found >= 0)
            return found;
    }
    return -1;
}

/* Numbers the runs so that those that follow one another share a track; fills the lengths. */
static void link_runs(Clipped *c)
{
    int32_t tracks = 0;
    for (int64_t i = 0; i < c->width; i++) {
        for (int64_t r = i * RUNS; r < i * RUNS + c->runs[i]; r++) {
            int64_t before = run_before(c, i, 0.5 * (c->run_first[r] + c->run_last[r]));
            int32_t track = before < 0 ? tracks++ : c->run_track[before];
            if (before < 0)
                c->length[track] = 0;
            c->run_track[r] = track;
            c->length[track]++;
        }
    }
}

/* The usual width of the cores in px: their median. */
static double usual_core(const Clipped *c)
{
    int64_t count[WIDEST_CORE + 1] = {0}, below = 0, middle = (c->cores - 1) / 2;
    int lower = -1, upper = 0;
    for (int64_t i = 0; i < c->cores; i++)
        count[c->last[i] - c->first[i] + 1]++;
    for (; upper <= WIDEST_CORE; upper++) {
        below += count[upper];
        if (lower < 0 && below > middle)
            lower = upper;
        if (2 * below > c->cores)
            break;
    }
    return 0.5 * (lower + upper);
}

/* Keeps the cores whose track has a length; counts again, and notes where tracks begin and end. */
static void keep_tracks(Clipped *c)
{
    int64_t n = 0;
    for (int64_t i = 0; i < c->cores; i++) {
        if (c->length[c->track[i]]) {
            c->column[n] = c->column[i];
            c->first[n] = c->first[i];
            c->last[n] = c->last[i];
            c->track[n++] = c->track[i];
        }
    }
    c->cores = n;
    for (int64_t i = n - 1; i >= 0; i--) {
        c->length[c->track[i]] = 0;
        c->opens[c->track[i]] = (int32_t)i;
    }
    for (int64_t i = 0; i < n; i++) {
        c->length[c->track[i]]++;
        c->closes[c->track[i]] = (int32_t)i;
    }
}

/* Of every column's runs, takes the one of the longest track; returns how many there are. */
static int64_t take_cores(Clipped *c)
{
    link_runs(c);
    c->cores = 0;
    for (int64_t i = 0; i < c->width; i++) {
        int64_t best = i * RUNS;
        for (int64_t r = best + 1; r < i * RUNS + c->runs[i]; r++)
            if (c->length[c->run_track[r]] > c->length[c->run_track[best]])
                best = r;
        if (c->runs[i]) {
            c->column[c->cores] = (int32_t)i;
            c->first[c->cores] = c->run_first[best];
            c->last[c->cores] = c->run_last[best];
            c->track[c->cores++] = c->run_track[best];
        }
    }
    c->core_width = usual_core(c);
    return c->cores;
}

/* Drops what is hardly overexposed, whatever lies beside it; returns how many cores are left.
 *
 * There the peak is found by what is beside the clipped pixels. */
static int64_t drop_short_tracks(Clipped *c)
{
    keep_tracks(c);
    for (int64_t i = 0; i < c->cores; i++) {
        int32_t track = c->track[i], columns = c->length[track];
        if (i != c->opens[track])
            continue;
        int span = c->column[c->closes[track]] - c->column[i] + 1;
        if (columns < max_f64(DENSE_TRACK * span, LONG_CORE * c->core_width))
            c->length[track] = 0;
    }
    keep_tracks(c);
    return c->cores >= FEWEST_COLUMNS ? c->cores : (c->cores = 0);
}

/* Whether the line's unclipped points go on near the end of a track. */
static bool goes_on(const Clipped *c, int64_t end, const double *along, const double *across,
                    const int32_t *runs, int64_t n)
{
    double column = c->column[end], middle = 0.5 * (c->first[end] + c->last[end]);
    for (int64_t k = 0; k < n; k++) {
        double gap = fabs(along[runs[k]] - column);
        if (gap <= JOINING && fabs(across[runs[k]] - middle) <= TRACK_CLIMB * gap)
            return true;
    }
    return false;
}

/* Keeps the cores of the line, not those of a highlight beside it; returns how many there are.
 *
 * along, across (n): the peaks beside the cores; shortest: points that make a piece of line. */
static int64_t select_cores(Clipped *c, const double *along, const double *across, int64_t n,
                            int64_t shortest)
{
    int64_t unclipped = keep_long_runs(along, across, NULL, n, shortest, STEEPEST, c->kept);
    for (int64_t i = 0; i < c->cores; i++) {
        int32_t track = c->track[i];
        if (i == c->opens[track] && c->length[track] < unclipped &&
            !goes_on(c, i, along, across, c->kept, unclipped) &&
            !goes_on(c, c->closes[track], along, across, c->kept, unclipped))
            c->length[track] = 0;
    }
    keep_tracks(c);
    int64_t found = 0;
    for (int64_t i = 0; i < c->cores; i++) {
        int width = c->last[i] - c->first[i] + 1;
        if (width <= NARROW_CORE * c->core_width || width >= WIDE_CORE * c->core_width)
            continue;
        c->column[found] = c->column[i];
        c->first[found] = c->first[i];
        c->last[found++] = c->last[i];
    }
    c->cores = found >= FEWEST_COLUMNS ? found : 0;
    if (c->cores)
        c->core_width = usual_core(c);
    return c->cores;
}
