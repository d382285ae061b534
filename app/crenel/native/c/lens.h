/* Brown's lens model: where it bends a direction (x / z, y / z) to, with the derivatives. */
#ifndef CRENEL_LENS_H
#define CRENEL_LENS_H

#include "export.h"

typedef struct {
    double k1, k2, p1, p2, k3;
} Brown;

typedef struct {
    double r2;         /* the squared distance of the direction from the axis */
    double x, y;       /* where it is bent to */
    double xx, xy, yy; /* derivatives; that of y by x is that of x by y */
} Bent;

static inline Brown brown_from(const double distortion[5])
{
    return (Brown){distortion[0], distortion[1], distortion[2], distortion[3], distortion[4]};
}

static inline Bent bend(double x, double y, Brown lens)
{
    double p1 = lens.p1, p2 = lens.p2, r2 = x * x + y * y;
    double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    double slope = 2 * (lens.k1 + r2 * (2 * lens.k2 + 3 * r2 * lens.k3));
    return (Bent){
        .r2 = r2,
        .x = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
        .y = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
        .xx = radial + slope * x * x + 2 * p1 * y + 6 * p2 * x,
        .xy = slope * x * y + 2 * p1 * x + 2 * p2 * y,
        .yy = radial + slope * y * y + 6 * p1 * y + 2 * p2 * x,
    };
}

/* Component k of a point in the camera's frame; pose (3, 4) is rotation and translation. */
static inline double in_camera(const double *pose, int k, const double *point)
{
    const double *row = pose + 4 * k;
    return row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
}

/* Component k of a direction in the camera's frame. */
static inline double turned_to_camera(const double *pose, int k, const double *along)
{
    const double *row = pose + 4 * k;
    return row[0] * along[0] + row[1] * along[1] + row[2] * along[2];
}

#endif
