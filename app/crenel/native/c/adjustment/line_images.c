/* How pixels lie across the images of straight lines, with all derivatives. */

enum { UNDISTORTING_ROUNDS = 50 };
static const double UNDISTORTED = 1e-12;

/* The direction that the lens bends to (xd, yd). */
static void undistort(double xd, double yd, Brown lens, double *x, double *y)
{
    double p1 = lens.p1, p2 = lens.p2;
    *x = xd;
    *y = yd;
    for (int round = 0; round < UNDISTORTING_ROUNDS; round++) {
        double r2 = *x * *x + *y * *y;
        double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
        double x_next = (xd - 2 * p1 * *x * *y - p2 * (r2 + 2 * *x * *x)) / radial;
        double y_next = (yd - p1 * (r2 + 2 * *y * *y) - 2 * p2 * *x * *y) / radial;
        double moved = fabs(x_next - *x) + fabs(y_next - *y);
        *x = x_next;
        *y = y_next;
        if (moved < UNDISTORTED)
            break;
    }
}

/* Where on start + share along the ray (x, y, 1) of the camera comes nearest to it. */
static double nearest_share(double x, double y, const double *pose, const double *start,
                            const double *along)
{
    /* in the camera's frame the ray begins at the origin */
    const double ray[3] = {x, y, 1.0};
    double across = 0.0, down = 0.0, ahead = 0.0, square = x * x + y * y + 1.0;
    for (int k = 0; k < 3; k++) {
        double a = turned_to_camera(pose, k, along), s = in_camera(pose, k, start);
        across += ray[k] * a;
        down += ray[k] * s;
        ahead += a * s;
    }
    /* -s . (r x (r x a)) over a . (r x (r x a)) */
    return (square * ahead - across * down) / (across * across - square * dot_3(along, along));
}

/* Distances (n), px, of pixels uv (n, 2) from the images of the lines starts + share alongs (n, 3),
 * each at the share (n) where its ray comes nearest to the line; unit normals (n, 2) of the images;
 * derivatives (n, columns) by the camera's parameters (projection.py), zero beyond these, and
 * by_points (n, 3) by the lines' points.
 *
 * pose (3, 4): rotation and translation; lens (9): fx, fy, cx, cy, k1, k2, p1, p2, k3. */
EXPORT(void, across_lines)(int64_t n, int64_t columns, const double *uv, const double *starts,
                           const double *alongs, const double *pose, const double *lens,
                           double *off, double *normals, double *jacobian, double *by_points,
                           double *shares)
{
    double fx = lens[0], fy = lens[1], cx = lens[2], cy = lens[3];
    Brown glass = brown_from(lens + 4);
    for (int64_t i = 0; i < n; i++) {
        const double *start = starts + 3 * i, *along = alongs + 3 * i;
        double *row = jacobian + columns * i, x, y, point[3];
        undistort((uv[2 * i] - cx) / fx, (uv[2 * i + 1] - cy) / fy, glass, &x, &y);
        double share = nearest_share(x, y, pose, start, along);
        for (int k = 0; k < 3; k++)
            point[k] = start[k] + share * along[k];
        double X = in_camera(pose, 0, point), Y = in_camera(pose, 1, point);
        double Z = in_camera(pose, 2, point);
        x = X / Z;
        y = Y / Z;
        Bent at = bend(x, y, glass);
        /* of pixels by x and y, and how a direction along the line moves these */
        double u_x = fx * at.xx, u_y = fx * at.xy, v_x = fy * at.xy, v_y = fy * at.yy;
        double c = turned_to_camera(pose, 2, along);
        double x_along = (turned_to_camera(pose, 0, along) - x * c) / Z;
        double y_along = (turned_to_camera(pose, 1, along) - y * c) / Z;
        double tu = u_x * x_along + u_y * y_along, tv = v_x * x_along + v_y * y_along;
        double length = sqrt(tu * tu + tv * tv), nu = -tv / length, nv = tu / length;
        /* along the normal: by the point in the camera's frame, then by all parameters */
        double n_x = nu * u_x + nv * v_x, n_y = nu * u_y + nv * v_y;
        double n_X = n_x / Z, n_Y = n_y / Z, n_Z = -(n_x * x + n_y * y) / Z;
        memset(row, 0, (size_t)columns * sizeof *row);
        row[0] = -nu * at.x;
        row[1] = -nv * at.y;
        row[2] = -nu;
        row[3] = -nv;
        row[4] = Z * n_Y - Y * n_Z;
        row[5] = X * n_Z - Z * n_X;
        row[6] = Y * n_X - X * n_Y;
        row[7] = -n_X;
        row[8] = -n_Y;
        row[9] = -n_Z;
        row[10] = -(nu * fx * x + nv * fy * y) * at.r2;
        row[11] = row[10] * at.r2;
        row[12] = -nu * fx * 2 * x * y - nv * fy * (at.r2 + 2 * y * y);
        row[13] = -nu * fx * (at.r2 + 2 * x * x) - nv * fy * 2 * x * y;
        for (int k = 0; k < 3; k++)
            by_points[3 * i + k] = -(n_X * pose[k] + n_Y * pose[4 + k] + n_Z * pose[8 + k]);
        off[i] = (uv[2 * i] - fx * at.x - cx) * nu + (uv[2 * i + 1] - fy * at.y - cy) * nv;
        normals[2 * i] = nu;
        normals[2 * i + 1] = nv;
        shares[i] = share;
    }
}
