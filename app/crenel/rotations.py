"""Rotations in the words of robot controllers: the one place where their conventions are kept.

Tables of poses, drivers and checks use it. A quaternion is a unit quaternion x, y, z, w, and stands
for the rotation from the flange's frame to the arm's. Everything is pure; numbers are plain floats,
since a driver reads one pose at a time.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import cos, sin, sqrt

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

VECTOR, SCALAR_LAST, SCALAR_FIRST = "vector", "xyzw", "wxyz"
_SMALL_RAD = 1e-9


@dataclass(frozen=True)
class RotationConvention:
    """How a rotation is written in numbers."""

    columns: tuple[str, ...]
    """What the controller calls them, in small letters."""
    form: str
    """``vector``: the axis, as long as the angle; ``xyzw`` or ``wxyz``: a quaternion; else the axes
    of a product, such as ``ZYX`` for Rz · Ry · Rx."""
    order: tuple[int, int, int] = (0, 1, 2)
    """Which of the numbers is the angle about the first, second and third axis of the product."""

    @property
    def is_quaternion(self) -> bool:
        """Whether the numbers are no angles."""
        return self.form in (SCALAR_LAST, SCALAR_FIRST)

    @property
    def product(self) -> str:
        """As a formula: ``Rz(a) · Ry(b) · Rx(c)``; empty if it is none."""
        if self.is_quaternion or self.form == VECTOR:
            return ""
        axes = zip(self.form.lower(), self.order, strict=True)
        return " · ".join(f"R{axis}({self.columns[k]})" for axis, k in axes)


def _convention(
    columns: str, form: str, order: tuple[int, int, int] = (0, 1, 2)
) -> RotationConvention:
    return RotationConvention(tuple(columns.split()), form, order)


QUATERNION = _convention("qx qy qz qw", SCALAR_LAST)
CONVENTIONS: Mapping[str, RotationConvention] = {
    "abb": _convention("q1 q2 q3 q4", SCALAR_FIRST),
    "comau": _convention("a e r", "ZYZ"),
    "denso": _convention("rx ry rz", "ZYX", (2, 1, 0)),
    "doosan": _convention("a b c", "ZYZ"),
    "epson": _convention("u v w", "ZYX"),
    "fanuc": _convention("w p r", "ZYX", (2, 1, 0)),
    "kawasaki": _convention("o a t", "ZYZ"),
    "kuka": _convention("a b c", "ZYX"),
    "mitsubishi": _convention("a b c", "ZYX", (2, 1, 0)),
    "staubli": _convention("rx ry rz", "XYZ"),
    "techman": _convention("rx ry rz", "ZYX", (2, 1, 0)),
    "universal-robots": _convention("rx ry rz", VECTOR),
    "yaskawa": _convention("rx ry rz", "ZYX", (2, 1, 0)),
    "rotation-vector": _convention("rx ry rz", VECTOR),
    **{
        f"euler-{axes}": _convention("e1 e2 e3", axes)
        for axes in ("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX")
        + ("XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ")
    },
}
"""The conventions of controllers by their makers, and by what they are. ``QUATERNION`` needs no
statement."""


def quaternion_of(convention: RotationConvention, values: Sequence[float]) -> Quaternion:
    """The rotation that numbers of a convention are.

    Args:
        values: in the order of ``columns``; angles in rad. A quaternion is normalized.

    Example:
        >>> turned = quaternion_of(CONVENTIONS["kuka"], (3.141592653589793, 0.0, 0.0))
        >>> [round(value, 6) for value in turned]
        [0.0, 0.0, 1.0, 0.0]
    """
    if convention.form == SCALAR_FIRST:
        w, x, y, z = values
        return _normalize((x, y, z, w))
    if convention.form == SCALAR_LAST:
        x, y, z, w = values
        return _normalize((x, y, z, w))
    if convention.form == VECTOR:
        x, y, z = values
        return _of_vector((x, y, z))
    found: Quaternion = (0.0, 0.0, 0.0, 1.0)
    for axis, k in zip(convention.form, convention.order, strict=True):
        half = values[k] / 2
        turn = [sin(half) if axis == one else 0.0 for one in "XYZ"]
        found = multiply(found, (turn[0], turn[1], turn[2], cos(half)))
    return found


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


def _of_vector(vector_rad: Vector) -> Quaternion:
    x, y, z = vector_rad
    angle = sqrt(x * x + y * y + z * z)
    scale = 0.5 if angle < _SMALL_RAD else sin(angle / 2) / angle
    return _normalize((x * scale, y * scale, z * scale, cos(angle / 2)))


def _normalize(q: Quaternion) -> Quaternion:
    length = sqrt(sum(value * value for value in q))
    return (q[0] / length, q[1] / length, q[2] / length, q[3] / length)
