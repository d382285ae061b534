/* Which parts of the block's edges a camera sees, and what adjoins them.
 *
 * The block is a union of boxes along the axes. What is seen of an edge can change only where, as
 * seen from the camera, another edge crosses it: every edge is cut at all such crossings, and one
 * ray to each piece decides. */

static const double BESIDE_RAD = 1e-6;     /* a ray so far off an edge shows what adjoins it */
static const double ON_SURFACE = 1e-7;     /* share of the distance that is rounding */
static const double SHORTEST_PIECE = 1e-9; /* share of the edge */
enum { BACKGROUND, FRONT, BACK, BOTTOM, FIRST_CREST };

/* boxes (box_count, 6) as xmin, xmax, ymin, ymax, zmin, zmax: the body, then the merlons;
 * grooves (merlons - 1): where each groove ends in x. */
typedef struct {
    const double *boxes, *grooves;
    int64_t box_count;
} Solid;

/* Distance in units of a ray at which it enters a box, INFINITY where it misses it, and through
 * which side: they are numbered as the box's limits. per: one over the ray's components, 0 where
 * it has none. */
static double enter_box(const double *box, const double *origin, const double per[3], int *side)
{
    double enter = -INFINITY, leave = INFINITY;
    for (int k = 0; k < 3; k++) {
        double low = box[2 * k] - origin[k], high = box[2 * k + 1] - origin[k];
        if (per[k] == 0.0) {
            if (low > 0.0 || high < 0.0)
                return INFINITY;
            continue;
        }
        double near = low * per[k], far = high * per[k];
        bool from_high = near > far;
        if (from_high) {
            double kept = near;
            near = far;
            far = kept;
        }
        if (near > enter) {
            enter = near;
            *side = 2 * k + from_high;
        }
        leave = min_f64(leave, far);
    }
    return enter > leave || enter <= 0.0 ? INFINITY : enter;
}

/* The number of the region that a side of a box is, in the order of Wireframe.regions. */
static int64_t region_of(const Solid *block, int64_t box, int side, double at_x)
{
    enum { X_LOW, X_HIGH, Y_LOW, Y_HIGH, Z_LOW };
    int64_t merlons = block->box_count - 1;
    if (side == Y_LOW)
        return FRONT;
    if (side == Y_HIGH)
        return BACK;
    if (side == Z_LOW)
        return BOTTOM;
    if (side <= X_HIGH) {
        int64_t merlon = box > 0 ? box - 1 : (side == X_HIGH ? merlons - 1 : 0);
        return FIRST_CREST + merlons + merlon + (side == X_HIGH ? merlons : 0);
    }
    if (box > 0)
        return FIRST_CREST + box - 1;
    int64_t groove = 0;
    while (groove < merlons - 2 && at_x > block->grooves[groove])
        groove++;
    return FIRST_CREST + 3 * merlons + groove;
}

/* Distance in units of `along` of the first surface, INFINITY where there is none; its region. */
static double first_hit(const Solid *block, const double *origin, const double *along,
                        int64_t *region)
{
    double nearest = INFINITY, per[3];
    for (int k = 0; k < 3; k++)
        per[k] = along[k] != 0.0 ? 1 / along[k] : 0.0;
    *region = BACKGROUND;
    for (int64_t b = 0; b < block->box_count; b++) {
        int side = 0;
        double distance = enter_box(block->boxes + 6 * b, origin, per, &side);
        if (distance < nearest) {
            nearest = distance;
            *region = region_of(block, b, side, origin[0] + distance * along[0]);
        }
    }
    return nearest;
}

/* Which points (n, 3) nothing lies before, as seen from the centre (3). */
EXPORT(void, visible_points)(int64_t n, int64_t boxes, int64_t grooves, const double *points,
                             const double *box_limits, const double *groove_ends,
                             const double *centre, bool *visible)
{
    (void)grooves;
    Solid block = {box_limits, groove_ends, boxes};
    for (int64_t i = 0; i < n; i++) {
        double along[3];
        int64_t region;
        for (int k = 0; k < 3; k++)
            along[k] = points[3 * i + k] - centre[k];
        visible[i] = first_hit(&block, centre, along, &region) >= 1.0 - ON_SURFACE;
    }
}

/* Regions on either side of a point of an edge; whether it is seen, and they differ.
 *
 * ray (3): to the point; normal (3): of the plane through the centre and the edge. */
