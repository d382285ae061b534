/* Before a wide line is looked for: parts of the picture with several rows made one; before a thin
 * one: rows between the rows.
 *
 * A pixel is the mean of `factor` rows times `gain`, which makes use of 16 bits; where one of them
 * is clipped, it is clipped. Included with BITS defined. */
#include "pixel.h"

/* pixels (height, width); parts (part_count, 4) of the reduced picture; out (reduced, width). */
EXPORT(void, OF(reduce_rows))(int64_t height, int64_t width, int64_t part_count, int64_t reduced,
                              const PIXEL *pixels, const int64_t *parts, int64_t factor,
                              int64_t gain, int64_t saturated, uint16_t *out)
{
    /* saturated * gain is within 16 bits, so that products are within 32 */
    const uint32_t per_sum = (uint32_t)((gain << 12) / factor);
    const uint32_t full = (uint32_t)saturated;
    const int64_t rows = min_i64(reduced, height / factor);
    for (const int64_t *part = parts; part < parts + 4 * part_count; part += 4) {
        const int64_t columns = part[3] - part[2];
        for (int64_t row = part[0]; row < min_i64(part[1], rows); row++) {
            const PIXEL *from = pixels + row * factor * width + part[2];
            uint16_t *to = out + row * width + part[2];
            for (int64_t begin = 0; begin < columns; begin += 64) {
                const int64_t n = min_i64(64, columns - begin);
                uint32_t sum[64] = {0};
                PIXEL most[64] = {0};
                for (int64_t k = 0; k < factor; k++) {
                    const PIXEL *line = from + k * width + begin;
                    for (int64_t i = 0; i < n; i++) {
                        sum[i] += line[i];
                        most[i] = line[i] > most[i] ? line[i] : most[i];
                    }
                }
                for (int64_t i = 0; i < n; i++) {
                    const uint32_t mean = (sum[i] * per_sum) >> 12;
                    to[begin + i] = (uint16_t)(most[i] >= full ? full * (uint32_t)gain : mean);
                }
            }
        }
    }
}

/* Twice as many rows, a quarter of a row above and below each one, by linear interpolation; `out`
 * (doubled, width). No pixel is clipped: of a line that is thinner than a pixel, clipping hides
 * the brightness alone. */
EXPORT(void, OF(double_rows))(int64_t height, int64_t width, int64_t doubled, const PIXEL *pixels,
                              int64_t gain, int64_t saturated, uint16_t *out)
{
    for (int64_t row = 0; row < min_i64(2 * height, doubled); row++) {
        const int64_t own = row / 2, beside = own + (row % 2 ? 1 : -1);
        const PIXEL *near = pixels + own * width;
        const PIXEL *far = pixels + max_i64(0, min_i64(beside, height - 1)) * width;
        uint16_t *to = out + row * width;
        for (int64_t i = 0; i < width; i++) {
            const int64_t mean = (3 * (int64_t)near[i] + far[i]) * gain / 4;
            to[i] = (uint16_t)min_i64(mean, saturated * gain - 1);
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
