/* The closest point of a mesh to each of many points, exactly, with the sign of its side. */
#include "boxes.h"

#include "../vectors.h"

/* How a closest point lies on its triangle: inside, at a corner (1 to 3), or on the edge from one
 * corner to the next (4 to 6). */
enum { INSIDE = 0, CORNER = 1, EDGE = 4, DEEPEST = 128 };
/* By which rounding to single precision may make a distance larger, of the largest coordinate. */
static const float ROUNDED = 4e-7f, SQUARED = 1 - 1e-6f;

typedef struct {
    double square, at[3];
    int32_t place, part;
} Closest;

/* Takes a point of a triangle if none before was closer; `away` is from it to the point. */
static inline void take_closer(Closest *best, const double *away, const double *point,
                               int64_t place, int part)
{
    double square = dot_3(away, away);
    if (!(square < best->square)) /* not of NaN, either */
        return;
    best->square = square;
    for (int k = 0; k < 3; k++)
        best->at[k] = point[k] - away[k];
    best->place = (int32_t)place;
    best->part = part;
}

/* A point of the triangle: its first corner and two shares of its sides, from the point p. */
static inline void away_from(const double *p, const double *triangle, double v, double w,
                             double *away)
{
    for (int k = 0; k < 3; k++)
        away[k] = p[k] - (triangle[k] + v * triangle[3 + k] + w * triangle[6 + k]);
}

/* The closest point of a triangle, given as corner and two sides from it.
 *
 * Ericson, Real-Time Collision Detection (2005), 5.1.5: by the region in which the point lies. */
static void compare_triangle(const double *triangle, const double *p, int64_t place, Closest *best)
{
    const double *ab = triangle + 3, *ac = triangle + 6;
    double ap[3], bp[3], cp[3], away[3];
    for (int k = 0; k < 3; k++) {
        ap[k] = p[k] - triangle[k];
        bp[k] = ap[k] - ab[k];
        cp[k] = ap[k] - ac[k];
    }
    double d1 = dot_3(ab, ap), d2 = dot_3(ac, ap), d3 = dot_3(ab, bp), d4 = dot_3(ac, bp);
    double d5 = dot_3(ab, cp), d6 = dot_3(ac, cp);
    double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    double v = 0, w = 0;
    int part = INSIDE;
    if (d1 <= 0 && d2 <= 0)
        part = CORNER;
    else if (d3 >= 0 && d4 <= d3)
        v = 1, part = CORNER + 1;
    else if (d6 >= 0 && d5 <= d6)
        w = 1, part = CORNER + 2;
    else if (vc <= 0 && d1 >= 0 && d3 <= 0)
        v = d1 / (d1 - d3), part = EDGE;
    else if (vb <= 0 && d2 >= 0 && d6 <= 0)
        w = d2 / (d2 - d6), part = EDGE + 2;
    else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        v = 1 - w, part = EDGE + 1;
    } else {
        double all = va + vb + vc;
        v = vb / all;
        w = vc / all;
    }
    away_from(p, triangle, v, w, away);
    take_closer(best, away, p, place, part);
}

typedef struct {
    float square;
    int32_t child;
} Waiting;

/* Adds the children of a node that may be closer to those that wait, the closest last. */
static inline int push_children(const float *boxes, const int32_t *children, const float *low,
                                const float *high, float limit, Waiting *waiting, int count)
{
    floats sum = all_floats(0), zero = all_floats(0);
    for (int k = 0; k < 3; k++) {
        floats before = load_floats(boxes + k * CHILDREN) - all_floats(high[k]);
        floats behind = all_floats(low[k]) - load_floats(boxes + (3 + k) * CHILDREN);
        floats apart = larger_floats(zero, larger_floats(before, behind));
        sum += apart * apart;
    }
    float squares[CHILDREN];
    store_floats(squares, sum * all_floats(SQUARED));
    int first = count;
    /* few of the eight are closer: a bit of each is tested, not each of them */
    for (uint32_t closer = less_bits(load_floats(squares), all_floats(limit)); closer != 0;
         closer &= closer - 1) {
        int i = __builtin_ctz(closer), at = count++;
        for (; at > first && waiting[at - 1].square < squares[i]; at--)
            waiting[at] = waiting[at - 1];
        waiting[at] = (Waiting){squares[i], children[i]};
    }
    return count;
}

