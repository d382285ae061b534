/* Where a ray first meets a thing. Called for millions of rays.
 *
 * Rays of one bundle share an origin (the camera's centre, the laser's emitter, a place on a
 * lamp), so origin and turn into every thing's own frame are worked out once (tracing.py). */

/* What there is in view. */
typedef struct {
    int64_t count;
    const int64_t *kinds;
    const Thing *things;
} Things;

/* What a thing needs to know of the rays of a bundle, as tracing.py fills it. */
typedef struct {
    double turn[9]; /* into the thing's frame */
    Vector origin;  /* in the thing's frame */
    Vector centre;  /* of the thing's bounding sphere, from the origin, in the rays' frame */
    double clear;   /* that centre's distance squared less the radius squared */
} Bundle;

_Static_assert(sizeof(Bundle) == 16 * sizeof(double), "a bundle is a row of 16 numbers");

/* Where a ray meets a thing; the normal and the place are in the thing's frame. */
typedef struct {
    double t;
    int64_t thing; /* -1 where it meets nothing */
    int face;
    Vector normal, at;
} Hit;

static inline Vector into_thing(const double *turn, Vector d)
{
    return (Vector){turn[0] * d.x + turn[1] * d.y + turn[2] * d.z,
                    turn[3] * d.x + turn[4] * d.y + turn[5] * d.z,
                    turn[6] * d.x + turn[7] * d.y + turn[8] * d.z};
}

static inline Vector out_of_thing(const double *turn, Vector d)
{
    return (Vector){turn[0] * d.x + turn[3] * d.y + turn[6] * d.z,
                    turn[1] * d.x + turn[4] * d.y + turn[7] * d.z,
                    turn[2] * d.x + turn[5] * d.y + turn[8] * d.z};
}

/* How far a ray of a bundle goes into the bounding sphere of a thing, as a square that is negative
 * where it passes the sphere; `length2` is that of `d`, squared. */
static inline double depth2(const Bundle *rays, Vector d, double length2)
{
    double near = dot(rays->centre, d);
    return near * near - rays->clear * length2;
}

/* Where a ray of a bundle meets the k-th thing; `length2` is that of `d`, squared. */
static inline Crossing meet(const Things *all, const Bundle *bundle, int64_t k, Vector d,
                            double length2)
{
    const Bundle *rays = bundle + k;
    if (depth2(rays, d, length2) < 0.0)
        return (Crossing){MISSED, TOP};
    return cross(all->kinds[k], all->things + k, rays->origin, into_thing(rays->turn, d));
}

/* What a ray of a bundle along `d` meets: the `thing` at `t` with this face, -1 for nothing. */
static inline Hit hit_of(const Things *all, const Bundle *bundle, Vector d, double t, int64_t thing,
                         int face)
{
    Hit hit = {.t = t, .thing = thing, .face = face};
    if (thing >= 0) {
        const Bundle *rays = bundle + thing;
        hit.at = along(rays->origin, t, into_thing(rays->turn, d));
        hit.normal = normal_of(all->kinds[thing], all->things + thing, face, hit.at);
    }
    return hit;
}

/* The first hit of a ray of a bundle along `d`. */
static inline Hit trace(const Things *all, const Bundle *bundle, Vector d)
{
    Crossing first = {MISSED, -1};
    int64_t thing = -1;
    double length2 = dot(d, d);
    for (int64_t k = 0; k < all->count; k++) {
        Crossing found = meet(all, bundle, k, d, length2);
        if (found.t < first.t) {
            first = found;
            thing = k;
        }
    }
    return hit_of(all, bundle, d, first.t, thing, first.face);
}

enum { RUN = 64 };

/* Up to RUN rays of one bundle, along (x, y, 1), and what each of them meets first. Of things
 * that are boxes, several rays are followed at once. */
typedef struct {
    int64_t count;
    double x[RUN], y[RUN], t[RUN];
    int64_t thing[RUN], face[RUN];
} Run;

static inline Vector direction(const Run *run, int64_t i)
{
    return (Vector){run->x[i], run->y[i], 1.0};
}

/* Whether any ray of a run comes to the bounding sphere of a thing. */
static inline bool comes_near(const Run *run, const Bundle *rays)
{
    double most = -MISSED;
    for (int64_t i = 0; i < run->count; i++) {
        Vector d = direction(run, i);
        most = max_f64(depth2(rays, d, dot(d, d)), most);
    }
    return most >= 0.0;
}

static inline void meet_box(Run *run, const Bundle *rays, const Thing *thing, int64_t k)
{
    for (int64_t i = 0; i < run->count; i++) {
        Crossing found = cross_box(thing, rays->origin, into_thing(rays->turn, direction(run, i)));
        bool first = found.t < run->t[i];
        run->t[i] = first ? found.t : run->t[i];
        run->thing[i] = first ? k : run->thing[i];
        run->face[i] = first ? found.face : run->face[i];
    }
}

static inline void meet_other(Run *run, const Things *all, const Bundle *bundle, int64_t k)
{
    for (int64_t i = 0; i < run->count; i++) {
        Vector d = direction(run, i);
        Crossing found = meet(all, bundle, k, d, dot(d, d));
        if (found.t < run->t[i]) {
            run->t[i] = found.t;
            run->thing[i] = k;
            run->face[i] = found.face;
        }
    }
}

/* The first hits of a run. */
static inline void trace_run(Run *run, const Things *all, const Bundle *bundle)
{
    for (int64_t i = 0; i < run->count; i++) {
        run->t[i] = MISSED;
        run->thing[i] = run->face[i] = -1;
    }
    for (int64_t k = 0; k < all->count; k++) {
        if (!comes_near(run, bundle + k))
            continue;
        if (all->kinds[k] == BOX)
            meet_box(run, bundle + k, all->things + k, k);
        else
            meet_other(run, all, bundle, k);
    }
}

static inline Hit hit_of_run(const Run *run, int64_t i, const Things *all, const Bundle *bundle)
{
    return hit_of(all, bundle, direction(run, i), run->t[i], run->thing[i], (int)run->face[i]);
}

/* Whether a ray of a bundle meets anything before a share of `d`. */
static inline bool blocked(const Things *all, const Bundle *bundle, Vector d, double share)
{
    double length2 = dot(d, d);
    for (int64_t k = 0; k < all->count; k++)
        if (meet(all, bundle, k, d, length2).t < share)
            return true;
    return false;
}

/* How far along each of n directions (n, 3) the first thing is; 1e30 where there is none. */
EXPORT(void, first_hits)(int64_t count, int64_t n, const int64_t *kinds, const double *rows,
                         const double *bundle, const double *directions, double *found)
{
    Things all = {count, kinds, (const Thing *)rows};
    for (int64_t i = 0; i < n; i++)
        found[i] = trace(&all, (const Bundle *)bundle, ((const Vector *)directions)[i]).t;
}
