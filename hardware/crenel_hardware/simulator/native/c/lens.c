/* The lens: Brown's distortion, and the ray that each pixel sees along. */

typedef struct {
    double fx, fy, cx, cy, k1, k2, p1, p2, k3;
} Lens;

/* What the lens makes of ideal image coordinates x/z, y/z. */
static inline void distort(const Lens *lens, double a, double b, double *x, double *y)
{
    double r2 = a * a + b * b;
    double radial = 1.0 + r2 * (lens->k1 + r2 * (lens->k2 + r2 * lens->k3));
    *x = a * radial + 2.0 * lens->p1 * a * b + lens->p2 * (r2 + 2.0 * a * a);
    *y = b * radial + lens->p1 * (r2 + 2.0 * b * b) + 2.0 * lens->p2 * a * b;
}

enum { ROUNDS = 12, AT_ONCE = 64 };

/* x/z and y/z (height, width, 2) of the ray through every pixel's centre, the lens (9) undone.
 *
 * The first row and column are those of pixel -1. Some pixels of a row at once, so that the
 * compiler works on several side by side. */
EXPORT(void, sight_lines)(int64_t height, int64_t width, const double *lens, float *lines)
{
    const Lens *own = (const Lens *)lens;
    for (int64_t r = 0; r < height; r++) {
        double v = ((double)(r - 1) - own->cy) / own->fy;
        for (int64_t first = 0; first < width; first += AT_ONCE) {
            int count = (int)min_i64(AT_ONCE, width - first);
            double u[AT_ONCE], x[AT_ONCE], y[AT_ONCE];
            for (int i = 0; i < count; i++) {
                x[i] = u[i] = ((double)(first + i - 1) - own->cx) / own->fx;
                y[i] = v;
            }
            for (int round = 0; round < ROUNDS; round++)
                for (int i = 0; i < count; i++) {
                    double seen_x, seen_y;
                    distort(own, x[i], y[i], &seen_x, &seen_y);
                    x[i] += u[i] - seen_x;
                    y[i] += v - seen_y;
                }
            float *line = lines + 2 * (r * width + first);
            for (int i = 0; i < count; i++) {
                line[2 * i] = (float)x[i];
                line[2 * i + 1] = (float)y[i];
            }
        }
    }
}
