/* The tree of boxes about the triangles of a mesh (app/crenel/parts/cad/maths_closest.py).
 *
 * A node has eight children, each another node or one triangle. Its boxes hold single precision,
 * rounded outwards, side by side: all eight are compared with a point at once. Exact distances are
 * of double precision, from the triangles alone. Coordinates are relative to the mesh's middle. */
#ifndef CRENEL_BOXES_H
#define CRENEL_BOXES_H

#include "../export.h"

enum { CHILDREN = 8 };

typedef float floats __attribute__((vector_size(32)));
typedef int32_t float_mask __attribute__((vector_size(32))); /* -1 where it holds, else 0 */
typedef floats unaligned_floats __attribute__((aligned(4), may_alias));

static inline floats load_floats(const float *from) { return *(const unaligned_floats *)from; }
static inline void store_floats(float *to, floats value) { *(unaligned_floats *)to = value; }

static inline floats all_floats(float value)
{
    return (floats){value, value, value, value, value, value, value, value};
}

static inline floats larger_floats(floats a, floats b)
{
    float_mask first = a > b;
    return (floats)((first & (float_mask)a) | (~first & (float_mask)b));
}

/* A bit for each of the eight that is less. */
static inline uint32_t less_bits(floats a, floats b)
{
    const float_mask bits = {1, 2, 4, 8, 16, 32, 64, 128};
    float_mask less = (a < b) & bits;
    uint32_t sum = 0;
    for (int i = 0; i < CHILDREN; i++)
        sum |= (uint32_t)less[i];
    return sum;
}

/* Bounds of one child: low x y z, high x y z. */
typedef struct {
    float side[6];
} Box;

/* Of the child at a place among eight, in a node's box of 6 x 8 numbers. */
static inline void set_box(float *boxes, int place, const Box *box)
{
    for (int k = 0; k < 6; k++)
        boxes[k * CHILDREN + place] = box->side[k];
}

#endif
