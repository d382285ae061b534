/* How functions of a library are named for its callers.
 *
 * A library is compiled once for each processor variant, with VARIANT defined: v1 is the least
 * demanding. EXPORT(int64_t, find_peaks) begins the definition of crenel_v1_find_peaks and so on.
 * Everything else is static.
 *
 * Callers give all memory, and have checked all sizes (app/crenel/native/arguments.py). */
#ifndef CRENEL_EXPORT_H
#define CRENEL_EXPORT_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define JOIN_(a, b, c) a##b##_##c
#define JOIN(a, b, c) JOIN_(a, b, c)
#ifdef _WIN32
#define VISIBLE __declspec(dllexport)
#else
#define VISIBLE __attribute__((visibility("default")))
#endif
#define EXPORT(type, name) VISIBLE type JOIN(crenel_, VARIANT, name)

static inline double min_f64(double a, double b) { return a < b ? a : b; }
static inline double max_f64(double a, double b) { return a > b ? a : b; }
static inline float min_f32(float a, float b) { return a < b ? a : b; }
static inline float max_f32(float a, float b) { return a > b ? a : b; }
static inline int64_t min_i64(int64_t a, int64_t b) { return a < b ? a : b; }
static inline int64_t max_i64(int64_t a, int64_t b) { return a > b ? a : b; }

#endif
