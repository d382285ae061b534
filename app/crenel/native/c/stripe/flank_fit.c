/* A clipped line, step 6: both flanks of every column, fitted together round by round.
 *
 * Each round steps every column's middle and brightness, then the shape that all share, then the
 * noise. Columns whose flanks do not fit are left out. */

enum {
    FIT_ROUNDS = 12,      /* at most */
    SHAPE_ROUNDS = 6,     /* those that find the shape */
    NOISE_ROUND = 4,      /* from which on the noise is estimated */
    GUESSING_COLUMNS = 256 /* that the first guess of the shape is from */
};
static const float SETTLED_PX = 1e-3f;
/* The gain to begin with, in shares of the clipping level. */
static const double FLANK_GAIN = 0.1 / 255;
/* The middle of the flanks lies near the middle of the core, in shares of the core's width. */
static const float MOST_SHIFT = 0.3f;
/* Backgrounds on both sides that differ by more than this factor are two brightnesses of the
 * surface: the flank on the brighter one reaches further. */
static const double UNEVEN = 1.5;
/* The variance of the middle of two edges, each anywhere in its pixel. */
static const double EDGE_VARIANCE = 1.0 / 24;
/* How far the middle of a wide core is off, as a standard deviation in shares of its width, where
 * its flanks do not fit: the light that the surface scatters is not the same on both sides. */
static const double CORE_ERROR = 0.1;
/* A fit's chi squared that is no chance, in its standard deviations. */
static const float UNLIKELY = 5.0f;

/* The usual signal of the pixels that lie so far beside the cores, in grey levels. */
static double usual_signal(const Clipped *c, int out)
{
    float some[2 * GUESSING_COLUMNS];
    int64_t found = 0, every = (c->cores + GUESSING_COLUMNS - 1) / GUESSING_COLUMNS;
    for (int64_t i = 0; i < c->cores; i += every) {
        const float *column = c->signal + i / LANES * LANES * 2 * FLANK + i % LANES;
        for (int side = 0; side < 2; side++) {
            float signal = column[(side * FLANK + out) * LANES];
            if (signal != UNSEEN)
                some[found++] = signal * c->top[0][i];
        }
    }
    return found ? median_of(some, found) : 0.0;
}

/* What the fit begins with: the shape by how the usual signal falls beside the cores. */
static Flanks first_flanks(Clipped *c, double saturated, double read)
{
    double near = max_f64(usual_signal(c, 0), 1.0), further = max_f64(usual_signal(c, 2), 1.0);
    double slope = max_f64(0.1, min_f64(0.5 * log(near / further), 2.0));
    Flanks flanks = {slope, 0.0, 0.5 * usual_core(c), max_f64(read, 1.0 / 12),
                     FLANK_GAIN * saturated};
    for (int64_t i = 0; i < c->cores; i++) {
        c->half[i] = 0.5f * (float)(c->last[i] - c->first[i] + 1);
        c->shift[i] = 0.0f;
        c->log_height[i] = (float)slope * (c->half[i] - (float)flanks.usual);
    }
    for (int64_t i = c->cores; i % LANES; i++) { /* columns that fill the last block */
        c->half[i] = (float)flanks.usual;
        c->shift[i] = c->log_height[i] = 0.0f;
        c->top[0][i] = c->top[1][i] = 1.0f;
    }
    return flanks;
}

/* One step of the shared shape, no further than it may be trusted. */
static void step_shape(Flanks *flanks, const ShapeSums *sums)
{
    double n00 = total(sums->n00), n01 = total(sums->n01), n11 = total(sums->n11);
    double g0 = total(sums->g0), g1 = total(sums->g1);
    double det = n00 * n11 - n01 * n01, trace = n00 + n11, slope, bend;
    if (det > 1e-9 * trace * trace) {
        slope = (n11 * g0 - n01 * g1) / det;
        bend = (n00 * g1 - n01 * g0) / det;
    } else if (trace > 0) { /* only one direction is known: the shortest step */
        slope = (n00 * g0 + n01 * g1) / (trace * trace);
        bend = (n01 * g0 + n11 * g1) / (trace * trace);
    } else {
        return;
    }
    double most = 0.3 * flanks->slope;
    double largest = max_f64(fabs(slope) / most, fabs(bend) / (most + 0.05));
    flanks->slope += slope / max_f64(largest, 1.0);
    flanks->bend += bend / max_f64(largest, 1.0);
}

