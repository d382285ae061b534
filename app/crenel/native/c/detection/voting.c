/* Step 3 of block detection: where the camera may stand, voted for by bearings.
 *
 * Two bearings to two edges, seen end on, place the camera in the plane across one direction; the
 * bearings of the other two place it along that direction, and all vote. */

enum {
    DRAWN = 6,   /* bearings, the weightiest, that say where the camera may stand; all vote */
    PLACES = 24, /* in the plane across a direction that are followed up */
    SPOTS = 4,   /* along it for each of them */
};
static const double OF_INTEREST = 0.7;   /* share of the best placing's votes */
static const double SAME_PLACE = 0.02;   /* of the distance */
static const double LEAST_ACROSS = 1e-3; /* of a bearing's normal, so that it crosses a line */

/* Bearings in a plane of two coordinates and the edges they may go to, which are points there. */
typedef struct {
    const double *normals, *weight, *points; /* (bearings, 2), (bearings), (points, 2) */
    int64_t bearings, point_count;
    int first; /* which of two columns is the first coordinate */
    double all_weight;
} Sight;

/* What a camera before and above the block has in two coordinates. */
typedef struct {
    double middle[2], axis[2], low[2], high[2]; /* of the block; of the camera; the limits */
    double aside, nearest, furthest; /* tangent of half the view; distances along the axis */
} FieldOfView;

typedef struct {
    double at[PLACES][2], votes[PLACES];
} PlaceList;

/* The best camera centres of one labelling, the first ones of equals. */
typedef struct {
    double *centres, *votes; /* (most, 3), (most) */
    int64_t count, most;
} PlacingList;

static Sight sight_of(const double *bearings, const double *weight, int64_t count,
                      const double *points, int64_t point_count, int first)
{
    Sight found = {bearings, weight, points, count, point_count, first, 0.0};
    for (int64_t s = 0; s < count; s++)
        found.all_weight += weight[s];
    return found;
}

/* Weight of the bearings that pass an edge, seen from (c0, c1); 0 where it falls short of `needed`.
 *
 * A bearing counts in full when it passes through an edge, and not at all near_rad beside it. */
static double agreeing(const Sight *seen, double c0, double c1, double near_rad, double needed)
{
    double total = 0.0, left = seen->all_weight;
    int first = seen->first, second = 1 - first;
    for (int64_t s = 0; s < seen->bearings; s++) {
        if (total + left < needed)
            return 0.0;
        double n0 = seen->normals[2 * s + first], n1 = seen->normals[2 * s + second];
        double best = near_rad * near_rad;
        for (int64_t p = 0; p < seen->point_count; p++) {
            double d0 = seen->points[2 * p + first] - c0, d1 = seen->points[2 * p + second] - c1;
            double off = n0 * d0 + n1 * d1, squared = d0 * d0 + d1 * d1;
            if (off * off < best * squared)
                best = off * off / squared;
        }
        total += seen->weight[s] * (1.0 - best / (near_rad * near_rad));
        left -= seen->weight[s];
    }
    return total;
}

static bool in_view(double c0, double c1, const FieldOfView *view)
{
    if (c0 <= view->low[0] || c1 <= view->low[1] || c0 >= view->high[0] || c1 >= view->high[1])
        return false;
    double d0 = view->middle[0] - c0, d1 = view->middle[1] - c1;
    double along = d0 * view->axis[0] + d1 * view->axis[1];
    double across = fabs(d0 * view->axis[1] - d1 * view->axis[0]);
    double squared = view->axis[0] * view->axis[0] + view->axis[1] * view->axis[1];
    if (along <= view->nearest * squared || along >= view->furthest * squared)
        return false;
    return across < view->aside * along / sqrt(squared);
}

/* Enters a place into the list of the best, replacing the same one or the worst. */
static void keep_place(PlaceList *list, double c0, double c1, double votes)
{
    int slot = 0;
    for (int k = 0; k < PLACES; k++) {
        double apart = fabs(list->at[k][0] - c0) + fabs(list->at[k][1] - c1);
        if (list->votes[k] > 0 && apart < SAME_PLACE * (fabs(c0) + fabs(c1))) {
            slot = k;
            break;
        }
        if (list->votes[k] < list->votes[slot])
            slot = k;
    }
    if (votes > list->votes[slot]) {
        list->votes[slot] = votes;
        list->at[slot][0] = c0;
        list->at[slot][1] = c1;
    }
}

