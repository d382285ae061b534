"""Rotations of robot controllers, against SciPy's."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel.rotations import CONVENTIONS, Quaternion, Vector, multiply, quaternion_of
from crenel_hardware.arm.robots.tool_frames import flange_behind_tool, rotate
from crenel_hardware.arm.universal_robots.ur_rtde import flange_pose

ANGLE = st.floats(-3.2, 3.2)
VECTORS = st.tuples(ANGLE, ANGLE, ANGLE)


def rotation_vector(vector: Vector) -> Quaternion:
    return quaternion_of(CONVENTIONS["rotation-vector"], vector)


def assert_same_rotation(quaternion: tuple[float, ...], expected: Rotation) -> None:
    assert np.linalg.norm(quaternion) == pytest.approx(1.0, abs=1e-12)
    assert (Rotation.from_quat(quaternion) * expected.inv()).magnitude() < 1e-7


@given(VECTORS)
def test_a_rotation_vector(vector: Vector) -> None:
    assert_same_rotation(rotation_vector(vector), Rotation.from_rotvec(vector))


@pytest.mark.parametrize("length", [0.0, 1e-300, 1e-12, 1e-8, np.pi, 2 * np.pi])
def test_rotation_vectors_of_no_length_and_of_turns(length: float) -> None:
    vector = (0.6 * length, 0.0, -0.8 * length)
    assert_same_rotation(rotation_vector(vector), Rotation.from_rotvec(vector))


SCIPY = {
    "comau": "ZYZ", "denso": "xyz", "doosan": "ZYZ", "epson": "ZYX", "fanuc": "xyz",
    "kawasaki": "ZYZ", "kuka": "ZYX", "mitsubishi": "xyz", "staubli": "XYZ", "techman": "xyz",
    "yaskawa": "xyz",
}  # fmt: skip
"""How SciPy calls the angles of controllers."""


@given(ANGLE, ANGLE, ANGLE)
def test_the_angles_of_each_controller(x: float, y: float, z: float) -> None:
    own = {name: name.removeprefix("euler-") for name in CONVENTIONS if name.startswith("euler-")}
    assert {*SCIPY, *own, "abb", "universal-robots", "rotation-vector"} == {*CONVENTIONS}
    for name, axes in (SCIPY | own).items():
        expected = Rotation.from_euler(axes, [x, y, z])
        assert_same_rotation(quaternion_of(CONVENTIONS[name], (x, y, z)), expected)
    xyzw = Rotation.from_rotvec([x, y, z]).as_quat()
    found = quaternion_of(CONVENTIONS["abb"], np.roll(xyzw, 1).tolist())
    assert_same_rotation(found, Rotation.from_quat(xyzw))


@given(VECTORS, VECTORS, VECTORS)
def test_products_and_rotated_vectors(a: Vector, b: Vector, v: Vector) -> None:
    A, B = Rotation.from_rotvec(a), Rotation.from_rotvec(b)
    qa, qb = rotation_vector(a), rotation_vector(b)
    assert_same_rotation(multiply(qa, qb), A * B)
    np.testing.assert_allclose(rotate(qa, v), A.apply(v), atol=1e-12)


@given(VECTORS, VECTORS, VECTORS, VECTORS)
def test_the_flange_behind_a_tool(
    flange_m: Vector, flange: Vector, offset_m: Vector, offset: Vector
) -> None:
    T_base_flange, T_flange_tool = matrix(flange_m, flange), matrix(offset_m, offset)
    T = T_base_flange @ T_flange_tool
    tool_pose = (*T[:3, 3], *Rotation.from_matrix(T[:3, :3]).as_rotvec())
    position_mm, quaternion = flange_pose(tool_pose, (*offset_m, *offset))
    np.testing.assert_allclose(position_mm, np.multiply(flange_m, 1000), atol=1e-6)
    assert_same_rotation(quaternion, Rotation.from_rotvec(flange))


def test_a_tool_without_offset_is_the_flange() -> None:
    turned = rotation_vector((0.1, 0.2, 0.3))
    none = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)
    position, quaternion = flange_behind_tool((1.0, 2.0, 3.0), turned, *none)
    assert position == (1.0, 2.0, 3.0)
    assert quaternion == pytest.approx(turned)


def matrix(position: Vector, vector: Vector) -> NDArray[np.float64]:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_rotvec(vector).as_matrix(), position
    return T
