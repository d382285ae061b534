/* The place of a step of brightness, from the pixels about it, by least squares.
 *
 * The model is a step blurred by a Gaussian, between two slopes: b + c x + (a + d x) F +
 * d sigma^2 f, with F and f the Gaussian's integral and density at x, the distance from the edge.
 * The unknowns are a state of six: b, a, c, d, the edge's offset, sigma. */

enum { STEP_HEIGHT = 1, STEP_OFFSET = 4, STEP_BLUR = 5, STEP_SIZE = 6 };
enum { STEP_COLUMNS = STEP_SIZE + 1, STEP_TURNS = 10 };
static const double LEAST_VARIANCE = 1.0 / 12.0; /* rounding alone scatters the pixels so */
static const double SINGULAR = 1e-12; /* what the others leave of an equation that says nothing */
static const double FURTHEST = 0.6;   /* share of the window that an edge may lie from its middle */
static const double LEAST_BLUR = 0.2, BLUR_SHRINKS = 0.6, BLUR_GROWS = 1.6;
static const double STEP_SETTLED_PX = 1e-4, STEP_SETTLED_BLUR = 1e-3;
static const double PLAIN_SIGMAS = 9.0; /* beyond, the Gaussian is as there */

/* The Gaussian's integral and its density at every so much of its standard deviation, from
 * -PLAIN_SIGMAS on. */
typedef struct {
    const double *integral, *density;
    double per_sigma, apart; /* how many there are to a standard deviation, and its inverse */
} GaussianNodes;

typedef double StepVector[STEP_SIZE];
typedef double StepMatrix[STEP_SIZE][STEP_SIZE];
/* Products of columns, their lower half: the residuals' squares, J^T r and J^T J. */
typedef double Products[STEP_COLUMNS][STEP_COLUMNS];

/* Integral and density of the unit Gaussian at z: Taylor's series about the nearest node, good to
 * 1e-14. Without a branch or a call, so that the processor does several at a time. */
static inline void gaussian(double z, GaussianNodes at, double *integral, double *density)
{
    const double edge = PLAIN_SIGMAS - 0.001;
    double inside = min_f64(max_f64(z, -edge), edge);
    int32_t node = (int32_t)((inside + PLAIN_SIGMAS) * at.per_sigma + 0.5);
    double x = node * at.apart - PLAIN_SIGMAS, d = inside - x;
    double F = at.integral[node], f = at.density[node];
    /* Hermite's polynomials: the density's derivatives over the density */
    double h2 = x * x - 1.0, h3 = x * (x * x - 3.0), h4 = x * x * (x * x - 6.0) + 3.0;
    double third = h2 * (1.0 / 6) + d * (h3 * (-1.0 / 24) + d * h4 * (1.0 / 120));
    *integral = F + f * d * (1.0 + d * (x * (-1.0 / 2) + d * third));
    third = h2 * (1.0 / 2) + d * (h3 * (-1.0 / 6) + d * h4 * (1.0 / 24));
    *density = f * (1.0 + d * (-x + d * third));
}

/* Fills distance across the edge and grey level of each pixel in the window; how many there are, 0
 * where one of them is hidden or out of the picture.
 *
 * place (4): u, v, normal; window (3): how far it reaches along the normal, against it, and along
 * the edge to either side; reach: of the square about it. */
static int64_t window_pixels(const double *image, int64_t height, int64_t width,
                             const double *place, const double *window, int64_t reach,
                             double *across, double *grey)
{
    double nu = place[2], nv = place[3];
    double side = 2.0 * (double)reach;
    double top = rint(place[1]) - (double)reach, left = rint(place[0]) - (double)reach;
    if (!(top >= 0 && left >= 0 && top + side < (double)height && left + side < (double)width))
        return 0;
    int64_t row0 = (int64_t)top, col0 = (int64_t)left, count = 0;
    for (int64_t row = row0; row <= row0 + 2 * reach; row++) {
        const double *line = image + row * width;
        double dv = (double)row - place[1];
        for (int64_t col = col0; col <= col0 + 2 * reach; col++) {
            double du = (double)col - place[0], away = du * nu + dv * nv;
            if (away > window[0] || away < -window[1] || fabs(dv * nu - du * nv) > window[2])
                continue;
            if (isnan(line[col]))
                return 0;
            across[count] = away;
            grey[count++] = line[col];
        }
    }
    return count;
}

