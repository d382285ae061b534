/* The shapes of things: where a ray crosses them, and which way their faces look.
 *
 * All in a thing's own frame. A ray starts at `o` and goes along `d`. Where it crosses a thing is
 * given in lengths of `d`; MISSED where it does not.
 *
 * Faces of blocks and boxes are numbered as below; NEXT times the merlon's or groove's number is
 * added, so that two faces that only look alike have different numbers. Of a chessboard TOP is
 * what is white of its top, and BLACK what is black, its markers included. */

#define MISSED 1e30

enum { COMB, BOX, BALL, SHELL, BOARD };
enum { TOP, FLOOR, FRONT, BACK, LEFT, RIGHT, BOTTOM, NEXT = 8, BLACK = 8 };

typedef struct {
    double x, y, z;
} Vector;

/* A row of numbers as hardware/crenel_hardware/simulator/scene/world.py fills it for each thing. */
typedef struct {
    Vector middle; /* of the bounding sphere */
    double radius;
    double albedo;
    double unused[3];
    Vector low, high; /* bounds */
    union {
        struct {
            double floor, edge_count, edges[32];
        } comb;
        struct {
            double unused[2], half_width, half_depth, height, rib, ribs, steepest;
        } shell;
        struct {
            double unused[2], columns, rows, square_x, square_y, ink;
            double marker, bits, first_white, cells[24]; /* of a ChArUco board; else marker is 0 */
        } board;
    };
    double gloss, sharpness, marks, mark_mm;
    double unused_behind[12];
} Thing;

_Static_assert(sizeof(Thing) == 64 * sizeof(double), "a thing is a row of 64 numbers");

typedef struct {
    double t;
    int face;
} Crossing;

/* What a ray has of the space between planes: it enters through `face`; empty if enter > leave. */
typedef struct {
    double enter, leave;
    int face;
} Passage;

static inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline Vector along(Vector o, double t, Vector d)
{
    return (Vector){o.x + t * d.x, o.y + t * d.y, o.z + t * d.z};
}

/* Narrows a passage to what lies between two parallel planes. Without branches, so that the
 * compiler can take several rays at once. */
static inline Passage between(Passage so_far, double o, double d, double low, double high,
                              int low_face, int high_face)
{
    bool parallel = fabs(d) < 1e-300, outside = o < low || o > high, up = d > 0.0;
    double inverse = 1.0 / (parallel ? 1.0 : d);
    double enter = ((up ? low : high) - o) * inverse;
    double leave = ((up ? high : low) - o) * inverse;
    enter = parallel ? (outside ? MISSED : -MISSED) : enter;
    leave = parallel ? (outside ? -MISSED : MISSED) : leave;
    so_far.face = enter > so_far.enter ? (up ? low_face : high_face) : so_far.face;
    so_far.enter = max_f64(enter, so_far.enter);
    so_far.leave = min_f64(leave, so_far.leave);
    return so_far;
}

/* Where a ray enters and leaves the bounds of a thing. */
static inline Passage through_bounds(const Thing *thing, Vector o, Vector d)
{
    Vector low = thing->low, high = thing->high;
    Passage found = {-MISSED, MISSED, TOP};
    found = between(found, o.x, d.x, low.x, high.x, LEFT, RIGHT);
    found = between(found, o.y, d.y, low.y, high.y, FRONT, BACK);
    return between(found, o.z, d.z, low.z, high.z, BOTTOM, TOP);
}

/* The first face of a box, for a ray that starts outside of it. */
static inline Crossing cross_box(const Thing *thing, Vector o, Vector d)
{
    Passage bounds = through_bounds(thing, o, d);
    bool met = bounds.enter <= bounds.leave && bounds.enter > 0.0;
    return (Crossing){met ? bounds.enter : MISSED, bounds.face};
}

