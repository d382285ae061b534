/* How bright a place on a thing looks under the room's light.
 *
 * The light comes from afar, or from a lamp near by, whose shadows, fading and highlights are
 * then worked out ray by ray; the rest of it comes from everywhere alike. */

#define GRAIN_PER_MM 5.0
#define MARKS_LONGER 40.0 /* length of a tool mark over its width */
#define MARK_TEXELS 4.0   /* texels of the grain that make one mark's width */
#define ON_SURFACE 1e-5   /* what casts a shadow is nearer to the lamp by this share of the way */

enum { GRAIN = 256 };

typedef struct {
    double directed, ambient;
    double shade;   /* how strictly a groove's walls keep the light away */
    double texture;
    double away_mm; /* of the lamp from the sensor frame's origin */
} Look;

/* The light, and the surface that it falls on. */
typedef struct {
    const Vector *towards; /* for each thing, the way to light from afar, in its frame */
    int64_t place_count;   /* none for light from afar */
    const Bundle *places;  /* a bundle from each place on the lamp */
    const Look *look;
    const float *grain; /* (GRAIN, GRAIN) */
} Light;

/* Of the whole lamp, or of all light; `lit` is how many places of the lamp reach. */
typedef struct {
    double diffuse, mirrored;
    int lit;
} Received;

typedef struct {
    double value; /* 1 for a bright face */
    int lit;
} Radiance;

/* The texture between its texels; repeats for ever. */
static inline double grain_at(const float *grain, double a, double b)
{
    double low_a = floor(a), low_b = floor(b), wa = a - low_a, wb = b - low_b;
    int i = (int)low_a, j = (int)low_b, mask = GRAIN - 1;
    const float *row = grain + GRAIN * (j & mask), *next = grain + GRAIN * ((j + 1) & mask);
    int i0 = i & mask, i1 = (i + 1) & mask;
    return (1.0 - wb) * ((1.0 - wa) * row[i0] + wa * row[i1]) +
           wb * ((1.0 - wa) * next[i0] + wa * next[i1]);
}

/* Share of the light that the block's own walls leave to a place. */
static inline double sky_over(const Hit *hit, int64_t kind, const Thing *thing, double shade)
{
    if (kind != COMB || shade <= 0.0 || hit->face == TOP)
        return 1.0;
    int groove = hit->face / NEXT, face = hit->face % NEXT;
    double deep = thing->high.z - thing->comb.floor, sky = 1.0;
    if (face == FLOOR) {
        const double *walls = thing->comb.edges + 2 * groove + 1;
        double a = hit->at.x - walls[0], b = walls[1] - hit->at.x;
        sky = 0.5 * (a / sqrt(a * a + deep * deep) + b / sqrt(b * b + deep * deep));
    } else if (face == LEFT || face == RIGHT) {
        sky = 0.5 + 0.5 * (hit->at.z - thing->comb.floor) / deep;
    }
    return 1.0 - shade * (1.0 - min_f64(max_f64(sky, 0.0), 1.0));
}

/* What grain and tool marks make of a face's brightness. */
static inline double surface(const Hit *hit, const Thing *thing, double texture,
                             const float *grain)
{
    int face = hit->face % NEXT;
    double a = hit->at.x, b = hit->at.y;
    if (face == FRONT || face == BACK)
        b = hit->at.z + 31.0;
    else if (face == LEFT || face == RIGHT)
        a = hit->at.z + 17.0;
    a += 1000.0;
    b += 1000.0;
    double found = 1.0 + texture * grain_at(grain, a * GRAIN_PER_MM, b * GRAIN_PER_MM);
    if (thing->marks > 0.0) {
        double per_mm = MARK_TEXELS / thing->mark_mm;
        found += thing->marks * grain_at(grain, a * per_mm / MARKS_LONGER, b * per_mm);
    }
    return max_f64(found, 0.0);
}

/* From a place on a thing to where the rays of a bundle start, in the thing's frame. */
static inline Vector back_to(const Bundle *rays, Vector at)
{
    return (Vector){rays->origin.x - at.x, rays->origin.y - at.y, rays->origin.z - at.z};
}

/* Whether a place on the lamp does not reach what was hit, or only from behind. */
static inline bool in_shadow(const Hit *hit, const Things *all, const Bundle *place)
{
    const Bundle *rays = place + hit->thing;
    Vector way = back_to(rays, hit->at);
    if (dot(hit->normal, way) <= 0.0)
        return true;
    Vector down = out_of_thing(rays->turn, way);
    return blocked(all, place, (Vector){-down.x, -down.y, -down.z}, 1.0 - ON_SURFACE);
}

/* Light of one place on the lamp that reaches what was hit. */
static inline Received from_place(const Hit *hit, const Thing *thing, const Bundle *eye,
                                  const Bundle *place, double away_mm)
{
    Vector way = back_to(place + hit->thing, hit->at);
    double far = sqrt(dot(way, way)), share = away_mm / far, strength = share * share;
    double diffuse = max_f64(dot(hit->normal, way), 0.0) / far * strength;
    if (thing->gloss <= 0.0)
        return (Received){diffuse, 0.0, 1};
    Vector view = back_to(eye + hit->thing, hit->at);
    double near = sqrt(dot(view, view));
    Vector middle = {way.x / far + view.x / near, way.y / far + view.y / near,
                     way.z / far + view.z / near};
    double cosine = dot(hit->normal, middle) / sqrt(dot(middle, middle));
    double glint = pow(max_f64(cosine, 0.0), thing->sharpness);
    return (Received){diffuse, strength * thing->gloss * glint, 1};
}

/* Light of the whole lamp.
 *
 * The middle and three places at the rim are tried first; where they agree, so do the rest. */
static inline Received from_lamp(const Hit *hit, const Things *all, const Bundle *eye,
                                 const Light *light)
{
    int64_t count = light->place_count, tried = min_i64(count, 4), dark = 0;
    Received found = {0.0, 0.0, 0};
    for (int64_t m = 0; m < count; m++) {
        int64_t inwards = m == 0 ? 0 : count - m; /* the middle, then from the rim inwards */
        const Bundle *place = light->places + inwards * all->count;
        bool shadowed = dark == tried;
        if (m < tried) {
            shadowed = in_shadow(hit, all, place);
            dark += shadowed;
        } else if (dark > 0 && dark < tried) {
            shadowed = in_shadow(hit, all, place);
        }
        if (shadowed)
            continue;
        const Thing *thing = all->things + hit->thing;
        Received one = from_place(hit, thing, eye, place, light->look->away_mm);
        found.diffuse += one.diffuse / (double)count;
        found.mirrored += one.mirrored / (double)count;
        found.lit++;
    }
    return found;
}

/* Brightness of what was hit. */
static inline Radiance radiance(const Hit *hit, const Things *all, const Bundle *eye,
                                const Light *light)
{
    int64_t kind = all->kinds[hit->thing];
    const Thing *thing = all->things + hit->thing;
    const Look *look = light->look;
    Received got = {0.0, 0.0, 0};
    if (light->place_count == 0)
        got.diffuse = max_f64(dot(hit->normal, light->towards[hit->thing]), 0.0);
    else
        got = from_lamp(hit, all, eye, light);
    double matt = albedo(kind, thing, hit->face) *
                  (look->directed * got.diffuse + look->ambient) *
                  sky_over(hit, kind, thing, look->shade) *
                  surface(hit, thing, look->texture, light->grain);
    return (Radiance){matt + look->directed * got.mirrored, got.lit};
}