/* Fills the columns (7, most): the pixels' residuals and their derivatives by the state; zeros
 * behind them, up to a whole number of DOUBLES. */
static void fill_columns(const double *restrict across, const double *restrict grey, int64_t count,
                         const double *state, GaussianNodes nodes, double *restrict columns,
                         int64_t most)
{
    double b = state[0], a = state[1], c = state[2], d = state[3], offset = state[4];
    double sigma = state[5], per_sigma = 1.0 / sigma;
    for (int64_t i = 0; i < count; i++) {
        double x = across[i] - offset, F, f;
        gaussian(x * per_sigma, nodes, &F, &f);
        f *= per_sigma;
        double ramp = x * F + sigma * sigma * f;
        columns[i] = grey[i] - (b + a * F + c * x + d * ramp);
        columns[most + i] = 1.0;
        columns[2 * most + i] = F;
        columns[3 * most + i] = x;
        columns[4 * most + i] = ramp;
        columns[5 * most + i] = -a * f - c - d * F;
        columns[6 * most + i] = -a * f * x * per_sigma + d * sigma * f;
    }
    int64_t whole = (count + DOUBLES - 1) / DOUBLES * DOUBLES;
    for (int k = 0; k < STEP_COLUMNS; k++)
        for (int64_t i = count; i < whole; i++)
            columns[k * most + i] = 0.0;
}

static void multiply_columns(const double *columns, int64_t count, int64_t most, int used,
                             Products out)
{
    for (int p = 0; p < used; p++)
        for (int q = 0; q <= p; q++) {
            const double *one = columns + p * most, *other = columns + q * most;
            doubles total = {0};
            for (int64_t i = 0; i < count; i += DOUBLES)
                total += load_f64(one + i) * load_f64(other + i);
            out[p][q] = sum_f64(total);
        }
}

/* Cholesky's L of the leading equations, scaled to a unit diagonal; whether there is one.
 *
 * scale: what rows and columns are multiplied by. */
static bool decompose(const Products sums, int size, StepVector scale, StepMatrix L)
{
    for (int p = 0; p < size; p++) {
        double square = sums[p + 1][p + 1];
        scale[p] = square > 0.0 ? 1.0 / sqrt(square) : 1e6;
        for (int q = 0; q <= p; q++) {
            double rest = p != q ? sums[p + 1][q + 1] * scale[p] * scale[q] : 1.0;
            for (int k = 0; k < q; k++)
                rest -= L[p][k] * L[q][k];
            if (p != q)
                L[p][q] = rest / L[q][q];
            else if (rest < SINGULAR)
                return false;
            else
                L[p][p] = sqrt(rest);
        }
    }
    return true;
}

static void solve_decomposed(StepMatrix L, int size, const StepVector scale,
                             const StepVector right, StepVector out)
{
    for (int p = 0; p < size; p++) {
        double rest = right[p] * scale[p];
        for (int k = 0; k < p; k++)
            rest -= L[p][k] * out[k];
        out[p] = rest / L[p][p];
    }
    for (int p = size - 1; p >= 0; p--) {
        double rest = out[p];
        for (int k = p + 1; k < size; k++)
            rest -= L[k][p] * out[k];
        out[p] = rest / L[p][p];
    }
    for (int p = 0; p < size; p++)
        out[p] *= scale[p];
}

