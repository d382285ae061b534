/* Sorting numbers that the caller holds. */
#ifndef CRENEL_SORTING_H
#define CRENEL_SORTING_H

#include "export.h"

/* Sorts the values (n), ascending; spare (n) is overwritten. */
static void sort_f64(double *values, int64_t n, double *spare)
{
    enum { RUN = 12 }; /* so many are put in order by insertion, then runs are merged */
    for (int64_t begin = 0; begin < n; begin += RUN)
        for (int64_t i = begin + 1; i < min_i64(begin + RUN, n); i++) {
            double value = values[i];
            int64_t at = i;
            for (; at > begin && values[at - 1] > value; at--)
                values[at] = values[at - 1];
            values[at] = value;
        }
    double *from = values, *to = spare;
    for (int64_t run = RUN; run < n; run *= 2) {
        for (int64_t begin = 0; begin < n; begin += 2 * run) {
            int64_t i = begin, middle = min_i64(begin + run, n);
            int64_t j = middle, end = min_i64(middle + run, n), k = begin;
            while (i < middle && j < end) {
                bool first = from[i] <= from[j];
                to[k++] = first ? from[i] : from[j];
                i += first;
                j += !first;
            }
            while (i < middle)
                to[k++] = from[i++];
            while (j < end)
                to[k++] = from[j++];
        }
        double *other = from;
        from = to;
        to = other;
    }
    if (from != values)
        memcpy(values, from, (size_t)n * sizeof *values);
}

#endif
