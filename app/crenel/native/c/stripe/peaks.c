/* Step 3: lists the peaks of all columns, strip after strip, from the scores of the search.
 * Included with BITS defined. */
#include "pixel.h"

/* Peaks in neighbouring strips are two peaks where this many cores lie between them. */
#ifndef CRENEL_STRIPE_PEAKS
#define CRENEL_STRIPE_PEAKS
enum { APART = 6 };
#endif

/* Which of sixty-four columns hold a peak, as bits: scores above `least` that are no flank of a
 * higher one in a neighbouring strip. */
static inline uint64_t OF(peaks_at)(const PIXEL *score, const uint8_t *place, int64_t strip,
                                    OF(greys) least)
{
    const OF(greys) own = OF(load_greys)(score);
    const uint64_t high = OF(bits_of)(OF(over)(own, least));
    if (!high)
        return 0;
    /* where a cell is empty its place says nothing, and its score is below any other */
    const greys_8 at = load_greys_8(place), span = all_greys_8(STRIP - APART);
    const uint64_t near_above = bits_of_8(over_8(load_greys_8(place - strip), at + span));
    const uint64_t near_below = bits_of_8(over_8(at, load_greys_8(place + strip) + span));
    const uint64_t over_above = OF(bits_of)(OF(over)(own, OF(load_greys)(score - strip)));
    const uint64_t under_below = OF(bits_of)(OF(over)(OF(load_greys)(score + strip), own));
    return high & (over_above | ~near_above) & ~(under_below & near_below);
}

/* Fills columns, rows (to one or two) and scores of all peaks above a score; returns how many. */
static int64_t OF(list_peaks)(Workspace *work, double threshold)
{
    const double most = BITS == 8 ? 255 : 65535;
    const OF(greys) least = OF(all_greys)((PIXEL)max_f64(0, min_f64(threshold, most)));
    const PIXEL *scores = work->score;
    int64_t found = 0;
    for (int64_t s = 1; s < work->strips - 1; s++) {
        for (int64_t i = 0; i < work->padded; i += 64) {
            const int64_t here = s * work->padded + i;
            uint64_t left = OF(peaks_at)(scores + here, work->place + here, work->padded, least);
            for (; left && found < work->most_peaks; left &= left - 1) {
                const int64_t n = __builtin_ctzll(left);
                work->peak_columns[found] = (int32_t)(i + n);
                work->peak_rows[found] =
                    (int32_t)(((s - 1) * STRIP + work->place[here + n]) * STEP + 1);
                work->peak_heights[found] = scores[here + n];
                found++;
            }
        }
    }
    return found;
}
