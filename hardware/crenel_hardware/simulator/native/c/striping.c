/* The laser's light: where its plane falls on things, and what of it the camera gets.
 *
 * All in the camera's frame, in which a pixel's ray is (x, y, 1). First a fan of rays from the
 * emitter shows which pixels may be lit; then rays through those pixels show how brightly. */

#define REACH 4.0 /* half thicknesses of the light plane beyond which its light is nothing */
#define NOTHING (-4) /* code of a pixel that sees no thing; even, as all that is not lit */

enum { UNMARKED = -2, MARKED = -1 };
enum { DEEPEST = 12 }; /* rays that wait to be distinguished from the last one */

typedef struct {
    Vector normal;
    double offset_mm, sigma_mm; /* half thickness */
} Plane;

/* Where a ray of the laser lands in the picture. */
typedef struct {
    double angle, u, v;
    double half_px; /* the stripe's half thickness there; -1 where the camera could see nothing */
    double face;    /* a code; -1 where it meets nothing */
} Landing;

/* The laser, and all that it may fall on. */
typedef struct {
    Things things;
    Vector emitter;
    const Plane *plane;
    const Bundle *lamps; /* rays from the emitter */
} Laser;

typedef struct {
    Vector middle, side;
} Fan;

/* Laser light along one ray of the camera. */
typedef struct {
    double value;
    int32_t code;  /* of what was met; odd where the laser reaches */
    double off_mm; /* distance to the light plane */
} Lit;

/* Where a ray of the laser lands, at an angle in the fan. */
static Landing land(const Laser *laser, const Fan *fan, const Lens *lens, double angle)
{
    Landing found = {angle, 0.0, 0.0, -1.0, -1.0};
    double c = cos(angle), s = sin(angle);
    Vector d = {c * fan->middle.x + s * fan->side.x, c * fan->middle.y + s * fan->side.y,
                c * fan->middle.z + s * fan->side.z};
    Hit hit = trace(&laser->things, laser->lamps, d);
    if (hit.thing < 0)
        return found;
    Vector at = along(laser->emitter, hit.t, d);
    if (at.z <= 1.0)
        return found;
    Vector normal = out_of_thing(laser->lamps[hit.thing].turn, hit.normal);
    double across = dot(laser->plane->normal, normal);
    double spread = 1.0 / sqrt(max_f64(1.0 - across * across, 0.01));
    double x, y;
    distort(lens, at.x / at.z, at.y / at.z, &x, &y);
    double u = lens->fx * x + lens->cx, v = lens->fy * y + lens->cy;
    if (fabs(u) < 1e5 && fabs(v) < 1e5) {
        found.u = u;
        found.v = v;
        found.half_px = laser->plane->sigma_mm * spread * lens->fx / at.z;
        found.face = (double)(hit.thing * 1024 + hit.face);
    }
    return found;
}

static inline double distance_px(const Landing *a, double u, double v)
{
    return max_f64(fabs(a->u - u), fabs(a->v - v));
}

/* Where the laser's light lands, in order along the fan: (capacity, 5); returns how many.
 *
 * angles (angle_count), fan (2, 3): its middle and sideways direction; emitter (3), plane (5),
 * lens (9); kinds (count), rows (count, 64), lamps (count, 16).
 * Where two rays at `angles` land apart, more are traced between them, so that no lit part of a
 * face is missed. */
EXPORT(int64_t, trace_fan)(int64_t angle_count, int64_t count, int64_t capacity,
                           const double *angles, const double *fan, const double *emitter,
                           const double *plane, const double *lens, const int64_t *kinds,
                           const double *rows, const double *lamps, double *landed)
{
    Laser laser = {{count, kinds, (const Thing *)rows}, *(const Vector *)emitter,
                   (const Plane *)plane, (const Bundle *)lamps};
    Landing *done = (Landing *)landed, waiting[DEEPEST];
    const Fan *directions = (const Fan *)fan;
    const Lens *camera = (const Lens *)lens;
    done[0] = land(&laser, directions, camera, angles[0]);
    int64_t done_count = 1;
    for (int64_t i = 1; i < angle_count; i++) {
        waiting[0] = land(&laser, directions, camera, angles[i]);
        int height = 1;
        while (height > 0 && done_count < capacity) {
            const Landing *last = done + done_count - 1, *next = waiting + height - 1;
            bool apart = distance_px(next, last->u, last->v) > 3.0 || next->face != last->face;
            if (apart && height < DEEPEST && (next->half_px > 0.0 || last->half_px > 0.0)) {
                double middle = 0.5 * (last->angle + next->angle);
                waiting[height++] = land(&laser, directions, camera, middle);
            } else {
                done[done_count++] = *next;
                height--;
            }
        }
    }
    return done_count;
}

/* Marks the pixels around the landed rays; lists them in `band`, and returns how many.
 *
 * landed (landed_count, 5); codes (height, width) UNMARKED, becomes MARKED; band
 * (height, width), filled from its beginning: row * width + column. */
