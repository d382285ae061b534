"""The 3D view, as a real client sees it over its web socket."""

from collections.abc import Iterator
from contextlib import closing

import httpx
import numpy as np
import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from crenel.formats.clouds.points import Points, pack_points
from crenel.metrology.arm.kinematics import Joint, flange_pose, link_transforms, tip_centres
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.crenellated_block import Crenellated, corners
from crenel.metrology.transforms import rigid, rotation_from_vector
from crenel.station.view3d.cloud_colouring import Circumstances
from crenel.station.view3d.meshes import block_mesh, box, link_path, measuring_field, tube
from crenel.station.view3d.scale_bar import round_length_mm
from crenel.station.view3d.scene import WINDOW_MESSAGES, Scene
from tests.bench.station.viewer_client import PROTOCOL
from tests.station.conftest import REST_RAD, six_axis_arm, until
from tests.station.viewer import Viewer, viewer

pytestmark = pytest.mark.device
__all__ = ["viewer"]  # a fixture
BLOCK = Crenellated("block", "B-1", (-22, -14, -7, -2, 5, 10, 17, 22), -12, 12, 15, 0, -12, 0.002)
CAMERA = Camera(
    np.array([[1400.0, 0, 640], [0, 1400, 512], [0, 0, 1]]), np.eye(3), np.zeros(3), 1280, 1024
)
PLANE = LaserPlane(np.array([0, -0.5, np.sqrt(0.75)]), 140 * np.sqrt(0.75))
FLANGE = "/arm/1/2/3/4/5/6"


@pytest.fixture
def scene() -> Iterator[Scene]:
    with closing(Scene(point_budget=20_000)) as scene:
        yield scene


def surface(count: int, seed: int = 1, size_mm: float = 60.0) -> np.ndarray:
    random = np.random.default_rng(seed)
    xy = random.uniform(-size_mm / 2, size_mm / 2, (count, 2))
    return np.column_stack([700 + xy[:, 0], 80 + xy[:, 1], 0.002 * (xy**2).sum(axis=1)])


def records(points: np.ndarray, intensity: float = 100.0, uncertainty_um: float = 5.0) -> Points:
    ones = np.ones(len(points))
    return pack_points(points, intensity * ones, uncertainty_um * ones, 0)


def add(scene: Scene, points: np.ndarray) -> None:
    """Adds points, and waits until others are shown than before."""
    before = scene.points_shown
    scene.add_points(records(points))
    until(lambda: scene.points_shown != before)


def test_points_come_to_the_browser_right_to_a_micrometre(scene: Scene, viewer: Viewer) -> None:
    points = surface(3000)
    add(scene, points)
    until(lambda: viewer.listen(0.1).clouds())
    shown = np.concatenate(list(viewer.listen().clouds().values()))
    assert len(shown) == scene.points_shown
    distance = np.linalg.norm(shown[:, None] - points[None], axis=2).min(axis=1)
    assert distance.max() < 1e-3
    node = next(node for name, node in viewer.nodes.items() if name.startswith("/cloud/"))
    assert node["props"]["precision"] == "float32"


def test_a_growing_cloud_sends_only_what_is_new(scene: Scene, viewer: Viewer) -> None:
    add(scene, surface(2000, 1))
    before = viewer.listen().clouds()
    add(scene, surface(2000, 2))
    after = viewer.listen().clouds()
    assert set(before) < set(after)
    assert sum(map(len, after.values())) == scene.points_shown


def test_above_its_budget_a_cloud_is_thinned_to_a_subset(scene: Scene, viewer: Viewer) -> None:
    for seed in range(4):
        add(scene, surface(15_000, seed))
    # the thinned cloud may be on its way yet
    until(lambda: sum(map(len, viewer.listen().clouds().values())) == scene.points_shown)
    assert 5_000 < scene.points_shown <= 20_000
    clouds = viewer.clouds()
    everything = np.concatenate([surface(15_000, seed) for seed in range(4)])
    some = np.concatenate(list(clouds.values()))[::50]
    nearest = [np.linalg.norm(everything - point, axis=1).min() for point in some]
    assert max(nearest) < 1e-3


def test_small_nodes_are_merged(scene: Scene, viewer: Viewer) -> None:
    add_many = [surface(20, seed) for seed in range(70)]
    with scene._lock:
        for points in add_many:
            scene._clouds.add("", records(points), Circumstances(np.zeros(len(points))))
    assert len(viewer.listen().clouds()) < 40


def test_a_late_viewer_gets_everything_in_small_windows(scene: Scene) -> None:
    add(scene, surface(5000))
    with closing(Viewer(scene)) as viewer:
        shown = sum(map(len, viewer.listen().clouds().values()))
    assert shown == scene.points_shown
    assert scene._server._websock_server._broadcast_buffer.max_window_size == WINDOW_MESSAGES


