/* Eight numbers of double precision side by side, for sums in inner loops.
 *
 * There are eight in every processor variant, so that all variants round alike. */
#ifndef CRENEL_DOUBLES_H
#define CRENEL_DOUBLES_H

#include "export.h"

enum { DOUBLES = 8 };

typedef double doubles __attribute__((vector_size(64)));
typedef doubles unaligned_doubles __attribute__((aligned(8)));

static inline doubles load_f64(const double *from) { return *(const unaligned_doubles *)from; }
static inline void store_f64(double *to, doubles value) { *(unaligned_doubles *)to = value; }

static inline double sum_f64(doubles value)
{
    return ((value[0] + value[4]) + (value[2] + value[6])) +
           ((value[1] + value[5]) + (value[3] + value[7]));
}

#endif