/* Gauss-Newton of one step on the pixels (count). Fills offset, its deviation, height, its
 * deviation, blur and noise, or leaves them as they are where there is no sound edge.
 *
 * furthest: from where the edge is expected; size: 5, or 6 to fit the blur too. */
static void fit_step(const double *across, const double *grey, int64_t count, double furthest,
                     double blur, int size, GaussianNodes nodes, double *columns, int64_t most,
                     double *found)
{
    StepVector state = {[STEP_BLUR] = blur}, scale, g, step;
    StepMatrix L;
    Products sums;
    for (int turn = 0; turn < STEP_TURNS; turn++) {
        fill_columns(across, grey, count, state, nodes, columns, most);
        multiply_columns(columns, count, most, size + 1, sums);
        /* brightness and slopes first; then the edge's place (and the blur) as well */
        int unknowns = turn == 0 ? STEP_OFFSET : size;
        if (!decompose(sums, unknowns, scale, L))
            return;
        for (int p = 0; p < unknowns; p++)
            g[p] = sums[p + 1][0];
        solve_decomposed(L, unknowns, scale, g, step);
        for (int p = 0; p < STEP_OFFSET; p++)
            state[p] += step[p];
        if (turn == 0)
            continue;
        double shift = min_f64(max_f64(step[STEP_OFFSET], -1.0), 1.0);
        state[STEP_OFFSET] += shift;
        bool settled = fabs(shift) < STEP_SETTLED_PX;
        if (size > STEP_BLUR) {
            double last = state[STEP_BLUR], next = last + step[STEP_BLUR];
            settled = settled && fabs(step[STEP_BLUR]) < STEP_SETTLED_BLUR * last;
            state[STEP_BLUR] = min_f64(max_f64(next, BLUR_SHRINKS * last), BLUR_GROWS * last);
        }
        if (fabs(state[STEP_OFFSET]) > furthest || state[STEP_BLUR] < LEAST_BLUR)
            return;
        if (settled)
            break;
    }
    double variance = max_f64(sums[0][0] / (double)(count - size), LEAST_VARIANCE);
    const int reported[2] = {STEP_OFFSET, STEP_HEIGHT};
    for (int k = 0; k < 2; k++) {
        StepVector unit = {0};
        unit[reported[k]] = 1.0;
        solve_decomposed(L, size, scale, unit, step);
        found[2 * k] = state[reported[k]];
        found[2 * k + 1] = sqrt(variance * step[reported[k]]);
    }
    found[4] = state[STEP_BLUR];
    found[5] = sqrt(variance);
}

/* Fits a step at each place (n, 4) in its window (n, 3) and reach (n), as of `window_pixels`.
 *
 * blur: its standard deviation, px; nodes (2, k): integral and density of the unit Gaussian at
 * equal distances from -9 to 9. found (n, 6) as of `fit_step`, NaN where there is no sound edge.
 * workspace (9, most): most is the pixels of the largest square and DOUBLES more. */
EXPORT(void, measure_steps)(int64_t height, int64_t width, int64_t n, int64_t k, int64_t most,
                            const double *image, const double *places, const double *windows,
                            const int64_t *reach, const double *nodes,
                            double blur, int64_t size, double *found, double *workspace)
{
    double per_sigma = (double)(k - 1) / (2 * PLAIN_SIGMAS);
    GaussianNodes at = {nodes, nodes + k, per_sigma, 1 / per_sigma};
    double *across = workspace, *grey = across + most, *columns = grey + most;
    for (int64_t i = 0; i < n; i++) {
        const double *window = windows + 3 * i;
        double furthest = FURTHEST * max_f64(window[0], window[1]), *own = found + 6 * i;
        for (int j = 0; j < 6; j++)
            own[j] = NAN;
        int64_t count = window_pixels(image, height, width, places + 4 * i, window, reach[i],
                                      across, grey);
        if (count >= 4 * size)
            fit_step(across, grey, count, furthest, blur, (int)size, at, columns, most, own);
    }
}