def test_a_new_scan_removes_the_cloud_and_leaves_the_rest(scene: Scene, viewer: Viewer) -> None:
    scene.set_object(np.eye(4), BLOCK)
    add(scene, surface(1000))
    assert viewer.listen().clouds()
    scene.begin()
    assert scene.points_shown == 0
    viewer.listen()
    assert not viewer.clouds()
    assert "/object/block" in viewer.nodes
    scene.clear_object()
    assert "/object/block" not in viewer.listen().nodes


def drawn_flange(viewer: Viewer) -> np.ndarray:
    """``T_arm_flange`` (4, 4) of the chain of frames that a viewer has."""
    T, path = np.eye(4), "/arm"
    for number in range(1, 7):
        path += f"/{number}"
        w, x, y, z = viewer.wxyz(path)
        vector = np.array([x, y, z])
        angle = 2 * np.arctan2(np.linalg.norm(vector), w)
        axis = vector / max(np.linalg.norm(vector), 1e-12)
        T = T @ rigid(rotation_from_vector(angle * axis), viewer.position_mm(path))
    return T


def test_the_arm_is_drawn_by_its_own_kinematics(scene: Scene, viewer: Viewer) -> None:
    """The chain of the drawn frames ends where Eq. 1 has the flange."""
    arm = six_axis_arm()
    scene.set_arm_model(arm)
    scene.set_arm(REST_RAD.tolist())
    until(lambda: "SetPositionMessage" in viewer.listen(0.1).nodes.get(FLANGE, {}))
    T = drawn_flange(viewer)
    np.testing.assert_allclose(T, flange_pose(arm, REST_RAD), atol=1e-6)
    tip = T @ [*viewer.position_mm(f"{FLANGE}/tip"), 1]
    np.testing.assert_allclose(tip[:3], tip_centres(arm, REST_RAD[None])[0], atol=1e-4)


def await_arm(scene: Scene, T_arm_flange: np.ndarray) -> None:
    """A new viewer comes, stays until the arm is drawn like this, and leaves."""
    with closing(Viewer(scene)) as viewer:
        until(lambda: FLANGE in viewer.listen(0.1).nodes)
        until(lambda: np.allclose(drawn_flange(viewer.listen(0.1)), T_arm_flange))
    until(lambda: not scene._server.get_clients())


def test_a_viewer_sees_how_the_arm_moved_while_nobody_watched(scene: Scene) -> None:
    arm = six_axis_arm()
    scene.set_arm_model(arm)
    for q_rad in (REST_RAD, REST_RAD + 0.3):
        scene.set_arm(q_rad.tolist())
        await_arm(scene, flange_pose(arm, q_rad))


def test_the_sensor_shows_its_field_and_the_laser_colours_it(scene: Scene, viewer: Viewer) -> None:
    scene.set_arm_model(six_axis_arm())
    scene.set_sensor(np.eye(4), CAMERA, PLANE, (120.0, 180.0))
    field = f"{FLANGE}/sensor/field"
    idle = viewer.listen().nodes[field]["props"]["opacity"]
    scene.set_laser(True, in_range=True)
    until(lambda: viewer.listen(0.1).nodes[field]["props"]["opacity"] > idle)
    red, green, blue = viewer.nodes[field]["props"]["color"]
    assert green > max(red, blue)
    scene.set_laser(True, in_range=False)
    until(lambda: viewer.listen(0.1).nodes[field]["props"]["color"][0] > 200)
    scene.set_laser(False)
    until(lambda: viewer.listen(0.1).nodes[field]["props"]["opacity"] == idle)
    scene.clear_sensor()
    assert field not in viewer.listen().nodes
    scene.set_arm_model(None)
    assert "/arm" not in viewer.listen().nodes


def test_a_scale_as_long_as_it_says_lies_beside_the_cloud(scene: Scene, viewer: Viewer) -> None:
    add(scene, surface(2000))
    until(lambda: "/scale/length" in viewer.listen(0.1).nodes)
    length_mm = float(viewer.nodes["/scale/length"]["props"]["text"].split()[0])
    parts = (viewer.nodes[f"/scale/{part}"]["props"]["vertices"] for part in ("dark", "light"))
    ends_mm = 1e3 * np.concatenate([vertices.reshape(-1, 3) for vertices in parts])
    assert np.ptp(ends_mm[:, 0]) == pytest.approx(length_mm, rel=1e-5)
    assert length_mm == 20.0
    scene.begin()
    assert "/scale" not in viewer.listen().nodes


@pytest.mark.parametrize(("most_mm", "length_mm"), [(9.9, 5), (10, 10), (199, 100), (0.3, 0.2)])
def test_scales_have_round_lengths(most_mm: float, length_mm: float) -> None:
    assert round_length_mm(most_mm) == pytest.approx(length_mm)


