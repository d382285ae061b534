/* How the simulated arm stands in space, and joint angles for a pose: kinematics.py has the model.
 *
 * The inverse is damped least squares with the Jacobian of the chain. */

#define ROTATION_LEVER_MM 200.0 /* one radian of orientation weighs as much as this length */

enum { MOST_JOINTS = 16 };

typedef struct {
    double at[4][4];
} Matrix;

typedef struct {
    double a, alpha, d, theta, sign;
} Link;

/* An arm as truly built: links, the error transform behind each, and the joints' limits. */
typedef struct {
    int64_t joint_count;
    const Link *links;
    const Matrix *errors;
    const double (*limits)[2];
} Arm;

/* Where an arm stands: its flange, and each joint's axis and a point on it, in the arm frame. */
typedef struct {
    Matrix flange;
    double axis[MOST_JOINTS][3], origin[MOST_JOINTS][3];
} Stand;

static inline Matrix product(const Matrix *a, const Matrix *b)
{
    Matrix found;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            found.at[i][j] = a->at[i][0] * b->at[0][j] + a->at[i][1] * b->at[1][j] +
                             a->at[i][2] * b->at[2][j] + a->at[i][3] * b->at[3][j];
    return found;
}

/* Where the arm stands with joint angles q. */
static void stand_at(const Arm *arm, const double *q, Stand *stand)
{
    Matrix T = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    for (int64_t i = 0; i < arm->joint_count; i++) {
        const Link *link = arm->links + i;
        for (int k = 0; k < 3; k++) {
            stand->axis[i][k] = link->sign * T.at[k][2];
            stand->origin[i][k] = T.at[k][3];
        }
        double angle = link->sign * q[i] + link->theta;
        double c = cos(angle), s = sin(angle), ca = cos(link->alpha), sa = sin(link->alpha);
        Matrix A = {{{c, -s * ca, s * sa, link->a * c},
                     {s, c * ca, -c * sa, link->a * s},
                     {0, sa, ca, link->d},
                     {0, 0, 0, 1}}};
        T = product(&T, &A);
        T = product(&T, arm->errors + i);
    }
    stand->flange = T;
}

/* Flange poses (pose_count, 4, 4) for joint angles (pose_count, n).
 *
 * dh (n, 5), errors (n, 4, 4). */
EXPORT(void, flange_poses)(int64_t n, int64_t pose_count, const double *dh, const double *errors,
                           const double *q, double *poses)
{
    Arm arm = {n, (const Link *)dh, (const Matrix *)errors, NULL};
    Stand stand;
    for (int64_t i = 0; i < pose_count; i++) {
        stand_at(&arm, q + n * i, &stand);
        ((Matrix *)poses)[i] = stand.flange;
    }
}

/* How far a target is from a pose (6): in mm, turns weighed by the lever; returns the norm. */
static double misfit(const Matrix *T, const Matrix *target, double *e)
{
    double R[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            R[i][j] = target->at[i][0] * T->at[j][0] + target->at[i][1] * T->at[j][1] +
                      target->at[i][2] * T->at[j][2];
    double x = R[2][1] - R[1][2], y = R[0][2] - R[2][0], z = R[1][0] - R[0][1];
    double sine = 0.5 * sqrt(x * x + y * y + z * z);
    double angle = atan2(sine, 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0));
    double lever = (sine > 1e-12 ? 0.5 * angle / sine : 0.5) * ROTATION_LEVER_MM;
    e[3] = x * lever;
    e[4] = y * lever;
    e[5] = z * lever;
    double sum = e[3] * e[3] + e[4] * e[4] + e[5] * e[5];
    for (int k = 0; k < 3; k++) {
        e[k] = target->at[k][3] - T->at[k][3];
        sum += e[k] * e[k];
    }
    return sqrt(sum);
}

/* Solves H x = b by elimination with pivoting; b becomes x, and H is used up. */
static void solve(double H[6][6], double b[6])
{
    for (int k = 0; k < 6; k++) {
        int pivot = k;
        for (int i = k + 1; i < 6; i++)
            pivot = fabs(H[i][k]) > fabs(H[pivot][k]) ? i : pivot;
        for (int j = 0; j < 6; j++) {
            double kept = H[k][j];
            H[k][j] = H[pivot][j];
            H[pivot][j] = kept;
        }
        double kept = b[k];
        b[k] = b[pivot];
        b[pivot] = kept;
        for (int i = k + 1; i < 6; i++) {
            double share = H[i][k] / H[k][k];
            for (int j = k + 1; j < 6; j++)
                H[i][j] -= share * H[k][j];
            b[i] -= share * b[k];
        }
    }
    for (int k = 5; k >= 0; k--) {
        for (int j = k + 1; j < 6; j++)
            b[k] -= H[k][j] * b[j];
        b[k] /= H[k][k];
    }
}

