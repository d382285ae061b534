/* Between frames: which parts of the next frame are read, by where the stripe was.
 *
 * Parts are rows of four: first row, the one behind the last, first column, the one behind the
 * last. Columns are read over the same rows in blocks of BLOCK_PX. */

enum { BLOCK_PX = 256 };
/* Neighbours of a block whose points count, too. */
enum { BESIDE_PX = 24 };
/* Beginning a row costs as much as reading this many of its pixels. */
enum { ROW_PX = 2000 };
/* Once in so many frames the whole picture is read, for what comes into view elsewhere. */
enum { WHOLE_EVERY = 6 };
/* The surroundings, in rows, that a peak's score needs. */
enum { SURROUNDINGS = ((AWAY + 2) * STEP + CORE_ROWS) / 2 + 4 };

/* What reading a part costs, in pixels. */
static int64_t cost_of(int64_t rows, int64_t columns) { return rows * (ROW_PX + columns); }

static int64_t cost_of_part(const int64_t *part)
{
    return cost_of(part[1] - part[0], part[3] - part[2]);
}

/* The lowest and the highest row of the points in or beside a block; false where there is none. */
static bool find_rows(const double *along, const double *across, int64_t n, int64_t left,
                      int64_t right, double *lowest, double *furthest)
{
    *lowest = INFINITY;
    *furthest = -INFINITY;
    for (int64_t p = 0; p < n; p++) {
        const int64_t column = (int64_t)along[p];
        if (column + BESIDE_PX < left || column - BESIDE_PX >= right)
            continue;
        *lowest = min_f64(*lowest, across[p]);
        *furthest = max_f64(*furthest, across[p]);
    }
    return *lowest <= *furthest;
}

/* Makes a part of a block and the one before it where that is no dearer; whether it did. */
static bool merge_parts(int64_t *before, const int64_t *part)
{
    const int64_t both[4] = {min_i64(before[0], part[0]), max_i64(before[1], part[1]), before[2],
                             part[3]};
    if (before[3] != part[2] || cost_of_part(both) > cost_of_part(before) + cost_of_part(part))
        return false;
    memcpy(before, both, sizeof both);
    return true;
}

/* Fills the parts to read; returns how many: one, the whole picture, if due or no dearer.
 *
 * along, across (n): where the stripe was. whole (blocks): which blocks are read over their whole
 * height. margin_px: rows that the stripe may have moved by. turn: counts the frames. */
EXPORT(int64_t, plan_parts)(int64_t n, int64_t blocks, int64_t most, const double *along,
                            const double *across, const uint8_t *whole, int64_t height,
                            int64_t width, int64_t margin_px, int64_t turn, int64_t *parts)
{
    const int64_t everything[4] = {0, height, 0, width}, reach = margin_px + SURROUNDINGS;
    int64_t found = 0, spent = 0;
    for (int64_t b = 0; b < blocks && n > 0; b++) {
        const int64_t left = b * BLOCK_PX, right = min_i64(left + BLOCK_PX, width);
        double lowest, furthest;
        const bool seen = find_rows(along, across, n, left, right, &lowest, &furthest);
        if (!whole[b] && !seen)
            continue;
        int64_t part[4] = {0, height, left, right};
        if (!whole[b]) {
            part[0] = max_i64((int64_t)lowest - reach, 0);
            part[1] = min_i64((int64_t)furthest + reach + 1, height);
        }
        if ((found == 0 || !merge_parts(parts + 4 * (found - 1), part)) && found < most)
            memcpy(parts + 4 * found++, part, sizeof part);
    }
    for (int64_t p = 0; p < found; p++)
        spent += cost_of_part(parts + 4 * p);
    if (n > 0 && turn % WHOLE_EVERY != 0 && spent < cost_of_part(everything))
        return found;
    memcpy(parts, everything, sizeof everything);
    return 1;
}

/* Fills how many of the points (n) lie in each block. */
EXPORT(void, count_in_blocks)(int64_t n, int64_t blocks, const double *along, int64_t *counts)
{
    memset(counts, 0, (size_t)blocks * sizeof *counts);
    for (int64_t p = 0; p < n; p++)
        counts[min_i64((int64_t)along[p] / BLOCK_PX, blocks - 1)]++;
}