def test_the_view_follows_the_cloud_until_somebody_turns_it(scene: Scene) -> None:
    untouched, turned = Viewer(scene), Viewer(scene)
    for one in (untouched, turned):
        sent = one.listen().messages
        position = sent["SetCameraPositionMessage"]["position"]
        one.pose_camera(position, sent["SetCameraLookAtMessage"]["look_at"])
    turned.pose_camera((2, 2, 2), (0, 0, 0))
    until(lambda: len(scene._server.get_clients()) == 2)
    for one in (untouched, turned):
        one.listen()
        one.messages.clear()
    add(scene, surface(2000))
    followed = untouched.listen().messages["SetCameraLookAtMessage"]
    np.testing.assert_allclose(followed["look_at"], [0.7, 0.08, 0.015], atol=0.01)
    assert turned.listen().messages["SetCameraLookAtMessage"]["initial"] is True
    # a slow browser tells where its camera was before it was moved
    untouched.pose_camera(position, sent["SetCameraLookAtMessage"]["look_at"])
    near = next(
        client
        for client in scene._server.get_clients().values()
        if not np.allclose(client.camera.position, (2, 2, 2))
    )
    until(lambda: np.allclose(near.camera.position, position))
    untouched.messages.clear()
    add(scene, surface(2000) + [400.0, 0.0, 0.0])
    followed = untouched.listen().messages["SetCameraLookAtMessage"]
    assert followed["look_at"][0] > 0.8
    untouched.close()
    turned.close()


def test_a_port_of_its_own_on_the_loopback_only(scene: Scene) -> None:
    other = Scene()
    assert other.port != scene.port
    assert other._server.get_host() == "127.0.0.1"
    other.close()


def test_a_link_runs_from_the_frame_before_to_its_own() -> None:
    joint = Joint("J", a_mm=30.0, alpha_rad=0.7, d_mm=50.0, theta_rad=0.4)
    arm = six_axis_arm()
    link = link_transforms(type(arm)("one", "", (joint,), arm.tip), np.array([[0.3]]))[0, 0]
    path = link_path(joint) @ link[:3, :3].T + link[:3, 3]
    np.testing.assert_allclose(path[0], 0, atol=1e-12)
    np.testing.assert_allclose(path[1], [0, 0, 50], atol=1e-12)
    np.testing.assert_allclose(path[2], link[:3, 3], atol=1e-12)


def signed_volume(vertices: np.ndarray, faces: np.ndarray) -> float:
    a, b, c = (vertices[faces[:, i].astype(int)] for i in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def test_meshes_are_closed_and_face_outward() -> None:
    made = box(np.array([1.0, 2, 3]), np.array([2.0, 4, 6]))
    assert signed_volume(made.vertices_mm, made.faces) == pytest.approx(6.0)
    made = tube(np.array([1.0, 2, 3]), np.array([1.0, 2, 13]), 2.0, 2.0)
    assert signed_volume(made.vertices_mm, made.faces) == pytest.approx(np.pi * 40, rel=0.02)
    block = block_mesh(BLOCK)
    merlons = (8 + 5 + 5 + 5) * 24 * 15
    assert signed_volume(block.vertices_mm, block.faces) == pytest.approx(44 * 24 * 12 + merlons)
    corner = corners(BLOCK)["crest:3:R:back"]
    assert np.linalg.norm(block.vertices_mm - corner, axis=1).min() == 0


def test_the_field_lies_in_the_laser_plane_inside_the_picture() -> None:
    outline = measuring_field(CAMERA, PLANE, (120.0, 180.0))
    assert len(outline) >= 4
    np.testing.assert_allclose(outline @ PLANE.normal, PLANE.offset_mm)
    uv = project(CAMERA, outline)
    assert ((uv >= -0.01) & (uv <= [1279.01, 1023.01])).all()
    assert len(measuring_field(CAMERA, PLANE, (1.0, 2.0))) == 0


def test_the_views_own_port_answers_the_station_alone(scene: Scene) -> None:
    address = f"127.0.0.1:{scene.port}"
    asked: list[dict[str, str]] = [
        {},
        dict.fromkeys(scene.key, "wrong"),
        {**scene.key, "Origin": f"http://{address}"},
    ]
    for headers in asked:
        assert httpx.get(f"http://{address}/", headers=headers).status_code == 403
        with pytest.raises(InvalidStatus, match="403"):
            connect(f"ws://{address}", additional_headers=headers, subprotocols=[PROTOCOL])
    assert httpx.get(f"http://{address}/", headers=scene.key).status_code == 200


def test_the_view_shares_nothing(scene: Scene) -> None:
    """Asked to by a client that has the key; a tunnel would be a process of its own."""
    heard = scene._server._websock_server._incoming_handlers
    assert not {kind.__name__ for kind in heard if "Share" in kind.__name__}