static double fewest_votes(const PlaceList *list)
{
    double fewest = list->votes[0];
    for (int k = 1; k < PLACES; k++)
        fewest = min_f64(fewest, list->votes[k]);
    return fewest;
}

/* Lists places from which bearings pass edges, seen end on.
 *
 * Every two of the weightiest bearings to every two edges cross in a place; all others vote. Places
 * that do not see the block are passed over, and those with fewer votes than `needed`. */
static void cross_bearings(const Sight *seen, double near_rad, const FieldOfView *view,
                           double needed, PlaceList *list)
{
    memset(list, 0, sizeof *list);
    int64_t drawn = min_i64(seen->bearings, DRAWN), points = seen->point_count;
    for (int64_t a = 0; a < drawn; a++)
        for (int64_t b = a + 1; b < drawn; b++) {
            const double *na = seen->normals + 2 * a, *nb = seen->normals + 2 * b;
            double det = na[0] * nb[1] - na[1] * nb[0];
            if (fabs(det) < near_rad)
                continue;
            for (int64_t p = 0; p < points; p++) {
                const double *one = seen->points + 2 * p;
                double ha = na[0] * one[0] + na[1] * one[1];
                for (int64_t q = 0; q < points; q++) {
                    const double *other = seen->points + 2 * q;
                    double hb = nb[0] * other[0] + nb[1] * other[1];
                    double c0 = (ha * nb[1] - hb * na[1]) / det;
                    double c1 = (na[0] * hb - nb[0] * ha) / det;
                    if (p == q || !in_view(c0, c1, view))
                        continue;
                    double votes = agreeing(seen, c0, c1, near_rad, needed);
                    if (votes == 0.0)
                        continue;
                    keep_place(list, c0, c1, votes);
                    needed = max_f64(needed, fewest_votes(list));
                }
            }
        }
}

/* Adds to `spots` where each bearing to each edge crosses the line of second coordinate `at`;
 * how many there then are. */
static int64_t add_spots(const Sight *seen, double at, double *spots, int64_t filled)
{
    const double *points = seen->points;
    int first = seen->first, second = 1 - first;
    for (int64_t s = 0; s < seen->bearings; s++) {
        double across = seen->normals[2 * s + first];
        if (fabs(across) <= LEAST_ACROSS)
            continue;
        double ratio = seen->normals[2 * s + second] / across;
        for (int64_t p = 0; p < seen->point_count; p++)
            spots[filled++] = points[2 * p + first] + ratio * (points[2 * p + second] - at);
    }
    return filled;
}

/* How many of the ascending values (n) lie within `width`, at most, and their middle one.
 *
 * Places within two widths of those `taken` are passed over. */
static int64_t densest(const double *values, int64_t n, double width, const double *taken,
                       int takes, double *place)
{
    int64_t most = 0, last = 0;
    for (int64_t first = 0; first < n; first++) {
        while (last < n && values[last] - values[first] < width)
            last++;
        if (last - first <= most)
            continue;
        double at = values[(first + last - 1) / 2];
        bool fresh = true;
        for (int k = 0; k < takes; k++)
            fresh = fresh && fabs(taken[k] - at) >= 2 * width;
        if (fresh) {
            most = last - first;
            *place = at;
        }
    }
    return most;
}

/* Enters a placing into the list, in the order of votes. */
static void keep_placing(PlacingList *list, const double centre[3], double votes)
{
    int64_t at = list->count;
    while (at > 0 && list->votes[at - 1] < votes)
        at--;
    if (at == list->most)
        return;
    double *own = list->votes + at, *own_centre = list->centres + 3 * at;
    size_t behind = (size_t)(min_i64(list->count, list->most - 1) - at) * sizeof(double);
    memmove(own + 1, own, behind);
    memmove(own_centre + 3, own_centre, 3 * behind);
    *own = votes;
    memcpy(own_centre, centre, 3 * sizeof(double));
    list->count = min_i64(list->count + 1, list->most);
}