/* The first face of the block, for a ray that starts outside of its hull. */
static inline Crossing cross_comb(const Thing *thing, Vector o, Vector d)
{
    Passage hull = through_bounds(thing, o, d);
    if (hull.enter > hull.leave || hull.enter <= 0.0)
        return (Crossing){MISSED, TOP};
    const double *edges = thing->comb.edges, floor_z = thing->comb.floor;
    int count = (int)thing->comb.edge_count;
    Vector at = along(o, hull.enter, d);
    if (hull.face == LEFT)
        return (Crossing){hull.enter, LEFT};
    if (hull.face == RIGHT)
        return (Crossing){hull.enter, RIGHT + NEXT * (count / 2 - 1)};
    if (at.z <= floor_z || hull.face == BOTTOM)
        return (Crossing){hull.enter, hull.face};
    int gap = 0;
    while (gap < count && edges[gap] < at.x)
        gap++;
    if (gap % 2 == 1 || gap == 0 || gap == count)
        return (Crossing){hull.enter, hull.face != TOP ? hull.face : TOP + NEXT * (gap / 2)};
    /* it enters between two merlons, and ends on one of their walls or on the floor */
    int groove = gap / 2 - 1, wall = TOP;
    double t_wall = MISSED, t_floor = d.z < 0.0 ? (floor_z - o.z) / d.z : MISSED;
    if (d.x < 0.0) {
        t_wall = (edges[gap - 1] - o.x) / d.x;
        wall = RIGHT + NEXT * groove;
    } else if (d.x > 0.0) {
        t_wall = (edges[gap] - o.x) / d.x;
        wall = LEFT + NEXT * (groove + 1);
    }
    if (min_f64(t_wall, t_floor) > hull.leave)
        return (Crossing){MISSED, TOP};
    return t_floor <= t_wall ? (Crossing){t_floor, FLOOR + NEXT * groove}
                             : (Crossing){t_wall, wall};
}

static inline double shell_height(const Thing *thing, double x, double y)
{
    double a = x / thing->shell.half_width, b = y / thing->shell.half_depth;
    double w = 1.0 - a * a - b * b;
    if (w <= 0.0)
        return thing->shell.height * w;
    double fan = x / (y + 1.3 * thing->shell.half_depth);
    return thing->shell.height * w + thing->shell.rib * w * w * cos(thing->shell.ribs * fan);
}

/* How far a place of a ray is above the relief. */
static inline double above_shell(const Thing *thing, Vector o, double t, Vector d)
{
    return o.z + t * d.z - shell_height(thing, o.x + t * d.x, o.y + t * d.y);
}

/* Where a ray comes to a paraboloid that covers the relief; MISSED if it passes it. */
static inline double cross_cover(const Thing *thing, Vector o, Vector d, double enter)
{
    double ex = 1.0 / (thing->shell.half_width * thing->shell.half_width);
    double ey = 1.0 / (thing->shell.half_depth * thing->shell.half_depth);
    double top = thing->shell.height + thing->shell.rib;
    double a = top * (d.x * d.x * ex + d.y * d.y * ey);
    double b = 0.5 * d.z + top * (o.x * d.x * ex + o.y * d.y * ey);
    double root = b * b - a * (top * (o.x * o.x * ex + o.y * o.y * ey) + o.z - top);
    if (root < 0.0)
        return MISSED;
    return a > 1e-18 ? (-b - sqrt(root)) / a : enter;
}

/* First crossing of the relief, to a nanometre, for a ray from above.
 *
 * From a paraboloid that covers it, steps that cannot pass the surface, for its slope is
 * bounded; then secants. */
static double cross_shell(const Thing *thing, Vector o, Vector d)
{
    Passage bounds = through_bounds(thing, o, d);
    if (bounds.enter > bounds.leave || bounds.leave <= 0.0)
        return MISSED;
    double closing = fabs(d.z) + thing->shell.steepest * sqrt(d.x * d.x + d.y * d.y);
    double t = max_f64(max_f64(bounds.enter, cross_cover(thing, o, d, bounds.enter)), 0.0);
    while (t <= bounds.leave) {
        double gap = above_shell(thing, o, t, d);
        if (gap >= 0.1) {
            t += gap / closing;
            continue;
        }
        double reached = t, before = t - 1e-3 / closing;
        double gap_before = above_shell(thing, o, before, d);
        for (int i = 0; i < 20 && fabs(gap) >= 1e-9 && gap != gap_before; i++) {
            double ahead = t - gap * (t - before) / (gap - gap_before);
            before = t;
            gap_before = gap;
            t = ahead;
            gap = above_shell(thing, o, t, d);
        }
        if (fabs(gap) < 1e-6)
            return t;
        t = max_f64(reached, max_f64(t, before)) + 1e-2 / closing; /* secants may lead back */
    }
    return MISSED;
}