EXPORT(int64_t, band_around)(int64_t landed_count, int64_t height, int64_t width,
                             const double *landed, int32_t *codes, int32_t *band)
{
    int64_t count = 0;
    double u0 = -1e9, v0 = -1e9;
    bool flat = true;
    for (int64_t i = 0; i < landed_count; i++) {
        const Landing *ray = (const Landing *)landed + i;
        double distance = distance_px(ray, u0, v0);
        if (ray->half_px < 0.0 || (distance < 0.5 && i % 8 > 0))
            continue;
        bool near = distance < 8.0;
        flat = !near || fabs(ray->u - u0) >= fabs(ray->v - v0);
        u0 = ray->u;
        v0 = ray->v;
        int64_t reach = (int64_t)min_f64(REACH * ray->half_px + 1.0, 60.0);
        int64_t tall = flat ? reach : 2, wide = flat ? (near ? 2 : 6) : reach;
        if (!near)
            tall = max_i64(tall, 6);
        int64_t c0 = (int64_t)floor(ray->u + 0.5), r0 = (int64_t)floor(ray->v + 0.5);
        for (int64_t r = max_i64(r0 - tall, 0); r < min_i64(r0 + tall + 1, height); r++)
            for (int64_t c = max_i64(c0 - wide, 0); c < min_i64(c0 + wide + 1, width); c++)
                if (codes[r * width + c] == UNMARKED) {
                    codes[r * width + c] = MARKED;
                    band[count++] = (int32_t)(r * width + c);
                }
    }
    return count;
}

/* Laser light that the camera gets along a ray. */
static Lit laser_along(const Laser *laser, const Bundle *eye, Vector d)
{
    const Things *all = &laser->things;
    const Plane *plane = laser->plane;
    Hit hit = trace(all, eye, d);
    if (hit.thing < 0)
        return (Lit){0.0, NOTHING, 1e9};
    Vector at = {hit.t * d.x, hit.t * d.y, hit.t};
    Lit found = {0.0, (int32_t)(hit.thing * 1024 + hit.face) * 2,
                 dot(plane->normal, at) - plane->offset_mm};
    if (fabs(found.off_mm) > REACH * plane->sigma_mm)
        return found;
    Vector way = back_to(laser->lamps + hit.thing, hit.at);
    double slope = dot(hit.normal, way) / sqrt(dot(way, way));
    Vector down = {at.x - laser->emitter.x, at.y - laser->emitter.y, at.z - laser->emitter.z};
    if (slope <= 0.0 || blocked(all, laser->lamps, down, 1.0 - 2e-6))
        return found;
    double off = found.off_mm / plane->sigma_mm;
    double bright = albedo(all->kinds[hit.thing], all->things + hit.thing, hit.face);
    found.value = bright * slope * exp(-0.5 * off * off);
    found.code++;
    return found;
}

enum { ONE_RAY, FEW_RAYS, MANY_RAYS };

/* How many rays a pixel needs.
 *
 * Many where a lit face ends, few where the stripe is so foreshortened that its profile is
 * narrow for the pixels. */
static int rays_needed(const int32_t *codes, const float *offs, int64_t height, int64_t width,
                       int64_t pixel, double sigma_mm)
{
    static const int down[4] = {1, -1, 0, 0}, right[4] = {0, 0, 1, -1};
    int32_t own = codes[pixel];
    double off = offs[pixel], reach = REACH * sigma_mm, thin = 1.4 * sigma_mm;
    int needed = ONE_RAY;
    for (int k = 0; k < 4; k++) {
        int64_t r = pixel / width + down[k], c = pixel % width + right[k];
        if (r < 0 || c < 0 || r >= height || c >= width)
            continue;
        int32_t other = codes[r * width + c];
        double other_off = offs[r * width + c];
        if (other == UNMARKED || ((own & 1) == 0 && (other & 1) == 0))
            continue;
        bool near = max_f64(fabs(off), fabs(other_off)) <= reach;
        if (own >> 1 != other >> 1 || (near && own != other))
            return MANY_RAYS;
        if (fabs(other_off - off) > thin)
            needed = FEW_RAYS;
    }
    return needed;
}

/* Laser light in every pixel of the band, averaged over the pixel where it may be broken.
 *
 * lines (line_height, line_width, 2) has one pixel of margin that codes, offs and out (height,
 * width) have not; band (count) of pixels; many and few (.., 2) places in a pixel; emitter (3),
 * plane (5); kinds (thing_count), rows (.., 64), eyes and lamps (.., 16). */
EXPORT(void, cast_laser)(int64_t line_height, int64_t line_width, int64_t count,
                         int64_t many_count, int64_t few_count, int64_t thing_count,
                         int64_t height, int64_t width, const float *lines, const int32_t *band,
                         const double *many, const double *few, const double *emitter,
                         const double *plane, const int64_t *kinds, const double *rows,
                         const double *eyes, const double *lamps, int32_t *codes, float *offs,
                         float *out)
{
    (void)line_height;
    Laser laser = {{thing_count, kinds, (const Thing *)rows}, *(const Vector *)emitter,
                   (const Plane *)plane, (const Bundle *)lamps};
    const Bundle *eye = (const Bundle *)eyes;
    const Line *first = (const Line *)lines + line_width + 1;
    for (int64_t i = 0; i < count; i++) {
        int64_t pixel = band[i];
        const Line *line = first + pixel / width * line_width + pixel % width;
        Lit seen = laser_along(&laser, eye, (Vector){line->x, line->y, 1.0});
        out[pixel] = (float)seen.value;
        codes[pixel] = seen.code;
        offs[pixel] = (float)seen.off_mm;
    }
    for (int64_t i = 0; i < count; i++) {
        int64_t pixel = band[i];
        int needed = rays_needed(codes, offs, height, width, pixel, laser.plane->sigma_mm);
        if (needed == ONE_RAY)
            continue;
        const Line *line = first + pixel / width * line_width + pixel % width;
        PixelRays rays = rays_of(line, line_width);
        int64_t spot_count = needed == MANY_RAYS ? many_count : few_count;
        const double *spots = needed == MANY_RAYS ? many : few;
        double total = 0.0;
        for (int64_t s = 0; s < spot_count; s++)
            total += laser_along(&laser, eye, ray_at(&rays, spots + 2 * s)).value;
        out[pixel] = (float)(total / (double)spot_count);
    }
}