/* The step dq (n) of damped least squares from where the arm stands, to mend e (6).
 *
 * J' (J J' + damping)^-1 e: a seventh joint then turns by no rounding error. */
static void step_towards(const Arm *arm, const Stand *stand, const double *e, double damping,
                         double *dq)
{
    double J[MOST_JOINTS][6], H[6][6] = {{0.0}}, share[6];
    for (int64_t i = 0; i < arm->joint_count; i++) {
        const double *a = stand->axis[i], *o = stand->origin[i];
        double x = stand->flange.at[0][3] - o[0], y = stand->flange.at[1][3] - o[1],
               z = stand->flange.at[2][3] - o[2];
        J[i][0] = a[1] * z - a[2] * y;
        J[i][1] = a[2] * x - a[0] * z;
        J[i][2] = a[0] * y - a[1] * x;
        for (int k = 0; k < 3; k++)
            J[i][3 + k] = a[k] * ROTATION_LEVER_MM;
        for (int j = 0; j < 6; j++)
            for (int k = 0; k < 6; k++)
                H[j][k] += J[i][j] * J[i][k];
    }
    for (int k = 0; k < 6; k++)
        H[k][k] += damping * 1e2;
    memcpy(share, e, sizeof share);
    solve(H, share);
    for (int64_t i = 0; i < arm->joint_count; i++) {
        dq[i] = 0.0;
        for (int k = 0; k < 6; k++)
            dq[i] += J[i][k] * share[k];
    }
}

/* Moves joint angles q (n) so that the flange comes to a target; returns what misfits, in mm. */
static double descend(const Arm *arm, const Matrix *target, int64_t steps, double *q)
{
    int64_t n = arm->joint_count;
    Stand stand, next_stand;
    double e[6], next_e[6], next[MOST_JOINTS], damping = 1e-2;
    stand_at(arm, q, &stand);
    double norm = misfit(&stand.flange, target, e);
    for (int64_t step = 0; step < steps && norm >= 1e-9 && damping <= 1e8; step++) {
        step_towards(arm, &stand, e, damping, next);
        double largest = 0.0;
        for (int64_t i = 0; i < n; i++)
            largest = max_f64(largest, fabs(next[i]));
        double share = largest > 0.4 ? 0.4 / largest : 1.0;
        for (int64_t i = 0; i < n; i++) {
            double moved = q[i] + share * next[i];
            next[i] = min_f64(max_f64(moved, arm->limits[i][0]), arm->limits[i][1]);
        }
        stand_at(arm, next, &next_stand);
        double next_norm = misfit(&next_stand.flange, target, next_e);
        if (next_norm < norm) {
            memcpy(q, next, sizeof(double) * (size_t)n);
            memcpy(e, next_e, sizeof e);
            stand = next_stand;
            norm = next_norm;
            damping = max_f64(damping * 0.2, 1e-9); /* solvable in a singular posture, too */
        } else {
            damping *= 6.0;
        }
    }
    return norm;
}

/* Joint angles along a path of flange poses, each from the last; returns how many it reached.
 *
 * dh (n, 5), errors (n, 4, 4), limits (n, 2), start (n), targets (target_count, 4, 4); path
 * (target_count, n) and misfits_mm (target_count) are filled up to the first that is not reached:
 * missed by more than reached_mm, or a joint turned by more than jump_rad to it. */
EXPORT(int64_t, follow)(int64_t n, int64_t target_count, const double *dh, const double *errors,
                        const double *limits, const double *start, const double *targets,
                        double *path, double *misfits_mm, double reached_mm, double jump_rad,
                        int64_t steps)
{
    Arm arm = {n, (const Link *)dh, (const Matrix *)errors, (const double(*)[2])limits};
    const double *before = start;
    for (int64_t i = 0; i < target_count; i++) {
        double *q = path + n * i, turned = 0.0;
        memcpy(q, before, sizeof(double) * (size_t)n);
        misfits_mm[i] = descend(&arm, (const Matrix *)targets + i, steps, q);
        for (int64_t k = 0; k < n; k++)
            turned = max_f64(turned, fabs(q[k] - before[k]));
        if (!(misfits_mm[i] <= reached_mm) || turned > jump_rad)
            return i;
        before = q;
    }
    return target_count;
}