static bool regions_beside(const Solid *block, const double *centre, const double ray[3],
                           const double *normal, int64_t sides[2])
{
    double length = sqrt(dot_3(normal, normal)), beside[3];
    if (first_hit(block, centre, ray, sides) < 1.0 - ON_SURFACE || length == 0.0)
        return false;
    double aside = BESIDE_RAD * sqrt(dot_3(ray, ray)) / length;
    for (int side = 0; side < 2; side++) {
        for (int k = 0; k < 3; k++)
            beside[k] = ray[k] + (side ? -aside : aside) * normal[k];
        first_hit(block, centre, beside, sides + side);
    }
    return sides[0] != sides[1];
}

/* Fills `cuts` with the fractions of edge a at which others cross it as seen from the centre, and
 * 0 and 1, in ascending order; their number, at most e + 1.
 *
 * begin, end (e, 3): of the edges, from the centre; normals (e, 3): of the planes through it. */
static int64_t cuts_of(int64_t a, const double *begin, const double *end, const double *normals,
                       int64_t e, double *cuts, double *spare)
{
    int64_t count = 2;
    cuts[0] = 0.0;
    cuts[1] = 1.0;
    for (int64_t b = 0; b < e; b++) {
        double d0 = dot_3(normals + 3 * a, begin + 3 * b), d1 = dot_3(normals + 3 * a, end + 3 * b);
        if (a == b || d0 * d1 > 0.0 || d0 == d1)
            continue;
        double c0 = dot_3(normals + 3 * b, begin + 3 * a), c1 = dot_3(normals + 3 * b, end + 3 * a);
        if (c0 * c1 > 0.0 || c0 == c1)
            continue;
        double at = c0 / (c0 - c1), along = d0 / (d0 - d1), agreement = 0.0;
        for (int k = 0; k < 3; k++) {
            double ray = begin[3 * a + k] + at * (end[3 * a + k] - begin[3 * a + k]);
            agreement += ray * (begin[3 * b + k] + along * (end[3 * b + k] - begin[3 * b + k]));
        }
        if (agreement > 0.0)
            cuts[count++] = at;
    }
    sort_f64(cuts, count, spare);
    return count;
}

/* All visible pieces of all edges, and how many there are.
 *
 * starts, ends (e, 3): of the edges; centre (3): of the camera. Filled: edge (e, e) numbers,
 * span (e, e, 2) fractions of the edge, sides (e, e, 2) regions. workspace (e, 13). */
EXPORT(int64_t, visible_pieces)(int64_t e, int64_t boxes, int64_t grooves, const double *starts,
                                const double *ends, const double *box_limits,
                                const double *groove_ends, const double *centre, int64_t *edge,
                                double *span, int64_t *sides, double *workspace)
{
    (void)grooves;
    Solid block = {box_limits, groove_ends, boxes};
    double *begin = workspace, *end = begin + 3 * e, *normals = end + 3 * e;
    double *cuts = normals + 3 * e, *spare = cuts + 2 * e;
    int64_t found = 0;
    for (int64_t i = 0; i < 3 * e; i++) {
        begin[i] = starts[i] - centre[i % 3];
        end[i] = ends[i] - centre[i % 3];
    }
    for (int64_t a = 0; a < e; a++)
        cross_3(begin + 3 * a, end + 3 * a, normals + 3 * a);
    for (int64_t a = 0; a < e; a++) {
        int64_t count = cuts_of(a, begin, end, normals, e, cuts, spare);
        bool joined = false;
        for (int64_t k = 0; k + 1 < count; k++) {
            if (cuts[k + 1] - cuts[k] < SHORTEST_PIECE)
                continue;
            double middle = 0.5 * (cuts[k] + cuts[k + 1]), ray[3];
            for (int m = 0; m < 3; m++)
                ray[m] = begin[3 * a + m] + middle * (end[3 * a + m] - begin[3 * a + m]);
            int64_t *own = sides + 2 * found, beside[2];
            if (!regions_beside(&block, centre, ray, normals + 3 * a, beside)) {
                joined = false;
                continue;
            }
            if (joined && own[-2] == beside[0] && own[-1] == beside[1]) {
                span[2 * found - 1] = cuts[k + 1];
                continue;
            }
            edge[found] = a;
            span[2 * found] = cuts[k];
            span[2 * found + 1] = cuts[k + 1];
            own[0] = beside[0];
            own[1] = beside[1];
            found++;
            joined = true;
        }
    }
    return found;
}