/* Gives each place in a plane its best third coordinates, and lists the placings that come of it.
 *
 * one: bearings, in the third and the second coordinate, of edges along the first; other: in the
 * third and the first, of edges along the second. axes: which of x, y, z the first, second and
 * third coordinate are. best: the votes of the best placing so far; the new one is returned. */
static double complete_places(const PlaceList *list, const Sight *one, const Sight *other,
                              const int axes[3], double near_rad, double best, double *spots,
                              double *spare, PlacingList *found)
{
    bool done[PLACES] = {false};
    double most = one->all_weight + other->all_weight;
    for (int turn = 0; turn < PLACES; turn++) {
        int k = 0;
        for (int i = 0; i < PLACES; i++)
            if (!done[i] && (done[k] || list->votes[i] > list->votes[k]))
                k = i;
        done[k] = true;
        double votes = list->votes[k], c0 = list->at[k][0], c1 = list->at[k][1];
        if (votes <= 0 || votes + most < OF_INTEREST * best)
            break;
        int64_t filled = add_spots(one, c1, spots, 0);
        filled = add_spots(other, c0, spots, filled);
        sort_f64(spots, filled, spare);
        double width = 2 * near_rad * sqrt(c0 * c0 + c1 * c1), taken[SPOTS];
        for (int m = 0; m < SPOTS; m++) {
            if (densest(spots, filled, width, taken, m, taken + m) == 0)
                break;
            double total = votes + agreeing(one, taken[m], c1, near_rad, 0.0) +
                           agreeing(other, taken[m], c0, near_rad, 0.0);
            double centre[3];
            centre[axes[0]] = c0;
            centre[axes[1]] = c1;
            centre[axes[2]] = taken[m];
            keep_placing(found, centre, total);
            best = max_f64(best, total);
        }
    }
    return best;
}

/* The camera centres of one labelling with the most votes, and how many there are.
 *
 * bearings (3, b, 2), weight (3, b) and counts (3) as merge_bearings gives them for x, y and z.
 * points (p, 2): the block's edges along x, y and z, seen end on, those along axis k from first[k]
 * on. view (5, 3): the block's middle; the camera's axis; the least and the greatest coordinates of
 * a camera before and above the block; the tangent of half the field of view and the least and the
 * greatest distance along the axis. best: the votes of the best placing so far; far fewer are of no
 * interest. centres (most, 3) and votes (most) are filled; workspace (4, b, p). */
EXPORT(int64_t, vote_for_centres)(int64_t b, int64_t p, int64_t most, const double *bearings,
                                  const double *weight, const int64_t *counts,
                                  const double *points, const int64_t *first, const double *view,
                                  double near_rad, double best, double *centres, double *votes,
                                  double *workspace)
{
    PlacingList found = {centres, votes, 0, most};
    Sight seen[3];
    double all_weight = 0.0;
    for (int k = 0; k < 3; k++) {
        seen[k] = sight_of(bearings + 2 * b * k, weight + b * k, counts[k], points + 2 * first[k],
                           first[k + 1] - first[k], 0);
        all_weight += seen[k].all_weight;
    }
    if (all_weight < OF_INTEREST * best)
        return 0;
    for (int k = 0; k < 3; k++) {
        int axes[3] = {(k + 1) % 3, (k + 2) % 3, k};
        FieldOfView field = {.aside = view[12], .nearest = view[13], .furthest = view[14]};
        for (int i = 0; i < 2; i++) {
            field.middle[i] = view[axes[i]];
            field.axis[i] = view[3 + axes[i]];
            field.low[i] = view[6 + axes[i]];
            field.high[i] = view[9 + axes[i]];
        }
        /* seen along the first axis, the second comes before the third */
        Sight one = seen[axes[0]], other = seen[axes[1]];
        one.first = 1;
        double needed = OF_INTEREST * best - one.all_weight - other.all_weight;
        PlaceList list;
        cross_bearings(&seen[k], near_rad, &field, needed, &list);
        best = complete_places(&list, &one, &other, axes, near_rad, best, workspace,
                               workspace + 2 * b * p, &found);
    }
    return found.count;
}
