/* A clipped line, step 3: the pixels beside the core, sixteen columns at a time.
 * Included with BITS defined. */
#include "pixel.h"

#ifndef CRENEL_FLANKS
#define CRENEL_FLANKS

enum { NEAREST_PX = 4 }; /* pixels beside the core that the picture must hold */
/* The least height of clipping over the background, as a share of the clipping level. */
static const float LEAST_TOP = 0.2f;

/* The median of BACKGROUND_PX values each: bubbles the larger half to the end. */
static lanes median_away(lanes *values)
{
    for (int end = BACKGROUND_PX - 1; end >= BACKGROUND_PX / 2; end--) {
        for (int i = 0; i < end; i++) {
            lane_mask ordered = values[i] < values[i + 1];
            lanes low = where(ordered, values[i], values[i + 1]);
            values[i + 1] = where(ordered, values[i + 1], values[i]);
            values[i] = low;
        }
    }
    return values[BACKGROUND_PX / 2];
}

/* Keeps the cores that lie in the picture and shine clearly over both backgrounds; wide ones, whose
 * surroundings are lit by the line itself, anyway. */
static void keep_bright(Clipped *c, int64_t height, double saturated)
{
    int64_t n = 0;
    for (int64_t i = 0; i < c->cores; i++) {
        float above = (float)saturated - c->background[0][i];
        float below = (float)saturated - c->background[1][i];
        const bool dim = min_f32(above, below) <= LEAST_TOP * (float)saturated;
        if (c->first[i] < NEAREST_PX || c->last[i] + NEAREST_PX >= height ||
            (dim && c->last[i] - c->first[i] + 1 < HALO_CORE))
            continue;
        c->column[n] = c->column[i];
        c->first[n] = c->first[i];
        c->last[n] = c->last[i];
        c->background[0][n] = c->background[0][i];
        c->background[1][n] = c->background[1][i];
        c->top[0][n] = dim ? UNSEEN : above;
        c->top[1][n++] = dim ? UNSEEN : below;
    }
    c->cores = n;
}

#endif

/* The background of every core, above and below it. */
static void OF(read_backgrounds)(Clipped *c, const PIXEL *pixels, int64_t height)
{
    float values[BACKGROUND_PX][LANES];
    for (int64_t at = 0; at < c->cores; at += LANES) {
        for (int side = 0; side < 2; side++) {
            for (int k = 0; k < LANES; k++) {
                int64_t i = min_i64(at + k, c->cores - 1);
                const PIXEL *own = pixels + c->column[i];
                for (int j = 0; j < BACKGROUND_PX; j++) {
                    int out = FLANK + 1 + j;
                    int64_t row = side ? c->last[i] + out : c->first[i] - out;
                    /* beyond the picture's border, its own pixel is the best guess */
                    row = max_i64(0, min_i64(row, height - 1));
                    values[j][k] = (float)own[row * c->width];
                }
            }
            lanes sorted[BACKGROUND_PX];
            for (int j = 0; j < BACKGROUND_PX; j++)
                sorted[j] = load(values[j]);
            store(c->background[side] + at, median_away(sorted));
        }
    }
}

/* The signals beside every core, in shares of the height of clipping above it.
 *
 * Of a block's rows, the first FLANK lie above the core and the others below it, outwards. */
static void OF(read_signals)(Clipped *c, const PIXEL *pixels, int64_t height, double saturated)
{
    for (int64_t at = 0; at < c->cores; at += LANES) {
        float *block = c->signal + at * 2 * FLANK;
        for (int k = 0; k < LANES; k++) {
            int64_t i = at + k;
            for (int j = 0; j < 2 * FLANK; j++) {
                int side = j / FLANK, out = j % FLANK + 1;
                float signal = UNSEEN;
                if (i < c->cores) {
                    int64_t row = side ? c->last[i] + out : c->first[i] - out;
                    if (c->top[0][i] != UNSEEN && row >= 0 && row < height) {
                        float level = (float)pixels[row * c->width + c->column[i]];
                        if (level < (float)saturated)
                            signal = (level - c->background[side][i]) / c->top[0][i];
                    }
                }
                block[j * LANES + k] = signal;
            }
        }
    }
}

/* Reads the flanks of all cores; whether enough are bright. */
static bool OF(read_flanks)(Clipped *c, const PIXEL *pixels, int64_t height, double saturated)
{
    OF(read_backgrounds)(c, pixels, height);
    keep_bright(c, height, saturated);
    if (c->cores < FEWEST_COLUMNS)
        return false;
    OF(read_signals)(c, pixels, height, saturated);
    for (int64_t i = 0; i < c->cores; i++)
        if (c->top[0][i] == UNSEEN)
            c->top[0][i] = c->top[1][i] = 1;
    return true;
}
