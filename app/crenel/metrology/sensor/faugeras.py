"""The perspective matrix of a camera by Faugeras and Toscani: the article's intrinsic calibration.

The twelve elements of the matrix follow linearly from points known in the object frame and in the
image, under ``|m3| = 1`` (m3: the first three elements of the third row). This constraint is
invariant to rotations and translations of the object frame, and it allows an origin in the camera's
own plane, unlike ``m34 = 1``.
"""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import join, message, quantity
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.transforms import Floats, nearest_rotation

# Condition number of the normalised system: 4 to 9 for a good object, 87 for a step of 0.5 mm.
LARGEST_CONDITION = 50.0
# Share of the largest extent below which a set of points counts as flat.
FLAT = 1e-6


@dataclass(frozen=True)
class FaugerasSolution:
    """The result of the linear step.

    ``projection_matrix`` (3, 4) has ``|m3| = 1`` and maps the object frame in mm to pixels;
    ``camera`` has the intrinsics and the pose derived from it, without skew and distortion;
    ``orthogonality_defect`` is ``|R R' - I|`` before ``R`` was made a rotation, 0 for perfect data;
    ``condition_number`` is that of the normalised system.
    """

    projection_matrix: Floats
    camera: Camera
    orthogonality_defect: float
    condition_number: float


def solve_faugeras(
    points_mm: Floats, uv_px: Floats, width_px: int, height_px: int
) -> FaugerasSolution:
    """Perspective matrix, intrinsics and pose of a camera from known points, linearly.

    Args:
        points_mm: (N, 3) in the object frame, N >= 6, on more than one plane.
        uv_px: (N, 2) their pixels; distortion is not modelled.
        width_px, height_px: size of the image.

    Returns:
        The camera, whose sensor frame is the object frame, with figures of its quality.

    Raises:
        OperationError: ``points-malformed``, ``points-not-finite``; points that do not determine
            the matrix (``degenerate-...``); ``object-mirrored``.

    Source:
        Faugeras and Toscani, with the constraint ``|m3| = 1``; normalisation by Hartley (1997).
    """
    points = np.asarray(points_mm, dtype=np.float64)
    uv = np.asarray(uv_px, dtype=np.float64)
    _require_points(points, uv)
    T_object = _normalising(points)
    T_image = _normalising(uv)
    x = points @ T_object[:3, :3].T + T_object[:3, 3]
    y = uv @ T_image[:2, :2].T + T_image[:2, 2]
    system = _system(x, y)
    condition = _condition(system, points)
    # T_object is a similarity, so |m3| = 1 here and |m3| = 1 in mm differ by a factor only.
    matrix = np.linalg.inv(T_image) @ _least_under_unit_m3(system) @ T_object
    matrix = _in_front(matrix / np.linalg.norm(matrix[2, :3]), points)
    camera, defect = _decompose(matrix, width_px, height_px)
    return FaugerasSolution(matrix, camera, defect, condition)


def _require_points(points: Floats, uv: Floats) -> None:
    if points.ndim != 2 or points.shape[1] != 3 or uv.shape != (len(points), 2):
        raise OperationError(
            "points-malformed",
            message(
                "object-points-shape-pixels-shape",
                points=str(points.shape),
                pixels=str(uv.shape),
            ),
            message("each-point-needs-three-coordinates-one"),
        )
    if not (np.isfinite(points).all() and np.isfinite(uv).all()):
        raise OperationError("points-not-finite", message("object-point-or-pixel-not-a-number"))
    if len(points) < 6:
        raise OperationError(
            "degenerate-too-few-points",
            message("corners-were-found-picture", points=len(points)),
            message("cameras-matrix-needs-least-six-crests"),
            message("bring-more-object-into-picture"),
        )
    _refuse_flat(points)


def _refuse_flat(points: Floats) -> None:
    """Explains why points in one plane (or on one line) do not determine the camera."""
    _, extent, axes = np.linalg.svd(points - points.mean(axis=0))
    if extent[2] > FLAT * extent[0]:
        return
    if np.ptp(points[:, 2]) <= FLAT * extent[0]:
        raise OperationError(
            "degenerate-one-level",
            message(
                "all-corners-lie-one-level-z",
                points=len(points),
                z=quantity(points[0, 2], "mm", 3),
            ),
            message("one-plane-does-not-determine-camera"),
            message("place-sensor-so-both-crests-floors"),
        )
    normal = join([quantity(value, "", 2) for value in axes[2]], " ")
    raise OperationError(
        "degenerate-one-row",
        message("all-corners-lie-one-plane-normal", points=len(points), normal=normal),
        message("only-one-row-corners-each-level"),
        message("bring-front-back-edge-level-into"),
    )