/* Looks for what is closer than the best so far, which is of the triangle at a place before. */
static void search_tree(const float *boxes, const int32_t *children, const double *triangles,
                        const double *p, int64_t before, Closest *best)
{
    float low[3], high[3], farthest = 0;
    for (int k = 0; k < 3; k++)
        farthest = max_f32(farthest, fabsf((float)p[k]));
    for (int k = 0; k < 3; k++) {
        low[k] = (float)p[k] - ROUNDED * farthest;
        high[k] = (float)p[k] + ROUNDED * farthest;
    }
    Waiting waiting[DEEPEST] = {{0, 0}};
    int count = 1;
    while (count > 0) {
        Waiting next = waiting[--count];
        if ((double)next.square >= best->square)
            continue;
        if (next.child < 0) {
            int64_t place = -1 - (int64_t)next.child;
            if (place != before)
                compare_triangle(triangles + 9 * place, p, place, best);
            continue;
        }
        float limit = nextafterf((float)best->square, INFINITY);
        count = push_children(boxes + (int64_t)next.child * 6 * CHILDREN,
                              children + (int64_t)next.child * CHILDREN, low, high, limit, waiting,
                              count);
    }
}

/* The direction that says on which side a point lies whose closest point is this: of a face its
 * normal, of edges and corners the mean of the faces around, weighted by their angles. */
static const double *side_of(const Closest *best, const int32_t *order, const double *face_normals,
                             const double *edge_normals, const double *corner_normals,
                             const int32_t *edges, const int32_t *corners)
{
    int64_t face = order[best->place];
    if (best->part == INSIDE)
        return face_normals + 3 * face;
    if (best->part >= EDGE)
        return edge_normals + 3 * (int64_t)edges[3 * face + best->part - EDGE];
    return corner_normals + 3 * (int64_t)corners[3 * face + best->part - CORNER];
}

/* The closest points of a mesh to points (n, 3), relative to the same middle as the tree.
 *
 * triangles (t, 3, 3): in the order of the tree, a corner and two sides. Faces, edges and corners
 * have the numbers of the mesh. Filled: at (n, 3) the closest points, distance (n), positive
 * outside, normals (n, 3) of the surface there, outwards, and faces (n). Points beyond the band
 * have face -1, and NaN. Each begins with the triangle that was closest to the one before. */
EXPORT(void, find_closest)(int64_t n, int64_t nodes, int64_t t, int64_t e, int64_t c,
                           const double *points, const float *boxes, const int32_t *children,
                           const double *triangles, const int32_t *order, const int32_t *edges,
                           const int32_t *corners, const double *face_normals,
                           const double *edge_normals, const double *corner_normals, double band,
                           double *at, double *distance, double *normals, int32_t *faces)
{
    (void)nodes, (void)t, (void)e, (void)c;
    int64_t before = 0;
    for (int64_t i = 0; i < n; i++) {
        const double *p = points + 3 * i;
        Closest best = {band * band, {NAN, NAN, NAN}, -1, INSIDE};
        compare_triangle(triangles + 9 * before, p, before, &best);
        search_tree(boxes, children, triangles, p, before, &best);
        memcpy(at + 3 * i, best.at, sizeof best.at);
        double *normal = normals + 3 * i;
        if (best.place < 0) {
            distance[i] = normal[0] = normal[1] = normal[2] = NAN;
            faces[i] = -1;
            continue;
        }
        before = best.place;
        const double *side = side_of(&best, order, face_normals, edge_normals, corner_normals,
                                     edges, corners);
        double away[3] = {p[0] - best.at[0], p[1] - best.at[1], p[2] - best.at[2]};
        distance[i] = copysign(sqrt(best.square), dot_3(away, side));
        memcpy(normal, side, 3 * sizeof *normal);
        if (best.part != INSIDE)
            normalise_3(normal);
        faces[i] = order[best.place];
    }
}
