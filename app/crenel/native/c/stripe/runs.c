/* Step 11: which points make a line: those that lie in a run of neighbours that is long enough. */

enum { LARGEST_GAP = 3 };          /* columns that a run may skip */
static const double STEEPEST = 4.0; /* rows by which it may climb, where no scale is in question */
/* A piece that is as long as a round spot of its width shows is none of a line, in standard
 * deviations of its width. */
static const double ROUND = 6.0;

/* Whether a run goes on over a gap of columns with a rise in rows, where it may climb by so many. */
static bool run_goes_on(double gap, double rise, double climb)
{
    return gap <= LARGEST_GAP && fabs(rise) <= climb * gap;
}

/* Fills `kept` with the indices of the points in long runs, in ascending order; their number.
 *
 * along, across (n) in ascending order of columns; sigma (n) are the standard deviations of the
 * peaks' widths, or NULL where no run is as short as a round spot; climb: rows by which a run may
 * climb from one column to the next. */
static int64_t keep_long_runs(const double *along, const double *across, const double *sigma,
                              int64_t n, int64_t shortest, double climb, int32_t *kept)
{
    int64_t found = 0, begin = 0;
    for (int64_t i = 1; i <= n; i++) {
        if (i < n && run_goes_on(along[i] - along[i - 1], across[i] - across[i - 1], climb))
            continue;
        double length = (double)(i - begin), width = 0.0;
        for (int64_t j = begin; sigma && j < i; j++)
            width += sigma[j];
        if (i - begin >= shortest && length * length >= ROUND * width)
            for (int64_t j = begin; j < i; j++)
                kept[found++] = (int32_t)j;
        begin = i;
    }
    return found;
}

EXPORT(int64_t, keep_long_runs)(int64_t n, const double *along, const double *across,
                                const double *sigma, int64_t shortest, double climb, int32_t *kept)
{
    return keep_long_runs(along, across, sigma, n, shortest, climb, kept);
}
