/* How the points of straight lines scatter: beyond what they say, and alike as neighbours. */

/* Likeness of neighbours is looked for in no fewer points, up to so far along the line, in no
 * fewer pairs, until so little of it is left. */
enum { FEWEST_POINTS = 50, LAGS = 20, FEWEST_PAIRS = 30 };
static const double LEFT = 0.05;

static double mean_of(const double *values, int64_t n)
{
    double total = 0.0;
    for (int64_t i = 0; i < n; i++)
        total += values[i];
    return total / (double)n;
}

/* How many neighbouring points carry the information of one: 1 for white noise.
 *
 * The sum of the residuals' autocorrelation up to where it has died away. uv (n, 2), px;
 * residuals (n) over their deviations. */
static double neighbours_alike(const double *uv, const double *residuals, int64_t n)
{
    if (n < FEWEST_POINTS)
        return 1.0;
    double mean = mean_of(residuals, n), power = 0.0, sum = 1.0;
    for (int64_t i = 0; i < n; i++)
        power += (residuals[i] - mean) * (residuals[i] - mean);
    power /= (double)n;
    for (int64_t lag = 1; lag < LAGS && power > 0.0; lag++) {
        double products = 0.0, reach = 2.0 * (double)lag + 1.0;
        int64_t pairs = 0;
        for (int64_t i = lag; i < n; i++) {
            double du = uv[2 * i] - uv[2 * (i - lag)], dv = uv[2 * i + 1] - uv[2 * (i - lag) + 1];
            if (du * du + dv * dv < reach * reach) {
                pairs++;
                products += (residuals[i] - mean) * (residuals[i - lag] - mean);
            }
        }
        if (pairs < FEWEST_PAIRS || products < LEFT * power * (double)pairs)
            break;
        sum += 2 * products / ((double)pairs * power);
    }
    return sum;
}

EXPORT(double, neighbours_alike)(int64_t n, const double *uv, const double *residuals)
{
    return neighbours_alike(uv, residuals, n);
}

/* Variance (n) of each line's points beside what they say: at least 1, 1 where too few.
 *
 * order (n): the rows with those of one line together; line, kept, off (n) and places (n, 2): each
 * row's line, whether it counts, its residual over its deviation, its pixel. about_mean: whether
 * what all points of a line share is no scatter; fewest: points that give a line's scatter.
 * workspace (3, n). */
EXPORT(void, variances_of_lines)(int64_t n, const int64_t *order, const int64_t *line,
                                 const bool *kept, const double *off, const double *places,
                                 int64_t about_mean, int64_t fewest, double *variances,
                                 double *workspace)
{
    double *own = workspace, *uv = workspace + n;
    for (int64_t begin = 0, end; begin < n; begin = end) {
        int64_t count = 0;
        for (end = begin; end < n && line[order[end]] == line[order[begin]]; end++) {
            int64_t row = order[end];
            if (!kept[row])
                continue;
            own[count] = off[row];
            uv[2 * count] = places[2 * row];
            uv[2 * count + 1] = places[2 * row + 1];
            count++;
        }
        double variance = 1.0;
        if (count >= fewest) {
            double mean = about_mean ? mean_of(own, count) : 0.0, total = 0.0;
            for (int64_t i = 0; i < count; i++)
                total += (own[i] - mean) * (own[i] - mean);
            variance = max_f64(total / (double)count, 1.0) * neighbours_alike(uv, own, count);
        }
        for (int64_t i = begin; i < end; i++)
            variances[order[i]] = variance;
    }
}
