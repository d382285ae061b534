/* Step 6: where each fit starts, and the pixels that it takes. */

/* A fit reaches so many standard deviations and pixels from the centre, and further out beside
 * clipped pixels: a clipped profile looks wider, and has its foot further out. */
static const float REACH = 3.2f, REACH_PX = 1, BESIDE_CLIPPED_PX = 2;
/* The least width to start with; the standard deviation of a Gaussian a pixel wide at half
 * height. */
static const float LEAST_START = 0.4f, PER_FULL_WIDTH = (float)(1 / 2.3548);

static inline lanes lesser(lanes a, lanes b) { return where(a < b, a, b); }
static inline lanes greater(lanes a, lanes b) { return where(a > b, a, b); }

/* How far from its middle row each lane's profile first falls to the level; 0 for never. */
static lanes half_height_at(const Profile profile, int at, int reach, int way, lanes level)
{
    lanes inside = load(profile[reach] + at), outside = inside, far = all_lanes(0);
    for (int k = 1; k <= reach; k++) {
        const lanes pixel = load(profile[reach + way * k] + at);
        const lane_mask seeking = outside > level;
        inside = where(seeking, outside, inside);
        outside = where(seeking, pixel, outside);
        far = where(seeking, all_lanes((float)k), far);
    }
    const lanes away_px = far - (level - outside) / (inside - outside);
    return where((outside <= level) & (inside > level), away_px, all_lanes(0));
}

/* Background, height, centre and width of every lane's peak, by its width at half height. */
static void start_fits(Block *block, const Profile profile, int reach, float saturated)
{
    const lanes zero = all_lanes(0), one = all_lanes(1), middle = all_lanes((float)reach);
    const int end = 2 * reach;
    for (int at = 0; at < BLOCK; at += LANES) {
        lanes top = load(profile[reach] + at);
        for (int k = 1; k <= 2; k++)
            top = greater(greater(load(profile[reach - k] + at), load(profile[reach + k] + at)), top);
        lanes low = load(profile[0] + at) + load(profile[1] + at) + load(profile[2] + at);
        lanes high = load(profile[end] + at) + load(profile[end - 1] + at) + load(profile[end - 2] + at);
        low *= 1.0f / 3;
        high *= 1.0f / 3;
        const lanes background = lesser(low, high), height = top - background;
        const lanes level = 0.5f * (lesser(top, all_lanes(saturated)) + greater(low, high));
        const lanes up = half_height_at(profile, at, reach, -1, level);
        const lanes down = half_height_at(profile, at, reach, 1, level);
        const lane_mask whole = (up > zero) & (down > zero), lit = height > zero;
        const lanes left = middle - up, right = middle + down;
        lanes state = where(whole, all_lanes(PEAK), all_lanes(WIDER));
        state = where(lit & ~(whole & (right - left < one)), state, all_lanes(NO_PEAK));
        const lanes width = greater((right - left) * PER_FULL_WIDTH, all_lanes(LEAST_START));
        store(block->background + at, background);
        store(block->height + at, where(lit, height, one));
        store(block->state + at, state);
        store(block->centre + at, where(whole, 0.5f * (left + right), middle));
        store(block->sigma + at, where(whole, width, one));
    }
}

/* First and last row of a profile that the fit of any of sixteen lanes takes. */
static inline void rows_used(const Block *block, int at, int rows, int *first, int *last)
{
    const float begin = -highest(-load(block->first + at)), end = highest(load(block->last + at));
    *first = (int)max_f32(begin, 0);
    *last = (int)min_f32(max_f32(end, 0), (float)(rows - 1));
}

/* How many pixels of their windows are clipped, of sixteen lanes. */
static lanes count_clipped(const Block *block, const Profile profile, int at, int rows,
                           float saturated)
{
    const lanes first = load(block->first + at), last = load(block->last + at);
    lanes brightest = all_lanes(0), clipped = all_lanes(0);
    int begin, end;
    rows_used(block, at, rows, &begin, &end);
    for (int k = begin; k <= end; k++)
        brightest = greater(load(profile[k] + at), brightest);
    if (highest(brightest) < saturated)
        return clipped;
    for (int k = begin; k <= end; k++) {
        const lanes x = all_lanes((float)k);
        const lane_mask counts = (load(profile[k] + at) >= saturated) & (x >= first) & (x <= last);
        clipped += where(counts, all_lanes(1), all_lanes(0));
    }
    return clipped;
}

/* The largest whole numbers below, of sixteen. */
static inline lanes floor_of(lanes value)
{
    const lanes cut = __builtin_convertvector(__builtin_convertvector(value, lane_mask), lanes);
    return where(cut > value, cut - 1.0f, cut);
}

/* The pixels that every lane's fit takes: both flanks, even beside clipped pixels. A lane whose
 * window is longer than the profile needs a WIDER one. */
static void set_windows(Block *block, const Profile profile, int reach, float saturated)
{
    const int rows = 2 * reach + 1;
    for (int at = 0; at < BLOCK; at += LANES) {
        const lanes centre = load(block->centre + at);
        const lanes away = REACH * load(block->sigma + at) + REACH_PX;
        store(block->first + at, -floor_of(away - centre));
        store(block->last + at, floor_of(centre + away));
        const lanes clipped = count_clipped(block, profile, at, rows, saturated);
        const lanes out = where(clipped > 0.0f, all_lanes(BESIDE_CLIPPED_PX), all_lanes(0));
        const lanes first = load(block->first + at) - out, last = load(block->last + at) + out;
        const lane_mask is_short = (first < 0.0f) | (last > (float)(2 * reach));
        const lanes state = load(block->state + at);
        store(block->clipped + at, clipped);
        store(block->first + at, first);
        store(block->last + at, last);
        store(block->state + at, where(is_short, lesser(state, all_lanes(WIDER)), state));
    }
}
