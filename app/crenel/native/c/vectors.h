/* Vectors of three numbers. */
#ifndef CRENEL_VECTORS_H
#define CRENEL_VECTORS_H

#include "export.h"

static inline double dot_3(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross_3(const double *a, const double *b, double *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Makes a vector one of unit length; its length before. */
static inline double normalise_3(double *a)
{
    double size = sqrt(dot_3(a, a));
    for (int k = 0; k < 3; k++)
        a[k] /= size;
    return size;
}

#endif
