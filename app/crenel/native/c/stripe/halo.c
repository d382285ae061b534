/* A clipped line, step 6: the middle of its core, where the halo around it is uneven.
 *
 * Light that is scattered around a line reaches further on one side, and carries that flank along;
 * the core's edges lie where the beam itself is steep, and follow less. Where the flanks' middle
 * stays beside that of the edges over a neighbourhood as long as the core is wide, the edges say
 * where the line is, and the flanks only what is finer. */

/* The middles differ by so much at least, in px, and by so many deviations of their mean. */
static const double HALO_PX = 0.3, HALO_DEVIATIONS = 4.0;
/* What the edges are off, as a standard deviation in shares of that difference. */
static const double EDGES_FOLLOW = 0.5;
/* The least fall from one pixel to the next, in shares of the height of clipping, that tells an
 * edge. */
static const float LEAST_EDGE_FALL = 0.05f;

/* How far from the last clipped pixel the light falls to the height of clipping, in px, by the two
 * pixels beyond. */
static float edge_beyond(const Clipped *c, int64_t column, int side)
{
    const float *signal = c->signal + column / LANES * LANES * 2 * FLANK + column % LANES;
    const float highest = c->top[side][column] / c->top[0][column];
    const float next = signal[side * FLANK * LANES], after = signal[(side * FLANK + 1) * LANES];
    if (next == UNSEEN || after == UNSEEN)
        return 0.5f;
    const float fall = max_f32((next - after) / highest, LEAST_EDGE_FALL);
    return 1 - min_f32((1 - next / highest) / fall, 1);
}

/* By how much the middle of a core's edges lies below that of its clipped pixels. */
static float edges_shift(const Clipped *c, int64_t column)
{
    return 0.5f * (edge_beyond(c, column, 1) - edge_beyond(c, column, 0));
}

/* Takes off the flanks' middles what an uneven halo adds, with the variance that is left.
 *
 * beside: (flanks) by how much the flanks' middle lies below the edges'; NaN where they do not fit.
 */
static void take_off_halo(Clipped *c, const double *beside)
{
    const int32_t *column = c->flank_column;
    const int64_t reach = (int64_t)(c->core_width / 2);
    double sum = 0, squares = 0, count = 0;
    int64_t begin = 0, end = 0;
    for (int64_t i = 0; i < c->flanks; i++) {
        for (; end < c->flanks && column[end] <= column[i] + reach; end++) {
            const double off = isnan(beside[end]) ? 0 : beside[end];
            sum += off;
            squares += off * off;
            count += !isnan(beside[end]);
        }
        for (; column[begin] < column[i] - reach; begin++) {
            const double off = isnan(beside[begin]) ? 0 : beside[begin];
            sum -= off;
            squares -= off * off;
            count -= !isnan(beside[begin]);
        }
        if (isnan(beside[i]))
            continue;
        const double mean = sum / count;
        const double error = max_f64(squares / count - mean * mean, 0) / count;
        const double least = HALO_PX * HALO_PX + HALO_DEVIATIONS * HALO_DEVIATIONS * error;
        if (mean * mean <= least)
            continue;
        const double off = mean * (1 - least / (mean * mean));
        c->centre[i] -= off;
        c->by_surface[i] += EDGES_FOLLOW * EDGES_FOLLOW * off * off;
    }
}
