/* What the detector adds: speckle, noise, and the limits of its numbers. */

enum { TILE = 512 };

/* Multiplies the laser's light (height, width) by the speckle (512, 512), in place. */
EXPORT(void, speckle)(int64_t height, int64_t width, float *light, const float *tile,
                      int64_t shift_rows, int64_t shift_columns)
{
    for (int64_t r = 0; r < height; r++) {
        const float *grains = tile + TILE * ((r + shift_rows) & (TILE - 1));
        for (int64_t c = 0; c < width; c++)
            light[r * width + c] *= grains[(c + shift_columns) & (TILE - 1)];
    }
}

#define PIXEL uint8_t
#define OF(name) name##_8
#include "digitise.c"
#undef PIXEL
#undef OF

#define PIXEL uint16_t
#define OF(name) name##_16
#include "digitise.c"
#undef PIXEL
#undef OF