def _normalising(points: Floats) -> Floats:
    """Hartley's similarity: centroid to 0, rms distance to the square root of the dimension."""
    n = points.shape[1]
    centre = points.mean(axis=0)
    rms = float(np.sqrt(np.mean(np.sum((points - centre) ** 2, axis=1))))
    if rms == 0.0:
        raise OperationError("degenerate-one-pixel", message("all-corners-were-given-same-pixel"))
    T = np.eye(n + 1)
    T[:n, :n] *= np.sqrt(n) / rms
    T[:n, n] = -centre * np.sqrt(n) / rms
    return T


def _system(x: Floats, y: Floats) -> Floats:
    """(2N, 12): the columns of m1, m14, m2, m24, m34 (nine), then those of m3 (three)."""
    n = len(x)
    rows = np.zeros((2 * n, 12))
    rows[:n, 0:3], rows[:n, 3] = x, 1.0
    rows[n:, 4:7], rows[n:, 7] = x, 1.0
    rows[:n, 8], rows[n:, 8] = -y[:, 0], -y[:, 1]
    rows[:n, 9:] = -y[:, :1] * x
    rows[n:, 9:] = -y[:, 1:] * x
    return rows


def _condition(system: Floats, points: Floats) -> float:
    """Ratio of largest to smallest singular value, without the one of the solution."""
    values = np.linalg.svd(system, compute_uv=False)
    condition = float(values[0] / max(values[10], 1e-300))
    if condition > LARGEST_CONDITION:
        raise OperationError(
            "degenerate-flat",
            message(
                "corners-fix-camera-badly-condition-number",
                points=len(points),
                condition=f"{condition:.3g}",
                limit=quantity(LARGEST_CONDITION),
            ),
            message("they-lie-almost-one-plane-almost"),
            message("use-object-higher-step-show-crests"),
        )
    return condition


def _least_under_unit_m3(system: Floats) -> Floats:
    """The (3, 4) matrix of least algebraic error with ``|m3| = 1``.

    With ``B v1 + C v2 = 0`` (v2 = m3), v2 is the least singular vector of the part of C outside the
    columns of B, and ``v1 = -B^+ C v2``.
    """
    B, C = system[:, :9], system[:, 9:]
    Q, R = np.linalg.qr(B)
    outside = C - Q @ (Q.T @ C)
    v2 = np.linalg.svd(outside)[2][-1]
    v1 = -np.linalg.solve(R, Q.T @ (C @ v2))
    return np.array([v1[0:4], v1[4:8], [*v2, v1[8]]])


def _in_front(matrix: Floats, points: Floats) -> Floats:
    """The matrix with the sign that puts the points in front of the camera."""
    depths = points @ matrix[2, :3] + matrix[2, 3]
    if np.all(depths < 0):
        return -matrix
    if np.all(depths > 0):
        return matrix
    raise OperationError(
        "degenerate-behind-the-camera",
        message(
            "corners-would-lie-behind-camera",
            behind=int(min((depths > 0).sum(), (depths < 0).sum())),
            points=len(points),
        ),
        message("corners-mistaken-or-not-of-object"),
    )


def _decompose(matrix: Floats, width_px: int, height_px: int) -> tuple[Camera, float]:
    """Intrinsics and pose of a matrix with ``|m3| = 1``, and the orthogonality defect."""
    m1, m2, m3 = matrix[:, :3]
    u0, v0 = float(m1 @ m3), float(m2 @ m3)
    fx = float(np.linalg.norm(np.cross(m1, m3)))
    fy = float(np.linalg.norm(np.cross(m2, m3)))
    R = np.array([(m1 - u0 * m3) / fx, (m2 - v0 * m3) / fy, m3])
    if np.linalg.det(R) < 0:
        raise OperationError(
            "object-mirrored",
            message("picture-shows-objects-mirror-image"),
            message("left-right-corners-were-exchanged-image"),
            message("check-objects-certificate-cameras-flip-setting"),
        )
    defect = float(np.linalg.norm(R @ R.T - np.eye(3)))
    m14, m24, m34 = matrix[:, 3]
    translation = np.array([(m14 - u0 * m34) / fx, (m24 - v0 * m34) / fy, m34])
    K = np.array([[fx, 0.0, u0], [0.0, fy, v0], [0.0, 0.0, 1.0]])
    return Camera(K, nearest_rotation(R), translation, width_px, height_px), defect
