/* Step 12: what the points of a line scatter by beyond the noise of the pixels.
 *
 * Speckle shifts the light itself and is alike in neighbouring columns, so it shows only between
 * points some columns apart: the fourth difference over such lags of a smooth surface is noise
 * alone. Its median is robust to steps and texture. */

/* Columns between which laser speckle has become independent. */
enum { SPECKLE_LAG = 6 };
static const double FOURTH = 70.0; /* the sum of a fourth difference's squared factors */
static const double MEDIAN_OF_SQUARE = 0.4549; /* of a standard normal deviate */
/* The standard deviation of such a median of n, times the root of n, in shares of itself. */
static const double CHANCE = 2.33;
static const double LEAST_SPECKLE = 1e-12; /* px squared, to begin a search with */
static const double LEAST_SHARE_OF_KNOWN = 1e-3; /* of the variances, to end a search with */
enum { FEWEST_DIFFERENCES = 30, HALVINGS = 9 };

/* How many squares lie below the median that they would have with so much speckle. */
static int64_t number_below(const double *squares, const double *known, int64_t n, double excused,
                            double speckle)
{
    int64_t below = 0;
    for (int64_t i = 0; i < n; i++)
        below += squares[i] < MEDIAN_OF_SQUARE * (excused * known[i] + FOURTH * speckle);
    return below;
}

/* Fills the squared fourth differences of points (n) in ascending order of columns over a lag, and
 * the sums of known variances that they have; returns how many are not over a gap, 0 for too few.
 *
 * squares, known (n - 4 lag). */
static int64_t fourth_differences(const double *along, const double *across,
                                  const double *variance, int64_t n, int64_t lag, double *squares,
                                  double *known)
{
    int64_t found = 0;
    for (int64_t i = 0; i < n - 4 * lag; i++) {
        int64_t j = i + lag, k = i + 2 * lag, l = i + 3 * lag, m = i + 4 * lag;
        bool whole = along[m] - along[i] == 4 * lag;
        double fourth = across[i] + across[m] - 4 * (across[j] + across[l]) + 6 * across[k];
        double own = variance[i] + 16 * (variance[j] + variance[l]) + variance[m];
        own += 36 * variance[k];
        /* over a gap there is no difference; it is never below anything */
        squares[i] = whole ? fourth * fourth : INFINITY;
        known[i] = whole ? own : 0.0;
        found += whole;
    }
    return found < FEWEST_DIFFERENCES ? 0 : found;
}

/* What such squares show beyond the known variances, in px squared; of n, of which `found` are not
 * over a gap. */
static double search_speckle(const double *squares, const double *known, int64_t n, int64_t found)
{
    double total = 0.0;
    for (int64_t i = 0; i < n; i++)
        total += known[i];
    double low = 0.0, high = max_f64(total / (double)found / FOURTH, LEAST_SPECKLE);
    while (high < INFINITY && 2 * number_below(squares, known, n, 1.0, high) < found) {
        low = high;
        high = 4 * high;
    }
    for (int i = 0; i < HALVINGS; i++) {
        double middle = 0.5 * (low + high);
        if (2 * number_below(squares, known, n, 1.0, middle) >= found)
            high = middle;
        else
            low = middle;
    }
    return 0.5 * (low + high);
}

/* The share of the known variances that such squares show, where that is less than 1. */
static double search_share(const double *squares, const double *known, int64_t n, int64_t found)
{
    double low = LEAST_SHARE_OF_KNOWN, high = 1.0;
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = sqrt(low * high);
        if (2 * number_below(squares, known, n, middle, 0.0) >= found)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* What points (n) in ascending order of columns scatter by beyond known variances, in px squared.
 *
 * share: if given, what they scatter by less than them in shares of them; else it is 1. Where a
 * line is no bell, what the fits leave looks like noise and is none: it is alike in all columns.
 * lag: columns apart at which the scatter is independent.
 * alike: neighbours that share their noise, so that fewer points are independent; what their
 * median may differ from the known variance by in chance is none.
 * workspace (2 n). */
static double speckle_variance(const double *along, const double *across, const double *variance,
                               int64_t n, int64_t lag, int64_t alike, double *workspace,
                               double *share)
{
    double *squares = workspace, *known = workspace + n;
    const int64_t found = fourth_differences(along, across, variance, n, lag, squares, known);
    if (share)
        *share = 1.0;
    if (!found)
        return 0.0;
    n -= 4 * lag;
    const double excused = 1 + CHANCE * sqrt((double)alike / (double)found);
    if (2 * number_below(squares, known, n, excused, 0.0) < found)
        return search_speckle(squares, known, n, found);
    /* never less than chance may have made it */
    const double doubt = 1 + CHANCE * sqrt(max_f64((double)alike, 1) / (double)found);
    if (share && 2 * number_below(squares, known, n, 1 / doubt, 0.0) >= found)
        *share = min_f64(doubt * search_share(squares, known, n, found), 1.0);
    return 0.0;
}

EXPORT(double, speckle_variance)(int64_t n, const double *along, const double *across,
                                 const double *variance, double *workspace, int64_t lag,
                                 int64_t alike)
{
    return speckle_variance(along, across, variance, n, lag, alike, workspace, NULL);
}