static inline double cross_ball(const Thing *thing, Vector o, Vector d)
{
    double a = dot(d, d), b = dot(o, d), c = dot(o, o) - thing->radius * thing->radius;
    double root = b * b - a * c;
    if (root < 0.0)
        return MISSED;
    double t = (-b - sqrt(root)) / a;
    return t > 0.0 ? t : MISSED;
}

/* The inner cells of a marker as a number, two markers to each double; `nth` white square of the
 * board, row after row from the one at the lower left. */
static inline int64_t marker_cells(const Thing *thing, int nth)
{
    int64_t both = (int64_t)thing->board.cells[nth / 2];
    return nth % 2 ? both >> 25 : both & 0x1ffffff;
}

/* Whether the white square (i, j) has ink at a place on it, 0 to 1 across and up. */
static inline bool is_marked(const Thing *thing, int i, int j, double across, double up)
{
    double rim = (1.0 - thing->board.marker) / 2.0;
    int bits = (int)thing->board.bits;
    int column = (int)floor((across - rim) / thing->board.marker * (bits + 2)) - 1;
    int row = bits - (int)floor((up - rim) / thing->board.marker * (bits + 2));
    if (column < -1 || column > bits || row < -1 || row > bits)
        return false;
    if (column < 0 || column == bits || row < 0 || row == bits)
        return true;
    int nth = ((j + 1) * ((int)thing->board.columns + 1) + i + 1) / 2;
    return !(marker_cells(thing, nth) >> (row * bits + column) & 1);
}

static inline Crossing cross_board(const Thing *thing, Vector o, Vector d)
{
    Crossing found = cross_box(thing, o, d);
    if (found.face == TOP && found.t < MISSED) {
        Vector at = along(o, found.t, d);
        double x = at.x / thing->board.square_x, y = at.y / thing->board.square_y;
        int i = (int)floor(x), j = (int)floor(y);
        bool printed = i >= -1 && i < thing->board.columns && j >= -1 && j < thing->board.rows;
        bool black = ((i + j) % 2 == 0) != (thing->board.first_white > 0.0);
        if (printed && !black && thing->board.marker > 0.0)
            black = is_marked(thing, i, j, x - i, y - j);
        found.face = printed && black ? BLACK : TOP;
    }
    return found;
}

/* Where a ray first crosses a thing. */
static inline Crossing cross(int64_t kind, const Thing *thing, Vector o, Vector d)
{
    switch (kind) {
    case COMB:
        return cross_comb(thing, o, d);
    case BOX:
        return cross_box(thing, o, d);
    case BALL:
        return (Crossing){cross_ball(thing, o, d), TOP};
    case BOARD:
        return cross_board(thing, o, d);
    default:
        return (Crossing){cross_shell(thing, o, d), TOP};
    }
}

/* Outward normal of a thing at a place on it. */
static inline Vector normal_of(int64_t kind, const Thing *thing, int face, Vector at)
{
    if (kind == BALL)
        return (Vector){at.x / thing->radius, at.y / thing->radius, at.z / thing->radius};
    if (kind == SHELL) {
        const double h = 1e-4;
        double x = at.x, y = at.y;
        double a = (shell_height(thing, x + h, y) - shell_height(thing, x - h, y)) / (2.0 * h);
        double b = (shell_height(thing, x, y + h) - shell_height(thing, x, y - h)) / (2.0 * h);
        double length = sqrt(1.0 + a * a + b * b);
        return (Vector){-a / length, -b / length, 1.0 / length};
    }
    static const Vector outward[NEXT] = {
        [TOP] = {0, 0, 1},   [FLOOR] = {0, 0, 1}, [FRONT] = {0, -1, 0}, [BACK] = {0, 1, 0},
        [LEFT] = {-1, 0, 0}, [RIGHT] = {1, 0, 0}, [BOTTOM] = {0, 0, -1}};
    return outward[face % NEXT];
}

/* How bright a face is; a chessboard's squares are so by the laser's light as well. */
static inline double albedo(int64_t kind, const Thing *thing, int face)
{
    return kind == BOARD && face == BLACK ? thing->albedo * thing->board.ink : thing->albedo;
}
