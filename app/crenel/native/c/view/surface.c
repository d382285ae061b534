/* The surface on which the points of the 3D view lie (app/crenel/station/view3d/surface_look.py).
 *
 * Neighbours are found by cubes as wide as the radius; the points of a cube, and of those that
 * share its slot, are a chain: heads its first point, next the one after each, counted from 1. */
#include "../export.h"

#include "../vectors.h"

enum { MOST_NEIGHBOURS = 100, FEWEST_NEIGHBOURS = 6 };
/* Points of a line are larger than the distance between them by this factor at most. */
static const double MOST_SPACINGS = 3;
/* Neighbours lie on a surface if they spread over two directions, and little over the third. */
static const double LEAST_WIDTH = 0.03, MOST_THICKNESS = 0.3;

static int64_t chain_of(int64_t x, int64_t y, int64_t z, int64_t slots)
{
    uint64_t key = (uint64_t)x * 0x9E3779B97F4A7C15u ^ (uint64_t)y * 0xC2B2AE3D27D4EB4Fu ^
                   (uint64_t)z * 0x165667B19E3779F9u;
    return (int64_t)((key ^ key >> 32) & ((uint64_t)slots - 1));
}

/* The sums over neighbours of a point: number, differences, and their products xx xy xz yy yz zz. */
typedef struct {
    int64_t count;
    double first[3], second[6];
} Spread;

static Spread spread_around(const float *points, const float *point, double radius, int64_t slots,
                            const int32_t *heads, const int32_t *next)
{
    static const int8_t order[3] = {0, -1, 1}; /* its own cube first */
    Spread spread = {0};
    int64_t cube[3];
    for (int k = 0; k < 3; k++)
        cube[k] = (int64_t)floor((double)point[k] / radius);
    for (int at = 0; at < 27; at++) {
        int64_t chain = chain_of(cube[0] + order[at % 3], cube[1] + order[at / 3 % 3],
                                 cube[2] + order[at / 9], slots);
        for (int32_t j = heads[chain]; j != 0; j = next[j - 1]) {
            const float *other = points + 3 * (int64_t)(j - 1);
            double d[3] = {other[0] - point[0], other[1] - point[1], other[2] - point[2]};
            if (dot_3(d, d) > radius * radius)
                continue;
            spread.count++;
            for (int k = 0, m = 0; k < 3; k++) {
                spread.first[k] += d[k];
                for (int l = k; l < 3; l++)
                    spread.second[m++] += d[k] * d[l];
            }
            if (spread.count == MOST_NEIGHBOURS)
                return spread;
        }
    }
    return spread;
}

/* The direction in which neighbours spread least, of unit length; false if they are not spread
 * over a surface. Eigenvalues of the covariance by Smith's trigonometric solution. */
static bool normal_of(const Spread *spread, double *normal)
{
    if (spread->count < FEWEST_NEIGHBOURS)
        return false;
    double C[3][3], n = (double)spread->count;
    for (int k = 0, m = 0; k < 3; k++)
        for (int l = k; l < 3; l++, m++)
            C[k][l] = C[l][k] = spread->second[m] / n - spread->first[k] * spread->first[l] / n / n;
    double mean = (C[0][0] + C[1][1] + C[2][2]) / 3, square = 0;
    for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++) {
            double value = C[k][l] - (k == l) * mean;
            square += value * value;
        }
    double size = sqrt(square / 6);
    if (!(size > 0))
        return false;
    double minors[3], rows[3][3];
    for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++)
            rows[k][l] = (C[k][l] - (k == l) * mean) / size;
    cross_3(rows[1], rows[2], minors);
    double angle = acos(fmax(-1, fmin(1, dot_3(rows[0], minors) / 2))) / 3;
    double largest = mean + 2 * size * cos(angle);
    double smallest = mean + 2 * size * cos(angle + 2.0943951023931953); /* a third of a turn */
    double middle = 3 * mean - largest - smallest;
    if (middle < LEAST_WIDTH * largest || smallest > MOST_THICKNESS * middle)
        return false;
    for (int k = 0; k < 3; k++)
        C[k][k] -= smallest;
    double longest = 0;
    for (int k = 0; k < 3; k++) {
        double across[3];
        cross_3(C[k], C[(k + 1) % 3], across);
        double length = dot_3(across, across);
        if (length > longest) {
            longest = length;
            memcpy(normal, across, sizeof across);
        }
    }
    if (!(longest > 0))
        return false;
    normalise_3(normal);
    return true;
}

/* Normals (n, 3) of the points (n, 3), in mm, by their neighbours within the radius, of which every
 * stride-th counts; only of points whose normal is still zero, and zero where there is no surface.
 * spacing_mm (n) is the distance of points along their line while there are no neighbours on a
 * surface, then the side of a square of it that has one point. heads (slots, a power of two) and
 * next (n) are workspace. */
EXPORT(void, find_surface)(int64_t n, int64_t slots, const float *points_mm, double radius_mm,
                           int64_t stride, int32_t *heads, int32_t *next, float *normals,
                           float *spacing_mm)
{
    const double pi = 3.141592653589793;
    memset(heads, 0, (size_t)slots * sizeof *heads);
    for (int64_t i = 0; i < n; i += stride) {
        const float *point = points_mm + 3 * i;
        int64_t chain = chain_of((int64_t)floor(point[0] / radius_mm),
                                 (int64_t)floor(point[1] / radius_mm),
                                 (int64_t)floor(point[2] / radius_mm), slots);
        next[i] = heads[chain];
        heads[chain] = (int32_t)(i + 1);
    }
    for (int64_t i = 0; i < n; i++) {
        float *normal = normals + 3 * i;
        if (normal[0] != 0 || normal[1] != 0 || normal[2] != 0)
            continue;
        Spread spread = spread_around(points_mm, points_mm + 3 * i, radius_mm, slots, heads, next);
        double found[3], count = (double)(spread.count * stride);
        if (normal_of(&spread, found)) {
            for (int k = 0; k < 3; k++)
                normal[k] = (float)found[k];
            double side = radius_mm * sqrt(pi / count), along = spacing_mm[i];
            spacing_mm[i] = (float)(along > 0 ? fmin(side, MOST_SPACINGS * along) : side);
        } else if (spacing_mm[i] == 0)
            spacing_mm[i] = (float)(2 * radius_mm / fmax(count, 1));
    }
}
