/* Stripe pixels to points in the arm frame, each frame in its pose, and how well each point is
 * known by the fit of its stripe alone (Eq. 9, and Eq. 9 differentiated by the pixel).
 *
 * The lens' distortion is taken back, the camera's ray meets the laser plane, and the point is
 * brought to the arm frame. */
#include "../export.h"

enum { PIXELS_AT_ONCE = 128 };

/* The camera and the laser plane before it; reconstruct.py gives them in this order. */
typedef struct {
    double matrix[3][3], distortion[5], rotation[3][3], centre_mm[3];
    double normal[3];   /* of the plane, in the camera's frame */
    double distance_mm; /* of the plane from the camera's centre, along its normal */
    double across[2];   /* by what a pixel across the stripe turns the ray (x, y, 1) */
} Sensor;

/* Directions (x, y, 1) in the camera's frame, and the depth along its axis, of some pixels. */
typedef struct {
    double x[PIXELS_AT_ONCE], y[PIXELS_AT_ONCE], depth_mm[PIXELS_AT_ONCE];
} Rays;

/* One Newton step towards the direction that Brown's model distorts to (xd, yd). */
static inline void newton(double *x_, double *y_, double xd, double yd, const double distortion[5])
{
    double k1 = distortion[0], k2 = distortion[1], p1 = distortion[2], p2 = distortion[3];
    double k3 = distortion[4], x = *x_, y = *y_;
    double r2 = x * x + y * y;
    double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    double slope = 2.0 * (k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3));
    double left_x = xd - (x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x));
    double left_y = yd - (y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y);
    double xx = radial + slope * x * x + 2.0 * p1 * y + 6.0 * p2 * x;
    double xy = slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y;
    double yy = radial + slope * y * y + 6.0 * p1 * y + 2.0 * p2 * x;
    double per_det = 1.0 / (xx * yy - xy * xy);
    *x_ = x + (yy * left_x - xy * left_y) * per_det;
    *y_ = y + (xx * left_y - xy * left_x) * per_det;
}

/* The depth is NaN where a ray does not meet the plane in front of the camera. */
static void find_rays(int64_t n, const double *restrict u, const double *restrict v,
                      const Sensor *sensor, Rays *restrict rays)
{
    const Sensor known = *sensor; /* a copy, which the loop's writing cannot change */
    double per_fx = 1.0 / known.matrix[0][0], per_fy = 1.0 / known.matrix[1][1];
    /* divisions wait for one another less with more of them under way than a register holds */
#pragma clang loop vectorize_width(16)
    for (int64_t i = 0; i < n; i++) {
        double yd = (v[i] - known.matrix[1][2]) * per_fy;
        double xd = (u[i] - known.matrix[0][2] - known.matrix[0][1] * yd) * per_fx;
        double x = xd, y = yd;
        /* written out: around another loop this one is not vectorised */
        newton(&x, &y, xd, yd, known.distortion);
        newton(&x, &y, xd, yd, known.distortion);
        newton(&x, &y, xd, yd, known.distortion);
        newton(&x, &y, xd, yd, known.distortion);
        const double *normal = known.normal;
        double depth = known.distance_mm / (normal[0] * x + normal[1] * y + normal[2]);
        rays->x[i] = x;
        rays->y[i] = y;
        rays->depth_mm[i] = depth > 0.0 && depth < INFINITY ? depth : NAN;
    }
}

/* The camera's pose (3, 4) in the arm frame. */
static void place_camera(const double *T_arm_sensor, const Sensor *sensor, double pose[3][4])
{
    for (int i = 0; i < 3; i++) {
        const double *row = T_arm_sensor + 4 * i, *centre = sensor->centre_mm;
        for (int j = 0; j < 3; j++) {
            const double *axis = sensor->rotation[j];
            pose[i][j] = row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2];
        }
        pose[i][3] = row[0] * centre[0] + row[1] * centre[1] + row[2] * centre[2] + row[3];
    }
}

static void write_points(int64_t n, const Rays *restrict rays, double pose[3][4],
                         double *restrict points_mm)
{
    double a[4], b[4], c[4];
    memcpy(a, pose[0], sizeof a);
    memcpy(b, pose[1], sizeof b);
    memcpy(c, pose[2], sizeof c);
    for (int64_t i = 0; i < n; i++) {
        double x = rays->x[i], y = rays->y[i], depth = rays->depth_mm[i];
        points_mm[3 * i] = a[3] + depth * (a[0] * x + a[1] * y + a[2]);
        points_mm[3 * i + 1] = b[3] + depth * (b[0] * x + b[1] * y + b[2]);
        points_mm[3 * i + 2] = c[3] + depth * (c[0] * x + c[1] * y + c[2]);
    }
}

/* A pixel across the stripe moves the point by depth (across - turned (x, y, 1)), with turned what
 * keeps it in the plane. */
static void write_spread(int64_t n, const Rays *restrict rays, const double *restrict sigma_px,
                         const Sensor *sensor, double *restrict spread_um)
{
    const double *normal = sensor->normal;
    double across_u = sensor->across[0], across_v = sensor->across[1];
    double along = (normal[0] * across_u + normal[1] * across_v) / sensor->distance_mm;
    for (int64_t i = 0; i < n; i++) {
        double depth = rays->depth_mm[i], turned = depth * along;
        double a = across_u - turned * rays->x[i], b = across_v - turned * rays->y[i];
        spread_um[i] = 1e3 * depth * sqrt(a * a + b * b + turned * turned) * sigma_px[i];
    }
}

/* u_px, v_px, sigma_px (n) of frames that follow one another, each of count (frames) pixels, in
 * poses T_arm_sensor (frames, 4, 4). points_mm (n, 3) is filled, and spread_um (n) unless sigma_px
 * and it are NULL. Returns how many pixels the frames have, -1 where they have more than n. */
EXPORT(int64_t, frame_points)(int64_t n, int64_t frames, const double *u_px, const double *v_px,
                              const double *sigma_px, const int64_t *count,
                              const double *T_arm_sensor, const double *constants,
                              double *points_mm, double *spread_um)
{
    Sensor sensor;
    memcpy(&sensor, constants, sizeof sensor);
    Rays rays;
    int64_t at = 0;
    for (int64_t f = 0; f < frames; f++) {
        if (count[f] < 0 || count[f] > n - at)
            return -1;
        double pose[3][4];
        place_camera(T_arm_sensor + 16 * f, &sensor, pose);
        for (int64_t end = at + count[f]; at < end;) {
            int64_t some = min_i64(end - at, PIXELS_AT_ONCE);
            find_rays(some, u_px + at, v_px + at, &sensor, &rays);
            write_points(some, &rays, pose, points_mm + 3 * at);
            if (spread_um)
                write_spread(some, &rays, sigma_px + at, &sensor, spread_um + at);
            at += some;
        }
    }
    return at;
}
