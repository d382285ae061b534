/* Step 9: the sensor's noise, by the picture itself.
 *
 * The variance of a pixel at signal s is read + gain s + contrast s^2, in grey levels squared:
 * read noise, shot noise, and what scales with the signal (speckle, fixed pattern). */

/* A residual beyond so many variances is no noise, once the noise is roughly known. */
static const float OUTLYING = 25;
/* Fewer pixels, and pixels that the fit follows more closely than this share, say nothing. */
static const double FEWEST_NOISE_PIXELS = 60;
static const float LEAST_SHARE = 0.2f;

/* Sums over pixels of s^2, s^3, s^4, s d, s^2 d and 1, where s is a pixel's signal and d its
 * squared residual over its redundancy, less the read noise. */
typedef struct {
    lanes s2, s3, s4, sd, s2d, count;
} NoiseSums;

/* The inverse of the normal matrices of sixteen lanes, in the matrices' place. */
static void invert(Block *block, int at)
{
    const Factors f = factor(block, at);
    /* the inverse of L */
    const lanes z20 = f.m2 * f.l1 - f.l2, z31 = f.o3 * f.m2 - f.m3;
    const lanes z30 = f.m3 * f.l1 - f.l3 - f.o3 * z20;
    const lanes inverse[NORMAL_ROWS] = {
        [N00] = f.c0 + f.l1 * f.l1 * f.c1 + z20 * z20 * f.c2 + z30 * z30 * f.c3,
        [N10] = z30 * z31 * f.c3 - f.l1 * f.c1 - z20 * f.m2 * f.c2,
        [N11] = f.c1 + f.m2 * f.m2 * f.c2 + z31 * z31 * f.c3,
        [N20] = z20 * f.c2 - z30 * f.o3 * f.c3,
        [N21] = -f.m2 * f.c2 - z31 * f.o3 * f.c3,
        [N22] = f.c2 + f.o3 * f.o3 * f.c3,
        [N30] = z30 * f.c3,
        [N31] = z31 * f.c3,
        [N32] = -f.o3 * f.c3,
        [N33] = f.c3,
    };
    for (int i = 0; i < NORMAL_ROWS; i++)
        store(block->normal[i] + at, inverse[i]);
}

/* Adds what the residuals of sixteen lanes say of the noise.
 *
 * A squared residual is divided by its redundancy, the share of the pixel's error that the fit
 * leaves (Foerstner's estimate): the fit follows some pixels closely. It counts for `outlying`
 * variances at most. The normal matrices are inverted already. */
static void add_residuals(NoiseSums *sums, const Block *block, const Profile profile, int rows,
                          const float *noise, float saturated, float outlying, int at)
{
    const lanes zero = all_lanes(0), one = all_lanes(1);
    const lanes centre = load(block->centre + at), background = load(block->background + at);
    const lanes height = load(block->height + at), height2 = height * height;
    const lanes per_width = one / load(block->sigma + at);
    const lanes first = load(block->first + at), last = load(block->last + at);
    /* a narrow spike that speckle made is fitted far above what the pixels hold */
    lane_mask usable = (load(block->state + at) >= PEAK) & (load(block->used + at) > 5.0f);
    usable &= (load(block->moved + at) < SETTLED) & (height < saturated);
    lanes i[NORMAL_ROWS];
    for (int k = 0; k < NORMAL_ROWS; k++)
        i[k] = load(block->normal[k] + at);
    int begin, end;
    rows_used(block, at, rows, &begin, &end);
    for (int k = begin; k <= end; k++) {
        const lanes x = all_lanes((float)k), pixel = load(profile[k] + at);
        const lanes t = (x - centre) * per_width, e = bell(t), et = e * t, ett = et * t;
        const lanes s = height * e, variance = s * (s * noise[2] + noise[1]) + noise[0];
        const lanes residual = pixel - background - s, per_variance = one / variance;
        lanes taken = et * (et * i[N00] + (e * i[N10] + ett * i[N20]) * 2.0f);
        taken = taken + e * (e * i[N11] + ett * i[N21] * 2.0f) + ett * ett * i[N22] + i[N33];
        taken = taken + (et * i[N30] + e * i[N31] + ett * i[N32]) * 2.0f;
        const lanes share = one - taken * height2 * per_variance;
        const lane_mask inside = usable & (x >= first) & (x <= last);
        const lane_mask counts = inside & (pixel < saturated) & (share > LEAST_SHARE);
        const lanes squared = residual * residual / share;
        /* a lane without a solution may hold no numbers at all */
        const lanes d = where(counts, lesser(squared, variance * outlying) - noise[0], zero);
        const lanes signal = where(counts, s, zero);
        const lanes weight = where(counts, per_variance * per_variance, zero);
        const lanes ws = weight * signal, wss = ws * signal;
        sums->s2 += wss;
        sums->s3 += wss * signal;
        sums->s4 += wss * signal * signal;
        sums->sd += ws * d;
        sums->s2d += wss * d;
        sums->count += where(counts, one, zero);
    }
}

static double total(lanes value)
{
    float part[LANES];
    double sum = 0;
    store(part, value);
    for (int i = 0; i < LANES; i++)
        sum += part[i];
    return sum;
}

/* Least squares of gain and contrast, neither below zero, into noise[1] and noise[2]. */
static void solve_non_negative(const NoiseSums *sums, float *noise)
{
    const double ss = total(sums->s2), sc = total(sums->s3), cc = total(sums->s4);
    const double sd = total(sums->sd), cd = total(sums->s2d);
    if (total(sums->count) < FEWEST_NOISE_PIXELS)
        return;
    const double det = ss * cc - sc * sc;
    double gain = -1, contrast = -1;
    if (det > 1e-9 * ss * cc) {
        gain = (cc * sd - sc * cd) / det;
        contrast = (ss * cd - sc * sd) / det;
    }
    if (gain < 0 || contrast < 0) {
        gain = max_f64(sd / ss, 0);
        contrast = max_f64(cd / cc, 0);
        /* the one that takes more off the sum of squares */
        if (gain * sd > contrast * cd)
            contrast = 0;
        else
            gain = 0;
    }
    noise[1] = (float)gain;
    noise[2] = (float)contrast;
}

/* How the noise grows with the signal, by what fits to some of the peaks leave: fills noise[1] and
 * noise[2], which hold a first guess. The blocks hold started fits, rows[b] each. */
static void learn_noise(Block *blocks, const Profile *profiles, const int *rows, int count,
                        float saturated, float *noise)
{
    const float outlying[3] = {INFINITY, OUTLYING, OUTLYING};
    for (int turn = 0; turn < 3; turn++) {
        NoiseSums sums = {0};
        for (int b = 0; b < count; b++) {
            for (int at = 0; at < BLOCK; at += LANES) {
                normal_equations(&blocks[b], profiles[b], rows[b], noise, saturated, at);
                step(&blocks[b], at);
                invert(&blocks[b], at);
                add_residuals(&sums, &blocks[b], profiles[b], rows[b], noise, saturated,
                              outlying[turn], at);
            }
        }
        solve_non_negative(&sums, noise);
    }
}
