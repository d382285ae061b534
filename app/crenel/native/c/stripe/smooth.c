/* A clipped line, step 7: the line smoothed along itself over its own core's width.
 *
 * Light from so broad a spot shows nothing finer. A line, bent as its neighbourhood is, is fitted
 * to the points about each one; where they do not fit, the point stays as it is. */

/* A neighbourhood that scatters so many times as much as usual holds a step or a bend. */
static const float UNSTRAIGHT = 9.0f;

/* Spreads the flanks' middles over cells of a column each; returns how many cells that are. */
static int64_t fill_cells(Clipped *c, double level)
{
    int64_t first = c->flank_column[0], cells = c->flank_column[c->flanks - 1] - first + 1;
    int64_t whole = (cells + LANES - 1) / LANES * LANES + 2 * SMOOTH_MARGIN;
    memset(c->level, 0, (size_t)whole * sizeof *c->level);
    memset(c->weight, 0, (size_t)whole * sizeof *c->weight);
    for (int64_t i = 0; i < c->flanks; i++) {
        int64_t cell = c->flank_column[i] - first + SMOOTH_MARGIN;
        c->level[cell] = (float)(c->centre[i] - level);
        c->weight[cell] = (float)(1 / (c->by_noise[i] + c->by_surface[i]));
    }
    return cells;
}

/* A line through the cells up to `reach` from each of sixteen; those it does not fit scatter
 * without bound. */
static void fit_cells(Clipped *c, int64_t at, int reach)
{
    const lanes zero = all_lanes(0), one = all_lanes(1);
    const float *level = c->level + at + SMOOTH_MARGIN, *weight = c->weight + at + SMOOTH_MARGIN;
    lanes own = load(level), count = zero, square = zero;
    lanes s0 = zero, s1 = zero, s2 = zero, s3 = zero, f0 = zero, f1 = zero;
    for (int t = -reach; t <= reach; t++) {
        lanes w = load(weight + t), wt = w * (float)t, u = load(level + t) - own;
        count += where(w > 0.0f, one, zero);
        s0 += w;
        s1 += wt;
        s2 += wt * (float)t;
        s3 += wt * (float)(t * t);
        f0 += w * u;
        f1 += wt * u;
    }
    lanes det = s0 * s2 - s1 * s1;
    lane_mask known = (det > 0.0f) & (count > (float)max_i64(reach, 2));
    lanes per_det = one / where(known, det, one);
    lanes here = (s2 * f0 - s1 * f1) * per_det, slope = (s0 * f1 - s1 * f0) * per_det;
    for (int t = -reach; t <= reach; t++) {
        lanes left = load(level + t) - own - here - slope * (float)t;
        square += load(weight + t) * left * left;
    }
    store(c->here + at, here);
    store(c->spread + at, s2 * per_det);
    store(c->pulled + at, 0.5f * (s2 * s2 - s1 * s3) * per_det);
    known &= load(weight) > 0.0f;
    store(c->scatter + at, where(known, square / (count - 2.0f), all_lanes(INFINITY)));
}

/* Marks the cells that are straight: no step, no bend and no gap is near. */
static void mark_straight(Clipped *c, int64_t cells)
{
    float *some = (float *)c->workspace;
    int64_t found = 0;
    for (int64_t i = 0; i < cells; i++)
        if (isfinite(c->scatter[i]))
            some[found++] = c->scatter[i];
    float most = found ? UNSTRAIGHT * median_of(some, found) : 0;
    for (int64_t i = 0; i < cells; i++)
        c->straight[i] = c->scatter[i] < most;
}

/* Fills `bend` (cells) with the second derivative of the line, by means `apart` cells apart.
 *
 * A step or a gap between them bends nothing; there, and where the line begins and ends, the
 * nearest known bends count. */
static void find_bends(const Clipped *c, int64_t cells, int apart, double *bend)
{
    int64_t run = 0, before = -1;
    for (int64_t i = 0; i < cells; i++) {
        run = c->straight[i] ? run + 1 : 0;
        if (run < 2 * apart + 1)
            continue;
        int64_t at = i - apart;
        bend[at] = (c->mean[at - apart] - 2 * c->mean[at] + c->mean[i]) / (double)(apart * apart);
        for (int64_t j = before + 1; j < at; j++) {
            double share = before < 0 ? 1.0 : (double)(j - before) / (double)(at - before);
            bend[j] = before < 0 ? bend[at] : (1 - share) * bend[before] + share * bend[at];
        }
        before = at;
    }
    for (int64_t j = before + 1; j < cells; j++)
        bend[j] = before < 0 ? 0.0 : bend[before];
}

/* Smooths the middles of the flanks, at least one, in place, with their variances by noise. */
static void smooth_flanks(Clipped *c)
{
    int reach = (int)(c->core_width / 2);
    double level = c->centre[0];
    int64_t cells = fill_cells(c, level);
    for (int64_t at = 0; at < cells; at += LANES)
        fit_cells(c, at, reach);
    mark_straight(c, cells);
    for (int64_t i = 0; i < cells; i++)
        c->mean[i] = c->level[i + SMOOTH_MARGIN] + level + c->here[i];
    double *bend = c->workspace, window = 2 * reach + 1;
    find_bends(c, cells, 2 * reach + 1, bend);
    for (int64_t i = 0; i < c->flanks; i++) {
        int64_t cell = c->flank_column[i] - c->flank_column[0];
        if (!c->straight[cell])
            continue;
        /* the bend is by means that this one is of */
        double pulled = c->pulled[cell], share = fabs(pulled) / (window * window);
        c->centre[i] = c->mean[cell] - pulled * bend[cell];
        c->by_noise[i] = c->spread[cell] * (1 + 4 * share + 6 * share * share);
    }
}
