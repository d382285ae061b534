/* Where the picture is steepest near the edges that a camera predicts.
 *
 * Stations (n) along the edges: uv (n, 2) pixels and normal (n, 2), unit, towards the edge's first
 * region. Pictures (height, width) are grey levels, NaN where they must not count. */

static const double PARALLEL_TO_PART = 1e-6;

/* Distances (n, 2) along and against each normal to the nearest part but the station's own.
 *
 * part (n): the station's own; ends (p, 4): of the parts, as u0, v0, u1, v1, in the picture;
 * beyond_px: as much longer each counts at either end. workspace (4, p). */
EXPORT(void, edge_clearance)(int64_t n, int64_t p, const double *uv, const double *normal,
                             const int64_t *part, const double *ends, double beyond_px,
                             double *clearance, double *workspace)
{
    double *du = workspace, *dv = du + p, *least = dv + p, *longer = least + p;
    for (int64_t k = 0; k < p; k++) {
        du[k] = ends[4 * k + 2] - ends[4 * k];
        dv[k] = ends[4 * k + 3] - ends[4 * k + 1];
        double length = sqrt(du[k] * du[k] + dv[k] * dv[k]);
        least[k] = PARALLEL_TO_PART * length;
        longer[k] = beyond_px / length;
    }
    for (int64_t i = 0; i < n; i++) {
        double u = uv[2 * i], v = uv[2 * i + 1], nu = normal[2 * i], nv = normal[2 * i + 1];
        double ahead = INFINITY, behind = INFINITY;
        for (int64_t k = 0; k < p; k++) {
            double det = nu * dv[k] - nv * du[k];
            if (k == part[i] || fabs(det) < least[k])
                continue;
            double ru = ends[4 * k] - u, rv = ends[4 * k + 1] - v;
            /* how far along the part, times det squared */
            double along = (nv * ru - nu * rv) * det, beyond = longer[k] * det * det;
            if (along < -beyond || along > det * det + beyond)
                continue;
            double away = (ru * dv[k] - rv * du[k]) / det;
            if (away >= 0)
                ahead = min_f64(ahead, away);
            else
                behind = min_f64(behind, -away);
        }
        clearance[2 * i] = ahead;
        clearance[2 * i + 1] = behind;
    }
}

/* The picture between four pixels; NaN beyond its outermost. */
static inline double between_pixels(const double *image, int64_t height, int64_t width, double u,
                                    double v)
{
    if (!(u >= 0 && v >= 0 && u < (double)(width - 1) && v < (double)(height - 1)))
        return NAN;
    int64_t column = (int64_t)u, row = (int64_t)v;
    const double *upper = image + row * width + column, *lower = upper + width;
    double a = u - (double)column, b = v - (double)row;
    double above = (1 - a) * upper[0] + a * upper[1];
    double below = (1 - a) * lower[0] + a * lower[1];
    return (1 - b) * above + b * below;
}

/* Offset along each normal, px, and slope there, grey levels a pixel, of the steepest place.
 *
 * found (n, 2) is NaN where the picture has no value. The search goes `radius` far, but halfway to
 * the next edge only (clearance as above); each place is the mean over `half` pixels of edge to
 * either side. workspace (2, 2 reach + 1): reach is two pixels more than the radius. */
EXPORT(void, steepest_places)(int64_t height, int64_t width, int64_t n, int64_t line,
                              const double *image, const double *uv, const double *normal,
                              const double *clearance, double radius, int64_t half, double *found,
                              double *workspace)
{
    double *profile = workspace, *slope = workspace + line;
    int64_t reach = line / 2;
    for (int64_t i = 0; i < n; i++) {
        double nu = normal[2 * i], nv = normal[2 * i + 1];
        double high = min_f64(radius, max_f64(0.5 * clearance[2 * i], 1.0));
        double low = -min_f64(radius, max_f64(0.5 * clearance[2 * i + 1], 1.0));
        int64_t first = max_i64(reach + (int64_t)ceil(low), 2);
        int64_t last = min_i64(reach + (int64_t)floor(high), 2 * reach - 2);
        for (int64_t k = first - 2; k <= last + 2; k++) {
            double u = uv[2 * i] + (double)(k - reach) * nu;
            double v = uv[2 * i + 1] + (double)(k - reach) * nv, total = 0.0;
            for (int64_t j = -half; j <= half; j++)
                total += between_pixels(image, height, width, u - (double)j * nv,
                                        v + (double)j * nu);
            profile[k] = total / (double)(2 * half + 1);
        }
        double best = -1.0;
        int64_t at = -1;
        for (int64_t k = first - 1; k <= last + 1; k++)
            slope[k] = 0.5 * (profile[k + 1] - profile[k - 1]);
        for (int64_t k = first; k <= last; k++)
            if (fabs(slope[k]) > best) {
                best = fabs(slope[k]);
                at = k;
            }
        found[2 * i] = found[2 * i + 1] = NAN;
        if (at < 0)
            continue;
        double left = fabs(slope[at - 1]), right = fabs(slope[at + 1]);
        double bend = left - 2 * best + right;
        double shift = bend < 0 ? 0.5 * (left - right) / bend : 0.0;
        found[2 * i] = (double)(at - reach) + min_f64(max_f64(shift, -0.5), 0.5);
        found[2 * i + 1] = slope[at];
    }
}

/* The picture (n, line) along each normal, every pixel; the places lie in the middle. */
EXPORT(void, profiles_across)(int64_t height, int64_t width, int64_t n, int64_t line,
                              const double *image, const double *uv, const double *normal,
                              double *profiles)
{
    for (int64_t i = 0; i < n; i++)
        for (int64_t k = 0; k < line; k++) {
            double away = (double)(k - line / 2);
            profiles[line * i + k] = between_pixels(image, height, width,
                                                    uv[2 * i] + away * normal[2 * i],
                                                    uv[2 * i + 1] + away * normal[2 * i + 1]);
        }
}
