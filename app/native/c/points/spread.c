/* How well each point of a scan is known by the fit of its stripe alone (Eq. 9 differentiated).
 *
 * uncertainty = 1000 |depth| |turn - (point - centre) along| sigma, in µm; the depth is that
 * along the camera's axis. point_spread.py derives turn and along.
 *
 * points_mm (n, 3), sigma_px (n), turn (3), centre_mm (3), axis (3); found (n) is filled. */
EXPORT(void, spread)(int64_t n, const double *points_mm, const double *sigma_px,
                     const double *turn, const double *centre_mm, double along,
                     const double *axis, double behind_mm, double *found_um)
{
    for (int64_t i = 0; i < n; i++) {
        const double *p = points_mm + 3 * i;
        double depth = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2] + behind_mm;
        double a = turn[0] - (p[0] - centre_mm[0]) * along;
        double b = turn[1] - (p[1] - centre_mm[1]) * along;
        double c = turn[2] - (p[2] - centre_mm[2]) * along;
        found_um[i] = 1e3 * fabs(depth) * sqrt(a * a + b * b + c * c) * sigma_px[i];
    }
}
