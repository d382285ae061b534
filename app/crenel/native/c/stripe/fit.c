/* Step 8: fits a Gaussian on a background to the peaks of a block, by Gauss-Newton. */

static const float FEWEST_PIXELS = 5, NARROWEST = 0.2f;
/* Half a width and half a height is the most that a step may move by. */
static const float LONGEST_STEP = 0.5f;
/* The longest step, in shares of the width, after which what is left to go is nothing: the next
 * would be a tenth as long. */
static const float SETTLED = 0.08f;
/* Of a diagonal, what its factor must keep for the matrix to count as regular. */
static const float LEAST_PIVOT = 1e-6f;

static inline lanes absolute(lanes a) { return greater(a, -a); }

/* Moves the parameters of sixteen lanes by one step. A lane whose fit leaves its window, or has no
 * solution, is no peak and stays. */
static void step(Block *block, int at)
{
    const Factors f = factor(block, at);
    const lanes y0 = load(block->gradient[0] + at);
    const lanes y1 = load(block->gradient[1] + at) - f.l1 * y0;
    const lanes y2 = load(block->gradient[2] + at) - f.l2 * y0 - f.m2 * y1;
    const lanes y3 = load(block->gradient[3] + at) - f.l3 * y0 - f.m3 * y1 - f.o3 * y2;
    const lanes x3 = y3 * f.c3, x2 = y2 * f.c2 - f.o3 * x3;
    const lanes x1 = y1 * f.c1 - f.m2 * x2 - f.m3 * x3;
    const lanes x0 = y0 * f.c0 - f.l1 * x1 - f.l2 * x2 - f.l3 * x3;
    /* the inverse's first element */
    const lanes z2 = f.l1 * f.m2 - f.l2, z3 = f.l1 * f.m3 - f.l3 - f.o3 * z2;
    const lanes inverse = f.c0 + f.l1 * f.l1 * f.c1 + z2 * z2 * f.c2 + z3 * z3 * f.c3;
    lane_mask sound = (f.d0 > 0.0f) & (f.d1 > LEAST_PIVOT * load(block->normal[N11] + at));
    sound &= f.d2 > LEAST_PIVOT * load(block->normal[N22] + at);
    sound &= f.d3 > LEAST_PIVOT * load(block->normal[N33] + at);
    sound &= load(block->used + at) >= FEWEST_PIXELS;
    const lanes largest = greater(greater(absolute(x0), absolute(x2)), 0.5f * absolute(x1));
    const lanes share = lesser(all_lanes(1), LONGEST_STEP / greater(largest, all_lanes(1e-9f)));
    const lanes sigma = load(block->sigma + at), height = load(block->height + at);
    const lanes state = load(block->state + at), before = load(block->centre + at);
    const lanes background = load(block->background + at);
    const lanes centre = before + share * x0 * sigma;
    const lanes wider = sigma * (1.0f + share * x2), higher = height * (1.0f + share * x1);
    sound &= (wider >= NARROWEST) & (higher > 0.0f);
    sound &= (centre >= load(block->first + at)) & (centre <= load(block->last + at));
    const lane_mask moving = sound & (state == PEAK);
    const lanes at_most = where(moving, state, lesser(state, all_lanes(WIDER)));
    store(block->state + at, where(sound, at_most, all_lanes(NO_PEAK)));
    store(block->centre + at, where(moving, centre, before));
    store(block->sigma + at, where(moving, wider, sigma));
    store(block->height + at, where(moving, higher, height));
    store(block->background + at, where(moving, background + share * x3 * height, background));
    store(block->moved + at, where(moving, largest, all_lanes(0)));
    store(block->variance + at, inverse * sigma * sigma);
}

/* Steps until none of sixteen lanes moves further; those that still do are WIDER. */
static void settle(Block *block, const Profile profile, int rows, const float *noise,
                   float saturated, int steps, int at)
{
    for (int i = 0; i < steps; i++) {
        normal_equations(block, profile, rows, noise, saturated, at);
        step(block, at);
        if (highest(load(block->moved + at)) < SETTLED)
            return;
    }
    const lanes state = load(block->state + at);
    const lane_mask unsettled = load(block->moved + at) >= SETTLED;
    store(block->state + at, where(unsettled, lesser(state, all_lanes(WIDER)), state));
}

/* Fits the peaks whose pixels a profile holds, `reach` rows to either side. */
static void fit_block(Block *block, const Profile profile, int reach, const float *noise,
                      float saturated, int steps)
{
    start_fits(block, profile, reach, saturated);
    set_windows(block, profile, reach, saturated);
    for (int at = 0; at < BLOCK; at += LANES)
        settle(block, profile, 2 * reach + 1, noise, saturated, steps, at);
}

/* Puts what became of a block's peaks into a table of fits whose rows are so long. */
static void keep_fits(const Block *block, int reach, float *table, int64_t row_length)
{
    const float *rows[FIT_ROWS] = {
        [CENTRE] = block->centre,   [AMPLITUDE] = block->height, [SIGMA] = block->sigma,
        [VARIANCE] = block->variance, [CHI2] = block->chi2,      [PIXELS] = block->used,
        [CLIPPED] = block->clipped, [BECAME] = block->state,
    };
    for (int i = 0; i < FIT_ROWS; i++)
        memcpy(table + i * row_length, rows[i], sizeof block->centre);
    for (int i = 0; i < BLOCK; i++)
        table[CENTRE * row_length + i] -= (float)reach;
}
