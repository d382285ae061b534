/* Before a wide line is looked for: parts of the picture with several rows made one; before a thin
 * one: rows between the rows.
 *
 * A pixel is the mean of `factor` rows times `gain`, which makes use of 16 bits; where one of them
 * is clipped, it is clipped. Included with BITS defined. */
#include "pixel.h"

#define REDUCED_COLUMNS 64
/* Rows of the reduced picture whose pixels are asked for before they are needed. */
#define REDUCED_AHEAD 2

/* The sum of a column's rows: of up to 257 rows of 8 bits. */
#if BITS == 8
typedef uint16_t OF(row_sum);
#else
typedef uint32_t OF(row_sum);
#endif

/* `factor` rows made one in n columns, at most REDUCED_COLUMNS. */
static inline __attribute__((always_inline)) void
OF(reduce_columns)(int64_t n, const PIXEL *from, int64_t width, int64_t factor, uint32_t per_sum,
                   uint32_t gain, PIXEL full, uint16_t *to)
{
    OF(row_sum) sum[REDUCED_COLUMNS] = {0};
    PIXEL most[REDUCED_COLUMNS] = {0};
    for (int64_t k = 0; k < factor; k++) {
        const PIXEL *line = from + k * width;
        for (int64_t i = 0; i < n; i++) {
            sum[i] = (OF(row_sum))(sum[i] + line[i]);
            most[i] = line[i] > most[i] ? line[i] : most[i];
        }
    }
    for (int64_t i = 0; i < n; i++) {
        const uint32_t mean = (sum[i] * per_sum) >> 12;
        to[i] = (uint16_t)(most[i] >= full ? full * gain : mean);
    }
}

/* pixels (height, width); parts (part_count, 4) of the reduced picture; out (reduced, width). */
EXPORT(void, OF(reduce_rows))(int64_t height, int64_t width, int64_t part_count, int64_t reduced,
                              const PIXEL *pixels, const int64_t *parts, int64_t factor,
                              int64_t gain, int64_t saturated, uint16_t *out)
{
    /* saturated * gain is within 16 bits, so that products are within 32 */
    const uint32_t per_sum = (uint32_t)((gain << 12) / factor);
    const PIXEL full = (PIXEL)saturated;
    const int64_t rows = min_i64(reduced, height / factor);
    for (const int64_t *part = parts; part < parts + 4 * part_count; part += 4) {
        const int64_t behind = min_i64(part[1], rows);
        for (int64_t row = part[0]; row < behind; row++) {
            const PIXEL *from = pixels + row * factor * width;
            const PIXEL *ahead =
                pixels + min_i64(row + REDUCED_AHEAD, behind - 1) * factor * width;
            uint16_t *to = out + row * width;
            int64_t u = part[2];
            for (; u + REDUCED_COLUMNS <= part[3]; u += REDUCED_COLUMNS) {
                for (int64_t k = 0; k < factor; k++)
                    OF(fetch)(ahead + k * width + u, REDUCED_COLUMNS);
                OF(reduce_columns)(REDUCED_COLUMNS, from + u, width, factor, per_sum,
                                   (uint32_t)gain, full, to + u);
            }
            if (u < part[3])
                OF(reduce_columns)(part[3] - u, from + u, width, factor, per_sum, (uint32_t)gain,
                                   full, to + u);
        }
    }
}

/* Twice as many rows, a quarter of a row above and below each one, by linear interpolation; `out`
 * (doubled, width). No pixel is clipped: of a line that is thinner than a pixel, clipping hides
 * the brightness alone. */
EXPORT(void, OF(double_rows))(int64_t height, int64_t width, int64_t doubled, const PIXEL *pixels,
                              int64_t gain, int64_t saturated, uint16_t *out)
{
    /* the full scale of more than 8 bits is at least 511: products are within 32 bits */
    const uint32_t brightest = (uint32_t)(saturated * gain - 1);
    for (int64_t row = 0; row < min_i64(2 * height, doubled); row++) {
        const int64_t own = row / 2, beside = own + (row % 2 ? 1 : -1);
        const PIXEL *near = pixels + own * width;
        const PIXEL *far = pixels + max_i64(0, min_i64(beside, height - 1)) * width;
        uint16_t *to = out + row * width;
        for (int64_t i = 0; i < width; i++) {
            const uint32_t mean = (3 * (uint32_t)near[i] + far[i]) * (uint32_t)gain / 4;
            to[i] = (uint16_t)(mean < brightest ? mean : brightest);
        }
    }
}

#if BITS == 16
/* The highest pixel of parts of the picture (height, width). */
EXPORT(int64_t, highest_in_parts)(int64_t height, int64_t width, int64_t part_count,
                                  const uint16_t *pixels, const int64_t *parts)
{
    uint16_t most[64] = {0}, highest = 0;
    for (const int64_t *part = parts; part < parts + 4 * part_count; part += 4) {
        for (int64_t row = part[0]; row < min_i64(part[1], height); row++) {
            const uint16_t *line = pixels + row * width;
            for (int64_t begin = part[2]; begin < part[3]; begin += 64) {
                const int64_t n = min_i64(64, part[3] - begin);
                for (int64_t i = 0; i < n; i++)
                    most[i] = line[begin + i] > most[i] ? line[begin + i] : most[i];
            }
        }
    }
    for (int i = 0; i < 64; i++)
        highest = most[i] > highest ? most[i] : highest;
    return highest;
}
#endif
