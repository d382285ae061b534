/* Builds the tree of boxes: triangles are halved at the median of their centres along the longest
 * side, so that whole eighths are full. */
#include "boxes.h"

/* A triangle while the tree is built: the middle of its box, and its number. */
typedef struct {
    float middle[3];
    int32_t number;
} Centred;

typedef struct {
    const double *corners; /* (t, 3, 3) */
    Centred *pieces;
    float *boxes;
    int32_t *children;
    int64_t nodes;
} Building;

static Box box_of(const double *corners)
{
    Box box;
    for (int k = 0; k < 3; k++) {
        double low = min_f64(corners[k], min_f64(corners[3 + k], corners[6 + k]));
        double high = max_f64(corners[k], max_f64(corners[3 + k], corners[6 + k]));
        float below = (float)low, above = (float)high;
        box.side[k] = (double)below > low ? nextafterf(below, -INFINITY) : below;
        box.side[3 + k] = (double)above < high ? nextafterf(above, INFINITY) : above;
    }
    return box;
}

static void swap_pieces(Centred *pieces, int64_t a, int64_t b)
{
    Centred one = pieces[a];
    pieces[a] = pieces[b];
    pieces[b] = one;
}

/* Orders pieces from begin to end so that those before `at` are not above those behind it. */
static void part_pieces(Centred *pieces, int64_t begin, int64_t end, int64_t at, int axis)
{
    int64_t low = begin, high = end - 1;
    while (low < high) {
        int64_t middle = low + (high - low) / 2;
        float a = pieces[low].middle[axis], b = pieces[middle].middle[axis];
        float c = pieces[high].middle[axis];
        float pivot = max_f32(min_f32(a, b), min_f32(max_f32(a, b), c)); /* their median */
        int64_t i = low, j = high;
        while (i <= j) {
            while (pieces[i].middle[axis] < pivot)
                i++;
            while (pieces[j].middle[axis] > pivot)
                j--;
            if (i <= j)
                swap_pieces(pieces, i++, j--);
        }
        if (at <= j)
            high = j;
        else if (at >= i)
            low = i;
        else
            return;
    }
}

static int longest_axis(const Centred *pieces, int64_t begin, int64_t end)
{
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int64_t i = begin; i < end; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = min_f32(low[k], pieces[i].middle[k]);
            high[k] = max_f32(high[k], pieces[i].middle[k]);
        }
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (high[k] - low[k] > high[axis] - low[axis])
            axis = k;
    return axis;
}

static Box build_node(Building *building, int64_t begin, int64_t end);

/* Makes one child of a node of the pieces from begin to end. */
static Box build_child(Building *building, int64_t begin, int64_t end, int64_t node, int place)
{
    Box box;
    if (end - begin == 1) {
        building->children[node * CHILDREN + place] = -1 - (int32_t)begin;
        box = box_of(building->corners + 9 * (int64_t)building->pieces[begin].number);
    } else {
        building->children[node * CHILDREN + place] = (int32_t)building->nodes;
        box = build_node(building, begin, end);
    }
    set_box(building->boxes + node * 6 * CHILDREN, place, &box);
    return box;
}

/* Halves the pieces until there are as many parts of `whole` pieces each as the node has children;
 * only the last part may be smaller. Returns the number of children made. */
static int split_pieces(Building *building, int64_t begin, int64_t end, int64_t whole, int64_t node,
                        int place, Box *around)
{
    int64_t parts = (end - begin + whole - 1) / whole;
    if (parts == 1) {
        Box box = build_child(building, begin, end, node, place);
        for (int k = 0; k < 3; k++) {
            around->side[k] = min_f32(around->side[k], box.side[k]);
            around->side[3 + k] = max_f32(around->side[3 + k], box.side[3 + k]);
        }
        return 1;
    }
    int64_t at = begin + parts / 2 * whole;
    part_pieces(building->pieces, begin, end, at, longest_axis(building->pieces, begin, end));
    int made = split_pieces(building, begin, at, whole, node, place, around);
    return made + split_pieces(building, at, end, whole, node, place + made, around);
}

static Box build_node(Building *building, int64_t begin, int64_t end)
{
    int64_t node = building->nodes++, whole = 1;
    while (whole * CHILDREN < end - begin)
        whole *= CHILDREN;
    float inf = INFINITY;
    Box around = {{inf, inf, inf, -inf, -inf, -inf}};
    int made = split_pieces(building, begin, end, whole, node, 0, &around);
    const Box none = {{inf, inf, inf, inf, inf, inf}}; /* infinitely far from every point */
    for (; made < CHILDREN; made++) {
        building->children[node * CHILDREN + made] = -1;
        set_box(building->boxes + node * 6 * CHILDREN, made, &none);
    }
    return around;
}

/* Builds the tree of triangles with corners (t, 3, 3), t >= 1, finite.
 *
 * pieces (t, 4) is workspace; order (t) is filled with the number of the triangle at each place;
 * boxes (n, 6, 8) and children (n, 8) with the nodes: the number of a node, or -1 - place of a
 * triangle. Returns how many nodes there are; n is enough with t / 7 + 16. */
EXPORT(int64_t, build_boxes)(int64_t t, int64_t n, const double *corners, int32_t *pieces,
                             int32_t *order, float *boxes, int32_t *children)
{
    (void)n;
    Building building = {corners, (Centred *)pieces, boxes, children, 0};
    for (int64_t i = 0; i < t; i++) {
        Box box = box_of(corners + 9 * i);
        for (int k = 0; k < 3; k++)
            building.pieces[i].middle[k] = box.side[k] / 2 + box.side[3 + k] / 2;
        building.pieces[i].number = (int32_t)i;
    }
    build_node(&building, 0, t);
    for (int64_t i = 0; i < t; i++)
        order[i] = building.pieces[i].number;
    return building.nodes;
}
