/* Step 1 of block detection: the three perpendicular directions that most segments follow.
 *
 * Segments (n, 4) are u0, v0, u1, v1, centred and over the picture's longer side, focal lengths in
 * the same unit. `axes` (3, 3) holds three directions as columns in the camera's frame. */

static const double PARALLEL = 1e-4, NEARLY_PARALLEL = 1e-2; /* sines that give no direction */
static const double SMALL_STEP = 1e-5;                       /* for derivatives */
static const double LARGEST_STEP = 0.3, LEAST_CURVATURE = 1e-12;
enum { REFINEMENTS = 6, UNKNOWNS = 4 };

/* How refined directions are held, and what follows them (directions.py). */
typedef struct {
    double tolerance_rad, held_focal, least_log_focal, greatest_log_focal;
} DirectionLimits;

static void set_columns(double axes[9], const double *x, const double *y, const double *z)
{
    for (int k = 0; k < 3; k++) {
        axes[3 * k] = x[k];
        axes[3 * k + 1] = y[k];
        axes[3 * k + 2] = z[k];
    }
}

/* A segment's way from its middle to the vanishing point of direction k: its part across the
 * segment, and that along it. */
static inline double way(const double *axes, double focal, const double *line, int k,
                         double *along)
{
    double du = line[2] - line[0], dv = line[3] - line[1];
    double tu = focal * axes[k] - 0.5 * (line[0] + line[2]) * axes[6 + k];
    double tv = focal * axes[3 + k] - 0.5 * (line[1] + line[3]) * axes[6 + k];
    *along = du * tu + dv * tv;
    return du * tv - dv * tu;
}

/* Length of the segments that point at one of three vanishing points. */
static double weight_explained(const double *axes, double focal, const double *lines,
                               const double *weight, int64_t n, double tangent)
{
    double total = 0.0;
    for (int64_t s = 0; s < n; s++) {
        bool follows = false;
        for (int k = 0; k < 3; k++) {
            double along, across = way(axes, focal, lines + 4 * s, k, &along);
            follows |= fabs(across) < tangent * fabs(along);
        }
        total += follows ? weight[s] : 0.0;
    }
    return total;
}

/* Scores (f, t) and axes (f, t, 3, 3) of each focal length and triple of segments: two of one
 * direction, one of a second. Both are zero where a triple gives no directions.
 *
 * tangent: of the angle by which a segment may miss a vanishing point. normals (n, 3): workspace.
 */
EXPORT(void, try_triples)(int64_t n, int64_t t, int64_t f, const double *lines,
                          const double *weight, const int64_t *triples, const double *focals,
                          double tangent, double *scores, double *axes, double *normals)
{
    for (int64_t i = 0; i < f; i++) {
        for (int64_t s = 0; s < n; s++) {
            const double *line = lines + 4 * s;
            double *normal = normals + 3 * s;
            normal[0] = focals[i] * (line[1] - line[3]);
            normal[1] = focals[i] * (line[2] - line[0]);
            normal[2] = line[0] * line[3] - line[1] * line[2];
            normalise_3(normal);
        }
        for (int64_t j = 0; j < t; j++) {
            const int64_t *of = triples + 3 * j;
            double first[3], second[3], third[3], *found = axes + 9 * (i * t + j);
            cross_3(normals + 3 * of[0], normals + 3 * of[1], first);
            if (normalise_3(first) < PARALLEL)
                continue;
            cross_3(normals + 3 * of[2], first, second);
            if (normalise_3(second) < NEARLY_PARALLEL)
                continue;
            cross_3(first, second, third);
            set_columns(found, first, second, third);
            scores[i * t + j] = weight_explained(found, focals[i], lines, weight, n, tangent);
        }
    }
}

/* Angle, rad, between a segment and its way to the vanishing point of direction k. */
static double angle_off(const double *axes, double focal, const double *line, int64_t k)
{
    double along, across = way(axes, focal, line, (int)k, &along);
    return atan2(across, fabs(along) + 1e-12) * (along >= 0 ? 1.0 : -1.0);
}

/* Which direction each segment follows, -1 for none, and its angle from it, 0 for none. */
static void follow(const double *axes, double focal, const double *lines, int64_t n,
                   double tolerance_rad, int64_t *family, double *off)
{
    for (int64_t s = 0; s < n; s++) {
        double nearest = tolerance_rad;
        family[s] = -1;
        off[s] = 0.0;
        for (int k = 0; k < 3; k++) {
            double angle = angle_off(axes, focal, lines + 4 * s, k);
            if (fabs(angle) < nearest) {
                family[s] = k;
                off[s] = angle;
                nearest = fabs(angle);
            }
        }
    }
}

