"""Poses of a flange behind a tool, and in another base frame.

Quaternions are unit quaternions in the order x, y, z, w. A pose ``T_ab`` maps coordinates in b to
coordinates in a. Everything here is pure; numbers are plain floats, since one pose comes at a time.
"""

from crenel.rotations import Quaternion, Vector, multiply


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
