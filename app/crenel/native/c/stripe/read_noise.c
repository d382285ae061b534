/* Step 2: the variance of a dark pixel, from differences of neighbouring pixels.
 * Included with BITS defined. */
#include "pixel.h"

#ifndef CRENEL_STRIPE_READ_NOISE
#define CRENEL_STRIPE_READ_NOISE
/* Pieces of rows, evenly over the picture, whose neighbours are compared, and their length. */
enum { PIECES = 32, PIECE_PX = 192 };

/* How often neighbours differ by so many levels; the lists are counted in turn, since a count
 * waits for the one before it. */
static int64_t count_at(const int32_t *counts, int64_t levels, int64_t level)
{
    int64_t sum = 0;
    for (int i = 0; i < COUNT_LISTS; i++)
        sum += counts[i * levels + level];
    return sum;
}

/* Half the mean squared difference of those up to about three times their median: most of a
 * picture is unlit, so the bulk of the differences is noise and the rest is scene. Rounding adds
 * 1/12 at least. */
static double variance_of(const int32_t *counts, int64_t levels, int64_t number)
{
    int64_t median = 0, seen = 0, here;
    while (seen + (here = count_at(counts, levels, median)) < number / 2.0) {
        seen += here;
        median++;
    }
    int64_t kept = 0;
    double squares = 0;
    for (int64_t level = 0; level < min_i64(4 * median + 3, levels - 1); level++) {
        const int64_t alike = count_at(counts, levels, level);
        kept += alike;
        squares += (double)(alike * level * level);
    }
    return max_f64(squares / (double)max_i64(kept, 1) / 2, 1.0 / 12);
}
#endif

/* By how much a pixel differs from the next, up to `most`, of so many that follow one another. */
static void OF(differences)(const PIXEL *pixels, int64_t count, int32_t most, int32_t *out)
{
    for (int64_t i = 0; i < count; i++) {
        const int32_t difference = (int32_t)pixels[i] - (int32_t)pixels[i + 1];
        const int32_t level = difference < 0 ? -difference : difference;
        out[i] = level < most ? level : most;
    }
}

/* The variance of a dark pixel in grey levels squared. */
static double OF(read_noise)(Workspace *work)
{
    const int64_t height = work->height, width = work->width, levels = work->count_levels;
    const int64_t pieces = min_i64(PIECES, height), length = min_i64(PIECE_PX, width - 1);
    int32_t level[PIECE_PX], *counts = work->counts;
    memset(counts, 0, (size_t)(COUNT_LISTS * levels) * sizeof *counts);
    for (int64_t piece = 0; piece < pieces; piece++) {
        /* a third of the width further on each time, so that no place is left out */
        const int64_t row = (2 * piece + 1) * height / (2 * pieces);
        const int64_t first = (piece * width / 3 + piece * length) % (width - length);
        const PIXEL *part = (const PIXEL *)work->pixels + row * width + first;
        OF(differences)(part, length, (int32_t)levels - 1, level);
        int64_t i = 0;
        for (; i + COUNT_LISTS <= length; i += COUNT_LISTS)
            for (int list = 0; list < COUNT_LISTS; list++)
                counts[list * levels + level[i + list]]++;
        for (; i < length; i++)
            counts[level[i]]++;
    }
    return variance_of(counts, levels, pieces * length);
}
