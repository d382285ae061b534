/* The room's light: what the camera gets of it from every face.
 *
 * All in the camera's frame, in which a pixel's ray is (x, y, 1). Pictures here are one pixel
 * wider on every side than the frame. */

enum { PLACES = 16 }; /* a code is 16 times that of a face, plus the places of the lamp that reach */

/* x and y of the ray through a pixel's centre. */
typedef struct {
    float x, y;
} Line;

/* How the ray of a pixel changes with the place in the pixel. */
typedef struct {
    double x, y, x_by_u, y_by_u, x_by_v, y_by_v;
} PixelRays;

/* Of the pixel of a line, whose neighbours are at `line + 1` and `line + width`. */
static inline PixelRays rays_of(const Line *line, int64_t width)
{
    double x = line->x, y = line->y;
    return (PixelRays){x, y, line[1].x - x, line[1].y - y, line[width].x - x, line[width].y - y};
}

/* The ray through a place in a pixel, -0.5 to 0.5 from its centre. */
static inline Vector ray_at(const PixelRays *rays, const double *spot)
{
    double a = spot[0], b = spot[1];
    return (Vector){rays->x + a * rays->x_by_u + b * rays->x_by_v,
                    rays->y + a * rays->y_by_u + b * rays->y_by_v, 1.0};
}

/* One ray through each pixel's centre: brightness, and a code of the face that it meets.
 *
 * lines (height, width, 2); kinds (count), rows (count, 64), eyes (count, 16), lights (count, 3);
 * lamps (place_count, count, 16); look (5), grain (256, 256); codes and out (height, width) are
 * filled. */
EXPORT(void, cast_room)(int64_t height, int64_t width, int64_t count, int64_t place_count,
                         const float *lines, const int64_t *kinds, const double *rows,
                         const double *eyes, const double *lights, const double *lamps,
                         const double *look, const float *grain, int32_t *codes, float *out)
{
    Things all = {count, kinds, (const Thing *)rows};
    Light light = {(const Vector *)lights, place_count, (const Bundle *)lamps,
                   (const Look *)look, grain};
    const Bundle *eye = (const Bundle *)eyes;
    const Line *line = (const Line *)lines;
    for (int64_t start = 0; start < height * width; start += RUN) {
        Run run;
        run.count = min_i64(height * width - start, RUN);
        for (int64_t i = 0; i < run.count; i++) {
            run.x[i] = line[start + i].x;
            run.y[i] = line[start + i].y;
        }
        trace_run(&run, &all, eye);
        for (int64_t i = 0; i < run.count; i++) {
            Hit hit = hit_of_run(&run, i, &all, eye);
            Radiance seen = {0.0, 0};
            if (hit.thing >= 0)
                seen = radiance(&hit, &all, eye, &light);
            out[start + i] = (float)seen.value;
            codes[start + i] = (int32_t)((hit.thing * 1024 + hit.face) * PLACES + seen.lit);
        }
    }
}

/* Whether two neighbours show different faces, or one of them plainly otherwise lit.
 *
 * In half shadow the light falls off place by place of the lamp; a ray a pixel draws that. */
static inline bool differ(int32_t own, int32_t other, int32_t place_count)
{
    int32_t lit = other % PLACES - own % PLACES;
    return other / PLACES != own / PLACES || 8 * (lit < 0 ? -lit : lit) > place_count;
}

static inline bool at_edge(const int32_t *code, int64_t width, int32_t place_count)
{
    bool found = false;
    for (int64_t row = -width; row <= width; row += width)
        for (int64_t column = -1; column <= 1; column++)
            found |= differ(*code, code[row + column], place_count);
    return found;
}

/* Light of a pixel, averaged over places in it. */
static inline double average_light(const PixelRays *rays, int64_t spot_count, const double *spots,
                                   const Things *all, const Bundle *eye, const Light *light)
{
    double total = 0.0;
    for (int64_t start = 0; start < spot_count; start += RUN) {
        Run run;
        run.count = min_i64(spot_count - start, RUN);
        for (int64_t i = 0; i < run.count; i++) {
            Vector d = ray_at(rays, spots + 2 * (start + i));
            run.x[i] = d.x;
            run.y[i] = d.y;
        }
        trace_run(&run, all, eye);
        for (int64_t i = 0; i < run.count; i++) {
            Hit hit = hit_of_run(&run, i, all, eye);
            if (hit.thing >= 0)
                total += radiance(&hit, all, eye, light).value;
        }
    }
    return total / (double)spot_count;
}

/* Averages many rays over each pixel that an edge may cross.
 *
 * lines to out as of cast_room; spots (spot_count, 2) in a pixel. */
EXPORT(void, refine_room)(int64_t height, int64_t width, int64_t spot_count, int64_t count,
                           int64_t place_count, const float *lines, const double *spots,
                           const int64_t *kinds, const double *rows, const double *eyes,
                           const double *lights, const double *lamps, const double *look,
                           const float *grain, const int32_t *codes, float *out)
{
    Things all = {count, kinds, (const Thing *)rows};
    Light light = {(const Vector *)lights, place_count, (const Bundle *)lamps,
                   (const Look *)look, grain};
    const Bundle *eye = (const Bundle *)eyes;
    for (int64_t r = 1; r < height - 1; r++)
        for (int64_t c = 1; c < width - 1; c++) {
            int64_t pixel = r * width + c;
            if (!at_edge(codes + pixel, width, (int32_t)place_count))
                continue;
            PixelRays rays = rays_of((const Line *)lines + pixel, width);
            out[pixel] = (float)average_light(&rays, spot_count, spots, &all, eye, &light);
        }
}
