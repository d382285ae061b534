/* A clipped line, step 4: one step of the fit of both flanks, of sixteen columns at a time.
 *
 * At the distance d from the line's middle the signal is exp(b - slope d - bend d^2), with a
 * brightness b of each column's own and a slope and a bend that all columns share (a Gaussian
 * beam is all bend, light scattered in paper all slope). The noise's variance grows with the
 * signal. The distance counts from the usual core's edge. */

/* The signals that count, in shares of the height at which pixels are clipped. */
static const float LOWEST = 0.05f, HIGHEST = 1.3f;
/* The variance of a median of many values, in shares of their mean's. */
static const double MEDIAN_VARIANCE = 1.57;

/* What all columns share. */
typedef struct {
    double slope, bend; /* of the logarithm of the signal, at the usual core's edge */
    double usual;       /* half the usual core's width in px: distances count from there */
    double read, gain;  /* the variance of a pixel's signal s is read + gain s */
} Flanks;

/* The normal equations of the shape, freed of what each column's own brightness takes up. */
typedef struct {
    lanes n00, n01, n11, g0, g1;
} ShapeSums;

/* Of each pixel of a block: its signal by the fit, that signal's slope, and its weight. */
typedef struct {
    lanes model[2 * FLANK], slope[2 * FLANK], weight[2 * FLANK];
} BlockModel;

/* Of each column of a block: the inverse of its normal matrix, where both flanks count. */
typedef struct {
    lane_mask fits;
    lanes shift, height, both; /* of the middle, of the logarithm of the height, and of both */
} BlockInverse;

/* exp(a): a power of two, and a polynomial of what is left of the exponent. */
static inline lanes exp_lanes(lanes a)
{
    const lanes farthest = all_lanes(80.0f), rounding = all_lanes(12582912.0f); /* 1.5 2^23 */
    a = where(a < farthest, a, farthest);
    a = where(a > -farthest, a, -farthest);
    lanes power = (a * 1.44269504f + rounding) - rounding;
    lanes x = (a - power * 0.693359375f) + power * 2.12194440e-4f;
    lanes y = x * (1.0f / 720) + 1.0f / 120;
    y = (((y * x + 1.0f / 24) * x + 1.0f / 6) * x + 0.5f) * (x * x) + x + 1.0f;
    lane_mask exponent = (__builtin_convertvector(power, lane_mask) + 127) << 23;
    return y * (lanes)exponent;
}

static inline lanes between(lanes value, float limit)
{
    value = where(value < all_lanes(limit), value, all_lanes(limit));
    return where(value > all_lanes(-limit), value, all_lanes(-limit));
}

/* One Gauss-Newton step of sixteen columns' middles and brightnesses; adds to the shape's sums.
 *
 * The sums of the shape are of e, the distance from the column's own edge; d = e + wider. */
static void step_block(Clipped *c, int64_t at, const Flanks *flanks, ShapeSums *sums,
                       BlockModel *block, BlockInverse *inverse)
{
    const lanes zero = all_lanes(0), one = all_lanes(1);
    const float slope = (float)flanks->slope, bend = (float)flanks->bend;
    const float *signals = c->signal + at * 2 * FLANK;
    lanes top = load(c->top[0] + at), shift = load(c->shift + at);
    lanes log_height = load(c->log_height + at);
    lanes wider = load(c->half + at) - (float)flanks->usual;
    lanes n0 = (float)flanks->read / (top * top), n1 = (float)flanks->gain / top;
    lanes cc = zero, mm = zero, gm = zero, chi2 = zero, q1 = zero, q2 = zero;
    lanes s1 = zero, s2 = zero, s3 = zero, s4 = zero;
    lanes seen[2], own_m[2], own_c[2] = {zero, zero}, cm[2] = {zero, zero}, gc[2];
    for (int side = 0; side < 2; side++) {
        lanes share = load(c->top[side] + at) / top;
        lanes lowest = share * LOWEST, highest = share * HIGHEST;
        lanes e = (side ? -shift : shift) + 0.5f;
        lanes count = zero, sum_m = zero, sum_c = zero, sum_cm = zero, sum_gc = zero;
        for (int j = side * FLANK; j < (side + 1) * FLANK; j++) {
            lanes d = e + wider, signal = load(signals + j * LANES);
            lanes m = exp_lanes(log_height - d * (d * bend + slope));
            lane_mask counts = (m > lowest) & (m < highest) & (signal > 0.5f * UNSEEN);
            lanes w = where(counts, one / (n1 * m + n0), zero);
            lanes fall = m * (d * (2.0f * bend) + slope), left = signal - m;
            lanes wm = w * m, wc = w * fall, pull = w * left, wmm = wm * m, pull_m = pull * m;
            block->model[j] = m;
            block->slope[j] = side ? fall : -fall;
            block->weight[j] = w;
            count += where(counts, one, zero);
            sum_m += wm;
            sum_c += wc;
            sum_cm += wc * m;
            sum_gc += pull * fall;
            cc += wc * fall;
            mm += wmm;
            gm += pull_m;
            chi2 += pull * left;
            lanes we = wmm * e, wee = we * e;
            s1 += we;
            s2 += wee;
            s3 += wee * e;
            s4 += wee * e * e;
            q1 += pull_m * e;
            q2 += pull_m * e * e;
            e += 1.0f;
        }
        seen[side] = count;
        own_m[side] = sum_m;
        own_c[side] = side ? sum_c : -sum_c;
        cm[side] = side ? sum_cm : -sum_cm;
        gc[side] = side ? sum_gc : -sum_gc;
    }
    lanes both = cm[0] + cm[1], pull_c = gc[0] + gc[1], det = cc * mm - both * both;
    /* both flanks must count: one alone cannot separate brightness from place */
    lane_mask fits = (seen[0] > 0.0f) & (seen[1] > 0.0f) & (det > 1e-6f * cc * mm);
    lanes per_det = one / where(fits, det, one), per_mm = one / where(fits, mm, one);
    lanes by_sides = zero, count = seen[0] + seen[1], free = count - 2.0f;
    for (int side = 0; side < 2; side++) {
        lanes pulled = (mm * own_c[side] - both * own_m[side]) * per_det;
        by_sides += pulled * pulled;
    }
    lanes background = n0 * (float)(MEDIAN_VARIANCE / BACKGROUND_PX);
    store(c->variance + at, where(fits, mm * per_det + by_sides * background, all_lanes(NAN)));
    store(c->misfit + at, chi2 / where(free > one, free, one));
    store(c->count + at, count);
    lanes u00 = s2 - s1 * s1 * per_mm, u01 = s3 - s1 * s2 * per_mm, u11 = s4 - s2 * s2 * per_mm;
    lanes h0 = q1 - s1 * gm * per_mm, h1 = q2 - s2 * gm * per_mm, twice = wider * 2.0f;
    sums->n00 += where(fits, u00, zero);
    sums->n01 += where(fits, u01 + twice * u00, zero);
    sums->n11 += where(fits, u11 + twice * (u01 * 2.0f + twice * u00), zero);
    sums->g0 -= where(fits, h0, zero);
    sums->g1 -= where(fits, h1 + twice * h0, zero);
    lanes move = where(fits, between((mm * pull_c - both * gm) * per_det, 1.0f), zero);
    lanes brighter = where(fits, between((cc * gm - both * pull_c) * per_det, 0.5f), zero);
    store(c->shift + at, shift + move);
    store(c->log_height + at, log_height + brighter);
    store(c->move + at, where(move < zero, -move, move));
    *inverse = (BlockInverse){fits, mm * per_det, cc * per_det, both * per_det};
}
