"""The pose of a tool frame in a base frame, from chains of transforms."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel_hardware.arm.robots.transform_chain import STALE_NS, FramePlacement, TransformChain
from crenel_hardware.errors import DeviceError
from tests.present import present

MS = 1_000_000


def placement(seed: int, stamp_ns: int = 0) -> tuple[FramePlacement, np.ndarray]:
    """A random transform, and the same as a matrix (4, 4)."""
    random = np.random.default_rng(seed)
    rotation = Rotation.random(random_state=seed)
    position_mm = random.uniform(-500, 500, 3)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation.as_matrix(), position_mm
    x, y, z = position_mm.tolist()
    qx, qy, qz, qw = rotation.as_quat().tolist()
    return FramePlacement(stamp_ns, (x, y, z), (qx, qy, qz, qw)), T


def matrix(found: FramePlacement | None) -> np.ndarray:
    assert found is not None
    T = np.eye(4)
    T[:3, :3] = Rotation.from_quat(found.rotation).as_matrix()
    T[:3, 3] = found.position_mm
    return T


@pytest.fixture
def chain() -> TransformChain:
    return TransformChain("/tf", "base", "tool")


def test_a_chain_leads_over_the_frame_that_both_descend_from(chain: TransformChain) -> None:
    """world -> base, world -> stand -> rail (moves) -> tool."""
    T = {}
    for seed, (parent, child) in enumerate([("world", "base"), ("world", "stand")]):
        made, T[child] = placement(seed)
        chain.add(parent, child, made, is_static=True)
    assert chain.pose() is None
    moving, T["rail"] = placement(7, 5 * MS)
    chain.add("stand", "rail", moving)
    assert chain.pose() is None
    made, T["tool"] = placement(8)
    chain.add("rail", "tool", made, is_static=True)
    found = chain.pose()
    expected = np.linalg.inv(T["base"]) @ T["stand"] @ T["rail"] @ T["tool"]
    np.testing.assert_allclose(matrix(found), expected, atol=1e-9)
    assert present(found).stamp_ns == 5 * MS
    assert chain.pose() is None  # nothing newer
    moved, T_moved = placement(9, 9 * MS)
    chain.add("stand", "rail", moved)
    expected = np.linalg.inv(T["base"]) @ T["stand"] @ T_moved @ T["tool"]
    np.testing.assert_allclose(matrix(chain.pose()), expected, atol=1e-9)


def test_transforms_of_different_times_meet_at_the_newest_common_one(chain: TransformChain) -> None:
    turned = (0.0, 0.0, float(np.sin(0.01)), float(np.cos(0.01)))
    still = (0.0, 0.0, 0.0, 1.0)
    chain.add("base", "arm", FramePlacement(0, (0.0, 0.0, 0.0), still))
    chain.add("base", "arm", FramePlacement(10 * MS, (10.0, 0.0, 0.0), turned))
    chain.add("arm", "tool", FramePlacement(4 * MS, (0.0, 0.0, 100.0), still))
    found = present(chain.pose())
    assert found.stamp_ns == 4 * MS
    assert found.position_mm == pytest.approx((4.0, 0.0, 100.0))
    assert Rotation.from_quat(found.rotation).magnitude() == pytest.approx(0.008, rel=1e-3)


def test_what_is_overtaken_or_repeated_changes_nothing(chain: TransformChain) -> None:
    first, T = placement(1, 10 * MS)
    chain.add("base", "tool", first)
    np.testing.assert_allclose(matrix(chain.pose()), T, atol=1e-9)
    for stamp_ns in (10 * MS, 2 * MS):
        chain.add("base", "tool", placement(2, stamp_ns)[0])
        assert chain.pose() is None
    # a clock that was set back is passed on, for the judge of the stream to refuse
    chain.add("base", "tool", placement(3, 10 * MS - 2 * STALE_NS)[0])
    assert chain.pose() is not None


def test_a_transform_that_stopped_is_named(chain: TransformChain) -> None:
    chain.add("base", "arm", placement(1, 0)[0])
    chain.add("arm", "tool", placement(2, 0)[0])
    assert chain.pose() is not None
    chain.add("arm", "tool", placement(2, STALE_NS)[0])
    assert chain.pose() is None
    chain.add("arm", "tool", placement(2, STALE_NS + MS)[0])
    with pytest.raises(DeviceError, match=r"from base to arm of /tf is 1\.0 s behind"):
        chain.pose()


def test_frames_that_are_not_connected_are_named() -> None:
    chain = TransformChain("/tf", "base", "tool0")
    chain.add("base", "arm", placement(1, 0)[0])
    chain.add("elsewhere", "camera", placement(2, 0)[0])
    assert chain.pose() is None
    error = chain.missing_error()
    assert "No transforms of /tf lead from base to tool0" in str(error.what)
    assert "arm, base, camera, elsewhere" in str(error.remedy)


def test_a_chain_that_cannot_move_gives_no_pose(chain: TransformChain) -> None:
    chain.add("base", "tool", placement(1)[0], is_static=True)
    assert chain.pose() is None
    assert "Nothing between base and tool moves" in str(chain.missing_error().what)


def test_frames_in_a_circle_lead_nowhere(chain: TransformChain) -> None:
    for parent, child in (("a", "tool"), ("b", "a"), ("a", "b")):
        chain.add(parent, child, placement(1, 0)[0])
    assert chain.pose() is None


def test_another_parent_within_the_chain_is_refused(chain: TransformChain) -> None:
    chain.add("base", "arm", placement(1, 0)[0])
    chain.add("arm", "tool", placement(2, 0)[0])
    assert chain.pose() is not None
    chain.add("base", "camera", placement(3, 0)[0])
    chain.add("arm", "camera", placement(3, MS)[0])  # not of this chain
    with pytest.raises(DeviceError, match="tool of /tf is now in base instead of arm"):
        chain.add("base", "tool", placement(2, MS)[0])
