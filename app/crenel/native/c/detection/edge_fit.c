/* How far measured edge points lie from those that a camera predicts, with all derivatives. */

/* Residuals (n), px along the normals, and their derivatives (n, 12) by a step of `moved`
 * (edge_fit.py): focal lengths, principal point, turn, shift, k1, k2.
 *
 * points (n, 3), mm; uv (n, 2), px; normal (n, 2); pose (3, 4): rotation and translation;
 * lens (10): fx, fy, skew, cx, cy, k1, k2, p1, p2, k3; width: of the picture. */
EXPORT(void, edge_rows)(int64_t n, const double *points, const double *uv, const double *normal,
                        const double *pose, const double *lens, double width, double *off,
                        double *jacobian)
{
    enum { COUNT = 12 };
    double fx = lens[0], fy = lens[1], skew = lens[2], cx = lens[3], cy = lens[4];
    Brown glass = brown_from(lens + 5);
    double distance = sqrt(pose[3] * pose[3] + pose[7] * pose[7] + pose[11] * pose[11]);
    for (int64_t i = 0; i < n; i++) {
        const double *point = points + 3 * i;
        double nu = normal[2 * i], nv = normal[2 * i + 1], *row = jacobian + COUNT * i;
        double X = in_camera(pose, 0, point), Y = in_camera(pose, 1, point);
        double Z = in_camera(pose, 2, point), x = X / Z, y = Y / Z;
        Bent at = bend(x, y, glass);
        off[i] = nu * (uv[2 * i] - fx * at.x - skew * at.y - cx) +
                 nv * (uv[2 * i + 1] - fy * at.y - cy);
        /* the residual by the distorted direction, by the undistorted, and by the point */
        double by_xd = -nu * fx, by_yd = -nu * skew - nv * fy;
        double by_x = by_xd * at.xx + by_yd * at.xy, by_y = by_xd * at.xy + by_yd * at.yy;
        double by_X = by_x / Z, by_Y = by_y / Z, by_Z = -(by_x * x + by_y * y) / Z;
        row[1] = -nv * fy * at.y;
        row[0] = -nu * fx * at.x + row[1];
        row[2] = -nu * width;
        row[3] = -nv * width;
        row[4] = Y * by_Z - Z * by_Y;
        row[5] = Z * by_X - X * by_Z;
        row[6] = X * by_Y - Y * by_X;
        row[7] = distance * by_X;
        row[8] = distance * by_Y;
        row[9] = distance * by_Z;
        row[10] = (by_xd * x + by_yd * y) * at.r2;
        row[11] = row[10] * at.r2;
    }
}
