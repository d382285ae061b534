/* Step 7: the normal equations of Gaussians on a background, of sixteen columns at once. */

/* exp(a) of -12 to 12, to five digits where it counts: a polynomial's sixteenth power. */
static inline lanes exponential(lanes a)
{
    const lanes farthest = all_lanes(0.75f);
    const lanes x = lesser(greater(a * (1.0f / 16), -farthest), farthest);
    lanes y = x * (1.0f / 120) + 1.0f / 24;
    y = (((y * x + 1.0f / 6) * x + 0.5f) * x + 1.0f) * x + 1.0f;
    y *= y;
    y *= y;
    y *= y;
    return y * y;
}

/* exp(-t^2 / 2) */
static inline lanes bell(lanes t) { return exponential(t * t * -0.5f); }

/* The sums of a fit of sixteen lanes, while they grow. */
typedef struct {
    lanes n00, n10, n11, n20, n22, n30, n31, n32, n33, g0, g1, g2, g3, chi2, used;
} Sums;

/* What a fit's pixels are compared with, in shares of the lane's own height and width, so that all
 * terms are about one. */
typedef struct {
    lanes per_height, background, n0, n1, n2, first, last;
    float saturated;
} Model;

/* Adds one row of pixels, where the Gaussian is e at t widths from the centre. */
static inline void add_row(Sums *sums, const Model *model, lanes pixel, lanes t, lanes e)
{
    const lanes zero = all_lanes(0), one = all_lanes(1);
    const lane_mask counts = (t >= model->first) & (t <= model->last) & (pixel < model->saturated);
    const lanes weight = where(counts, one / (e * (e * model->n2 + model->n1) + model->n0), zero);
    const lanes residual = pixel * model->per_height - model->background - e;
    const lanes pull = weight * residual, et = e * t, ett = et * t;
    const lanes wet = weight * et, we = weight * e, wett = weight * ett;
    sums->used += where(counts, one, zero);
    sums->chi2 += pull * residual;
    sums->n00 += wet * et;
    sums->n10 += wet * e;
    sums->n11 += we * e;
    sums->n20 += wett * et;
    sums->n22 += wett * ett;
    sums->n30 += wet;
    sums->n31 += we;
    sums->n32 += wett;
    sums->n33 += weight;
    sums->g0 += pull * et;
    sums->g1 += pull * e;
    sums->g2 += pull * ett;
    sums->g3 += pull;
}

static void store_sums(Block *block, const Sums *sums, int at)
{
    /* the same product of three stands in n00 and n21: (e t^2) e is (e t) (e t) */
    const lanes normal[NORMAL_ROWS] = {sums->n00, sums->n10, sums->n11, sums->n20, sums->n00,
                                       sums->n22, sums->n30, sums->n31, sums->n32, sums->n33};
    const lanes gradient[4] = {sums->g0, sums->g1, sums->g2, sums->g3};
    for (int i = 0; i < NORMAL_ROWS; i++)
        store(block->normal[i] + at, normal[i]);
    for (int i = 0; i < 4; i++)
        store(block->gradient[i] + at, gradient[i]);
    store(block->chi2 + at, sums->chi2);
    store(block->used + at, sums->used);
}

/* Fills the normal equations, chi squared and number of pixels of sixteen lanes.
 *
 * From the middle row outwards, the Gaussian of a row is that of the row before times a factor,
 * which itself changes by the same factor from row to row.
 *
 * noise (3): the variance of a pixel at signal s is noise[0] + noise[1] s + noise[2] s^2. */
static void normal_equations(Block *block, const Profile profile, int rows, const float *noise,
                             float saturated, int at)
{
    const lanes per_height = 1.0f / load(block->height + at);
    const lanes per_width = 1.0f / load(block->sigma + at), centre = load(block->centre + at);
    const Model model = {
        .per_height = per_height,
        .background = load(block->background + at) * per_height,
        .n0 = per_height * per_height * noise[0],
        .n1 = per_height * noise[1],
        .n2 = all_lanes(noise[2]),
        .first = (load(block->first + at) - 0.5f - centre) * per_width,
        .last = (load(block->last + at) + 0.5f - centre) * per_width,
        .saturated = saturated,
    };
    int begin, end;
    rows_used(block, at, rows, &begin, &end);
    int middle = rows / 2 > begin ? rows / 2 : begin;
    middle = middle < end ? middle : end;
    const lanes there = ((float)middle - centre) * per_width;
    const lanes slope = exponential(-there * per_width);
    const lanes bend = exponential(per_width * per_width * -0.5f), fall = bend * bend;
    const lanes top = bell(there);
    Sums sums = {0};
    lanes t = there, e = top, factor = slope * bend;
    for (int k = middle; k <= end; k++) {
        add_row(&sums, &model, load(profile[k] + at), t, e);
        t += per_width;
        e *= factor;
        factor *= fall;
    }
    factor = bend / slope;
    t = there - per_width;
    e = top * factor;
    factor *= fall;
    for (int k = middle - 1; k >= begin; k--) {
        add_row(&sums, &model, load(profile[k] + at), t, e);
        t -= per_width;
        e *= factor;
        factor *= fall;
    }
    store_sums(block, &sums, at);
}

/* A lane's normal matrix as L D L': D, its inverse, and L below its ones, by columns. */
typedef struct {
    lanes d0, d1, d2, d3, c0, c1, c2, c3, l1, l2, l3, m2, m3, o3;
} Factors;

static inline Factors factor(const Block *block, int at)
{
    lanes n[NORMAL_ROWS];
    for (int i = 0; i < NORMAL_ROWS; i++)
        n[i] = load(block->normal[i] + at);
    Factors f;
    f.d0 = n[N00];
    f.c0 = 1.0f / f.d0;
    f.l1 = n[N10] * f.c0;
    f.l2 = n[N20] * f.c0;
    f.l3 = n[N30] * f.c0;
    f.d1 = n[N11] - f.l1 * n[N10];
    f.c1 = 1.0f / f.d1;
    f.m2 = (n[N21] - f.l1 * n[N20]) * f.c1;
    f.m3 = (n[N31] - f.l1 * n[N30]) * f.c1;
    f.d2 = n[N22] - f.l2 * n[N20] - f.m2 * f.m2 * f.d1;
    f.c2 = 1.0f / f.d2;
    f.o3 = (n[N32] - f.l2 * n[N30] - f.m2 * f.m3 * f.d1) * f.c2;
    f.d3 = n[N33] - f.l3 * n[N30] - f.m3 * f.m3 * f.d1 - f.o3 * f.o3 * f.d2;
    f.c3 = 1.0f / f.d3;
    return f;
}