/* One round; whether the middles have come to rest. */
static bool fit_round(Clipped *c, Flanks *flanks, int round, double first_read, double first_gain)
{
    ShapeSums sums = {0};
    Residuals steps[HEIGHT_STEPS] = {0};
    int64_t blocks = (c->cores + LANES - 1) / LANES;
    int64_t every = (blocks + NOISE_SAMPLE - 1) / NOISE_SAMPLE, resting = 0;
    for (int64_t b = 0; b < blocks; b++) {
        BlockModel model;
        BlockInverse inverse;
        step_block(c, b * LANES, flanks, &sums, &model, &inverse);
        if (round >= NOISE_ROUND && b % every == 0)
            add_flank_residuals(c, b * LANES, &model, &inverse, steps);
    }
    if (round < SHAPE_ROUNDS)
        step_shape(flanks, &sums);
    if (round >= NOISE_ROUND)
        learn_flank_noise(flanks, steps, first_read, first_gain);
    for (int64_t i = 0; i < c->cores; i++)
        resting += c->move[i] < SETTLED_PX;
    return round >= SHAPE_ROUNDS && 2 * resting > c->cores;
}

/* What two brightnesses of the surface may shift a middle by, squared: a side twice as bright
 * carries its flank as far out as the signal takes to fall to half. */
static double uneven_variance(const Clipped *c, int64_t column, double decay_px)
{
    double above = max_f64(c->background[0][column], 1.0);
    double below = max_f64(c->background[1][column], 1.0);
    double factor = max_f64(above, below) / min_f64(above, below);
    double shift = 0.5 * decay_px * log(factor);
    return factor > UNEVEN ? shift * shift : 0.0;
}

/* Rows over which the shared flanks fall to half from the core's edge on. */
static double half_fall(const Flanks *flanks)
{
    const double slope = flanks->slope, bend = flanks->bend, half = log(2);
    const double root = slope * slope + 4 * bend * half;
    return root > 0 ? 2 * half / max_f64(slope + sqrt(root), 0.02) : half / max_f64(slope, 0.02);
}

/* Whether the signal ends within a pixel on both sides of a core, so that no pixel shows a flank;
 * fills by how much the middle of the light lies below the core's. */
static bool ends_steeply(const Clipped *c, int64_t column, float *shift)
{
    const float *signal = c->signal + column / LANES * LANES * 2 * FLANK + column % LANES;
    float part[2];
    for (int side = 0; side < 2; side++) {
        const float highest = c->top[side][column] / c->top[0][column];
        const float *next = signal + side * FLANK * LANES;
        if (next[0] == UNSEEN || fabsf(next[LANES]) >= LOWEST * highest)
            return false;
        part[side] = max_f32(next[0] / highest, 0);
    }
    *shift = 0.5f * (part[1] - part[0]);
    return true;
}

/* Keeps the columns whose flanks fit or are steep, or whose core is wide, with the variances of their middles. */
static void keep_fitted(Clipped *c, const Flanks *flanks)
{
    double decay_px = 1 / max_f64(flanks->slope, 0.02), *beside = c->workspace;
    c->flanks = 0;
    for (int64_t i = 0; i < c->cores; i++) {
        float free = max_f32(c->count[i] - 2, 1), misfit = c->misfit[i];
        float most = max_f32(2 * MOST_SHIFT * c->half[i], 1), shift = c->shift[i];
        const bool fits = isfinite(c->variance[i]) && fabsf(shift) < most;
        const bool steep = !fits && ends_steeply(c, i, &shift);
        const bool by_core = !fits && !steep;
        if (by_core && 2 * c->half[i] < HALO_CORE)
            continue;
        const double off = CORE_ERROR * 2 * c->half[i];
        bool worse = misfit > 1 + UNLIKELY * sqrtf(2 / free);
        int64_t n = c->flanks++;
        c->flank_column[n] = c->column[i];
        c->centre[n] = 0.5 * (c->first[i] + c->last[i]) + (by_core ? 0 : shift);
        c->by_noise[n] = fits ? c->variance[i] * (worse ? misfit : 1) : EDGE_VARIANCE;
        c->by_surface[n] = fits ? uneven_variance(c, i, decay_px) : by_core ? off * off : 0;
        beside[n] = fits ? shift - edges_shift(c, i) : NAN;
    }
    take_off_halo(c, beside);
}

/* Fits the flanks of the cores whose pixels have been read; fills the flanks.
 *
 * read: variance of a dark pixel in grey levels squared, to begin with. */
static void fit_flanks(Clipped *c, double saturated, double read)
{
    Flanks flanks = first_flanks(c, saturated, read);
    double first_read = flanks.read, first_gain = flanks.gain;
    for (int round = 0; round < FIT_ROUNDS; round++)
        if (fit_round(c, &flanks, round, first_read, first_gain))
            break;
    c->half_fall = half_fall(&flanks);
    keep_fitted(c, &flanks);
}
