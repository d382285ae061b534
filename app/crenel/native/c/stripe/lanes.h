/* Sixteen numbers of single precision side by side, for the innermost loops.
 *
 * A sum of this type stays in registers from a loop's first turn to its last. On a processor with
 * narrower registers the compiler takes several for one. There are sixteen in every variant, so
 * that no point moves from processor to processor. */
#ifndef CRENEL_LANES_H
#define CRENEL_LANES_H

#include "../export.h"

enum { LANES = 16 };

typedef float lanes __attribute__((vector_size(64)));
typedef int32_t lane_mask __attribute__((vector_size(64))); /* -1 where it holds, else 0 */
typedef lanes unaligned_lanes __attribute__((aligned(4), may_alias));

static inline lanes load(const float *from) { return *(const unaligned_lanes *)from; }
static inline void store(float *to, lanes value) { *(unaligned_lanes *)to = value; }

static inline lanes all_lanes(float value)
{
    return (lanes){value, value, value, value, value, value, value, value,
                   value, value, value, value, value, value, value, value};
}

/* `one` where the mask holds, `other` elsewhere. */
static inline lanes where(lane_mask mask, lanes one, lanes other)
{
    return (lanes)((mask & (lane_mask)one) | (~mask & (lane_mask)other));
}

/* The largest of the sixteen: the larger of two halves, again and again. */
static inline float highest(lanes value)
{
    float part[LANES];
    store(part, value);
    for (int half = LANES / 2; half > 0; half /= 2)
        for (int i = 0; i < half; i++)
            part[i] = part[i] > part[i + half] ? part[i] : part[i + half];
    return part[0];
}

#endif