/* The directions turned by a small rotation vector, perpendicular again. */
static void turn_axes(const double axes[9], const double by[3], double out[9])
{
    double x[3] = {axes[0], axes[3], axes[6]}, y[3] = {axes[1], axes[4], axes[7]};
    double z[3] = {axes[2], axes[5], axes[8]}, first[3], second[3], third[3], handed[3];
    cross_3(by, x, first);
    cross_3(by, y, second);
    for (int k = 0; k < 3; k++) {
        first[k] += x[k];
        second[k] += y[k];
    }
    normalise_3(first);
    double along = dot_3(second, first);
    for (int k = 0; k < 3; k++)
        second[k] -= along * first[k];
    normalise_3(second);
    cross_3(x, y, handed);
    cross_3(first, second, third);
    double sense = dot_3(handed, z) > 0 ? 1.0 : -1.0;
    for (int k = 0; k < 3; k++)
        third[k] *= sense;
    set_columns(out, first, second, third);
}

/* Solves A x = b by elimination with pivots; both are overwritten, b with x. */
static void solve(double A[UNKNOWNS][UNKNOWNS], double b[UNKNOWNS])
{
    for (int p = 0; p < UNKNOWNS; p++) {
        int pivot = p;
        for (int r = p + 1; r < UNKNOWNS; r++)
            pivot = fabs(A[r][p]) > fabs(A[pivot][p]) ? r : pivot;
        for (int q = 0; q < UNKNOWNS; q++) {
            double kept = A[p][q];
            A[p][q] = A[pivot][q];
            A[pivot][q] = kept;
        }
        double kept = b[p];
        b[p] = b[pivot];
        b[pivot] = kept;
        for (int r = p + 1; r < UNKNOWNS; r++) {
            double share = A[r][p] / A[p][p];
            for (int q = p; q < UNKNOWNS; q++)
                A[r][q] -= share * A[p][q];
            b[r] -= share * b[p];
        }
    }
    for (int p = UNKNOWNS - 1; p >= 0; p--) {
        for (int q = p + 1; q < UNKNOWNS; q++)
            b[p] -= A[p][q] * b[q];
        b[p] /= A[p][p];
    }
}

/* Gauss-Newton of the rotation and of the focal length's logarithm on the segments that follow. */
static void refine(double axes[9], double *focal, const double *lines, const double *weight,
                   int64_t n, DirectionLimits limits, int64_t *family, double *off)
{
    double start = log(*focal), log_focal = start;
    for (int round = 0; round < REFINEMENTS; round++) {
        double moved[UNKNOWNS][9], moved_focal[UNKNOWNS];
        for (int p = 0; p < UNKNOWNS; p++) {
            double by[UNKNOWNS] = {0};
            by[p] = SMALL_STEP;
            turn_axes(axes, by, moved[p]);
            moved_focal[p] = exp(log_focal + by[3]);
        }
        follow(axes, exp(log_focal), lines, n, limits.tolerance_rad, family, off);
        double A[UNKNOWNS][UNKNOWNS] = {{0}}, step[UNKNOWNS] = {0}, squares = 0.0;
        int64_t used = 0;
        for (int64_t s = 0; s < n; s++) {
            if (family[s] < 0)
                continue;
            double J[UNKNOWNS], square = weight[s] * weight[s];
            used++;
            squares += square;
            for (int p = 0; p < UNKNOWNS; p++) {
                double ahead = angle_off(moved[p], moved_focal[p], lines + 4 * s, family[s]);
                J[p] = (ahead - off[s]) / SMALL_STEP;
            }
            for (int p = 0; p < UNKNOWNS; p++) {
                step[p] -= square * J[p] * off[s];
                for (int q = 0; q < UNKNOWNS; q++)
                    A[p][q] += square * J[p] * J[q];
            }
        }
        if (used < UNKNOWNS)
            break;
        /* the focal length is held weakly to where it came from: often it hardly shows */
        double held = limits.held_focal * limits.held_focal * squares / (double)used;
        A[3][3] += held;
        step[3] -= held * (log_focal - start);
        for (int p = 0; p < UNKNOWNS; p++)
            A[p][p] += LEAST_CURVATURE;
        solve(A, step);
        double largest = LEAST_CURVATURE;
        for (int p = 0; p < UNKNOWNS; p++)
            largest = max_f64(largest, fabs(step[p]));
        for (int p = 0; p < UNKNOWNS; p++)
            step[p] *= min_f64(1.0, LARGEST_STEP / largest);
        double before[9];
        memcpy(before, axes, sizeof before);
        turn_axes(before, step, axes);
        log_focal = min_f64(max_f64(log_focal + step[3], limits.least_log_focal),
                            limits.greatest_log_focal);
    }
    *focal = exp(log_focal);
}

/* Refines triples of directions (k, 3, 3) and their focal lengths (k) in place.
 *
 * limits (4) as `DirectionLimits` names them; family (k, n) and off (k, n) are filled with which
 * direction each segment follows, -1 for none, and by how many rad it misses it. */
EXPORT(void, refine_directions)(int64_t k, int64_t n, double *axes, double *focals,
                                const double *lines, const double *weight, const double *limits,
                                int64_t *family, double *off)
{
    DirectionLimits held = {limits[0], limits[1], limits[2], limits[3]};
    for (int64_t i = 0; i < k; i++) {
        int64_t *own = family + n * i;
        refine(axes + 9 * i, focals + i, lines, weight, n, held, own, off + n * i);
        follow(axes + 9 * i, focals[i], lines, n, held.tolerance_rad, own, off + n * i);
    }
}
