"""Rotations as robot controllers report them, and poses of a flange behind a tool.

Quaternions are unit quaternions in the order x, y, z, w. A pose ``T_ab`` maps coordinates in b to
coordinates in a. Everything here is pure; numbers are plain floats, since one pose comes at a time.
"""

from math import cos, sin, sqrt

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

_SMALL_RAD = 1e-9


def rotation_vector_quaternion(vector_rad: Vector) -> Quaternion:
    """Of a rotation vector: the axis, as long as the angle in radians (Universal Robots)."""
    x, y, z = vector_rad
    angle = sqrt(x * x + y * y + z * z)
    scale = 0.5 if angle < _SMALL_RAD else sin(angle / 2) / angle
    return _normalize((x * scale, y * scale, z * scale, cos(angle / 2)))


def axis_angles_quaternion(
    about_x_rad: float, about_y_rad: float, about_z_rad: float
) -> Quaternion:
    """Of ``Rz(about_z) Ry(about_y) Rx(about_x)``: KUKA's C, B, A and FANUC's W, P, R."""
    cx, sx = cos(about_x_rad / 2), sin(about_x_rad / 2)
    cy, sy = cos(about_y_rad / 2), sin(about_y_rad / 2)
    cz, sz = cos(about_z_rad / 2), sin(about_z_rad / 2)
    return _normalize(
        (
            sx * cy * cz - cx * sy * sz,
            cx * sy * cz + sx * cy * sz,
            cx * cy * sz - sx * sy * cz,
            cx * cy * cz + sx * sy * sz,
        )
    )


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """The rotation b followed by the rotation a, normalized."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return _normalize(
        (
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz,
        )
    )


def rotate(q: Quaternion, v: Vector) -> Vector:
    """The vector v, rotated by q."""
    x, y, z, w = q
    tx = 2 * (y * v[2] - z * v[1])
    ty = 2 * (z * v[0] - x * v[2])
    tz = 2 * (x * v[1] - y * v[0])
    return (
        v[0] + w * tx + y * tz - z * ty,
        v[1] + w * ty + z * tx - x * tz,
        v[2] + w * tz + x * ty - y * tx,
    )


def flange_behind_tool(
    tool_mm: Vector, tool: Quaternion, offset_mm: Vector, offset: Quaternion
) -> tuple[Vector, Quaternion]:
    """``T_base_flange = T_base_tool T_flange_tool^-1``.

    Args:
        tool_mm: position of the tool in the base frame, mm.
        tool: orientation of the tool in the base frame.
        offset_mm: position of the tool in the flange frame, mm.
        offset: orientation of the tool in the flange frame.

    Returns:
        Position in mm and orientation of the flange in the base frame.
    """
    x, y, z, w = offset
    flange = multiply(tool, (-x, -y, -z, w))
    ox, oy, oz = rotate(flange, offset_mm)
    return (tool_mm[0] - ox, tool_mm[1] - oy, tool_mm[2] - oz), flange


def place_in_arm(
    base_mm: Vector, base: Quaternion, position_mm: Vector, orientation: Quaternion
) -> tuple[Vector, Quaternion]:
    """``T_arm_b = T_arm_base T_base_b``: a pose in a base frame of the controller, in the arm's
    frame. Positions in mm."""
    x, y, z = rotate(base, position_mm)
    placed = (base_mm[0] + x, base_mm[1] + y, base_mm[2] + z)
    return placed, multiply(base, orientation)


def _normalize(q: Quaternion) -> Quaternion:
    length = sqrt(sum(value * value for value in q))
    return (q[0] / length, q[1] / length, q[2] / length, q[3] / length)
