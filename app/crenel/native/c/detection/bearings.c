/* Step 2 of block detection: segments along each direction as bearings in the plane across it.
 *
 * A labelling says which of the object's axes each direction is: a rotation (3, 3) from the object
 * to the camera and the number of the direction that is x, y and z. */

static const double PI = 3.14159265358979323846;

/* Bearings of collinear segments merged, and the weightiest of each labelling and axis.
 *
 * normals (n, 3) of the planes through the camera and each segment, in the camera's frame, weight
 * (n) and family (n), the weightiest first; rotations (l, 3, 3) and order (l, 3) are labellings.
 * Filled: merged (l, 3, b, 2) unit normals of the bearings in the planes across x, y and z, their
 * summed (l, 3, b) weights, the weightiest first, and counts (l, 3). workspace (2, n). */
EXPORT(void, merge_bearings)(int64_t n, int64_t l, int64_t b, const double *normals,
                             const double *weight, const int64_t *family, const double *rotations,
                             const int64_t *order, double near_rad, double *merged,
                             double *summed, int64_t *counts, double *workspace)
{
    double *angles = workspace, *total = workspace + n;
    for (int64_t row = 0; row < 3 * l; row++) {
        const double *rotation = rotations + row / 3 * 9;
        int64_t axis = row % 3, one = (axis + 1) % 3, other = (axis + 2) % 3, count = 0;
        for (int64_t s = 0; s < n; s++) {
            if (family[s] != order[row])
                continue;
            const double *normal = normals + 3 * s;
            double u = normal[0] * rotation[one] + normal[1] * rotation[3 + one] +
                       normal[2] * rotation[6 + one];
            double v = normal[0] * rotation[other] + normal[1] * rotation[3 + other] +
                       normal[2] * rotation[6 + other];
            double angle = atan2(v, u), nearest = near_rad;
            int64_t at = -1;
            angle += angle < 0 ? PI : 0.0;
            for (int64_t m = 0; m < count; m++) {
                double apart = fabs(angle - angles[m]);
                apart = min_f64(apart, fabs(PI - apart));
                if (apart < nearest) {
                    nearest = apart;
                    at = m;
                }
            }
            if (at >= 0) {
                total[at] += weight[s];
            } else {
                angles[count] = angle;
                total[count++] = weight[s];
            }
        }
        counts[row] = min_i64(count, b);
        for (int64_t m = 0; m < counts[row]; m++) {
            int64_t best = 0;
            for (int64_t k = 1; k < count; k++)
                best = total[k] > total[best] ? k : best;
            double *to = merged + 2 * (b * row + m);
            to[0] = cos(angles[best]);
            to[1] = sin(angles[best]);
            summed[b * row + m] = total[best];
            total[best] = -1.0;
        }
    }
}
