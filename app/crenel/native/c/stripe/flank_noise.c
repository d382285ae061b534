/* A clipped line, step 5: the noise of the pixels, by what the fit leaves of them.
 *
 * Read noise and gain are a line through the squared residuals of steps of the signal's height.
 * Each step's are divided by its redundancy, the share of its error that the fit leaves
 * (Foerstner's estimate), so that pixels which the fit follows seem no better. A line, and not
 * each step on its own: steps whose pixels the fit follows closely would take up all weight. What
 * no step shows stays near what it was first. */

enum {
    HEIGHT_STEPS = 12, /* steps of the signal's height up to HIGHEST */
    NOISE_SAMPLE = 16  /* blocks of columns at most that the noise is estimated from */
};
/* The redundancy that a step needs, in all and per pixel. */
static const double LEAST_FREE = 5.0, LEAST_FREE_SHARE = 0.15;

/* Of the pixels of one step of height: sums of redundancy, squared residual, signal and one. */
typedef struct {
    double free, squares, signals, pixels;
} Residuals;

/* Adds the residuals of a block's pixels; before the step that the block's model leads to. */
static void add_flank_residuals(const Clipped *c, int64_t at, const BlockModel *block,
                          const BlockInverse *inverse, Residuals *steps)
{
    const float *signals = c->signal + at * 2 * FLANK;
    lanes top = load(c->top[0] + at);
    for (int j = 0; j < 2 * FLANK; j++) {
        lanes m = block->model[j], s = block->slope[j], left = load(signals + j * LANES) - m;
        lanes taken = s * s * inverse->shift - 2.0f * s * m * inverse->both;
        taken += m * m * inverse->height;
        lanes share = m * top / load(c->top[j / FLANK] + at) * (HEIGHT_STEPS / HIGHEST);
        float weights[LANES], free[LANES], squares[LANES], heights[LANES], shares[LANES];
        store(weights, where(inverse->fits, block->weight[j], all_lanes(0)));
        store(free, 1.0f - block->weight[j] * taken);
        store(squares, left * left * top * top);
        store(heights, m * top);
        store(shares, share);
        for (int k = 0; k < LANES; k++) {
            if (weights[k] == 0.0f)
                continue;
            Residuals *step = steps + min_i64((int64_t)shares[k], HEIGHT_STEPS - 1);
            step->free += free[k];
            step->squares += squares[k];
            step->signals += heights[k];
            step->pixels += 1.0;
        }
    }
}

/* Estimates read noise and gain; neither is negative. first_*: what they were to begin with. */
static void learn_flank_noise(Flanks *flanks, const Residuals *steps, double first_read,
                              double first_gain)
{
    /* the first guess is known to its own size, a variance to a share of itself */
    double n00 = 1 / (first_read * first_read), n11 = 1 / (first_gain * first_gain), n01 = 0;
    double g0 = 1 / first_read, g1 = 1 / first_gain;
    for (const Residuals *step = steps; step < steps + HEIGHT_STEPS; step++) {
        if (step->free <= LEAST_FREE || step->free <= LEAST_FREE_SHARE * step->pixels)
            continue;
        double signal = step->signals / step->pixels, found = step->squares / step->free;
        double expected = flanks->read + flanks->gain * signal;
        double weight = step->free / (expected * expected);
        n00 += weight;
        n01 += weight * signal;
        n11 += weight * signal * signal;
        g0 += weight * found;
        g1 += weight * found * signal;
    }
    double det = n00 * n11 - n01 * n01;
    double read = (n11 * g0 - n01 * g1) / det, gain = (n00 * g1 - n01 * g0) / det;
    if (read < 0) {
        read = 0;
        gain = g1 / n11;
    } else if (gain < 0) {
        read = g0 / n00;
        gain = 0;
    }
    flanks->read = max_f64(read, 1.0 / 12);
    flanks->gain = gain;
}
