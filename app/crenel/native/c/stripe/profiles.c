/* Step 5: takes the pixels about the peaks of a block, side by side, so that every further step is
 * one for all columns of the block. Included with BITS defined. */
#include "pixel.h"

/* Sixteen pixels as numbers. */
static inline lanes OF(load_pixels)(const PIXEL *from)
{
    typedef PIXEL few __attribute__((vector_size(LANES * sizeof(PIXEL))));
    typedef few unaligned_few __attribute__((aligned(sizeof(PIXEL)), may_alias));
    return __builtin_convertvector(*(const unaligned_few *)from, lanes);
}

/* Moves the rows of n peaks to the brightest pixel of their core, from the row before on. */
static void OF(move_to_brightest)(const Workspace *work, int64_t n)
{
    const PIXEL *pixels = work->pixels;
    for (int64_t i = 0; i < n; i++) {
        const PIXEL *at = pixels + (work->rows[i] - 1) * work->width + work->columns[i];
        int best = 0;
        PIXEL top = *at;
        for (int k = 1; k < CORE_ROWS; k++) {
            at += work->width;
            if (*at > top) {
                best = k;
                top = *at;
            }
        }
        work->rows[i] += best - 1;
    }
}

/* For sixteen columns side by side, whose peaks' rows are `over` the lowest one by up to `apart`:
 * reads whole rows from `first` on, then lifts every lane by its own number of rows. */
static void OF(gather_neighbours)(const PIXEL *first, int64_t line, lanes over, int apart,
                                  int reach, Profile profile, int at)
{
    const int last = 2 * reach + 1;
    for (int k = 0; k < last + apart; k++)
        store(profile[k] + at, OF(load_pixels)(first + k * line));
    /* by sixteen rows where it is that many, then by eight, ... */
    for (int leap = 16; leap > 0; leap /= 2) {
        if (leap > apart)
            continue;
        const lane_mask goes = over >= (float)leap;
        const int rows = last + (leap - 1 < apart - leap ? leap - 1 : apart - leap);
        for (int k = 0; k < rows; k++) {
            const lanes there = load(profile[k + leap] + at), here = load(profile[k] + at);
            store(profile[k] + at, where(goes, there, here));
        }
        over = where(goes, over - (float)leap, over);
    }
}

/* For sixteen columns wherever they are; rows beyond the picture repeat its border. */
static void OF(gather_apart)(const Workspace *work, const int32_t *columns, const int32_t *rows,
                             int64_t n, int reach, Profile profile, int at)
{
    PIXEL raw[2 * WIDEST_REACH + 1][LANES];
    const PIXEL *pixels = work->pixels;
    for (int i = 0; i < LANES; i++) {
        const int64_t one = min_i64(at + i, n - 1), row = rows[one] - reach;
        const PIXEL *column = pixels + columns[one];
        if (row >= 0 && row + 2 * reach < work->height) {
            for (int k = 0; k <= 2 * reach; k++)
                raw[k][i] = column[(row + k) * work->width];
        } else {
            for (int k = 0; k <= 2 * reach; k++) {
                const int64_t inside = min_i64(max_i64(row + k, 0), work->height - 1);
                raw[k][i] = column[inside * work->width];
            }
        }
    }
    for (int k = 0; k <= 2 * reach; k++)
        store(profile[k] + at, OF(load_pixels)(raw[k]));
}

/* Takes the pixels about n peaks of a block, `reach` rows to either side; the last peak fills up
 * the block. */
static void OF(gather)(const Workspace *work, const int32_t *columns, const int32_t *rows,
                       int64_t n, int reach, Profile profile)
{
    const PIXEL *pixels = work->pixels;
    for (int at = 0; at < BLOCK; at += LANES) {
        const int behind = at + LANES;
        if (behind <= n && columns[behind - 1] - columns[at] == LANES - 1) {
            int32_t lowest = rows[at], furthest = rows[at];
            for (int i = at; i < behind; i++) {
                lowest = rows[i] < lowest ? rows[i] : lowest;
                furthest = rows[i] > furthest ? rows[i] : furthest;
            }
            const bool inside = lowest >= reach && furthest + reach < work->height;
            if (inside && furthest - lowest <= MOST_APART) {
                float over[LANES];
                for (int i = 0; i < LANES; i++)
                    over[i] = (float)(rows[at + i] - lowest);
                const PIXEL *first = pixels + (lowest - reach) * work->width + columns[at];
                OF(gather_neighbours)(first, work->width, load(over), furthest - lowest, reach,
                                      profile, at);
                continue;
            }
        }
        OF(gather_apart)(work, columns, rows, n, reach, profile, at);
    }
}

/* The pixels alone, `reach` rows about n peaks: fills the profile (PROFILE_ROWS, BLOCK). */
EXPORT(void, OF(gather))(int64_t n, const int32_t *columns, const int32_t *rows, Workspace *work,
                         int64_t reach, Profile profile)
{
    OF(gather)(work, columns, rows, n, (int)reach, profile);
}
