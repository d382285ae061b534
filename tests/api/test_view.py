"""The 3D view through the server: its sockets, its commands, and fewer points for slow browsers."""

import contextlib
import dataclasses
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from unittest.mock import patch

import msgspec
import numpy as np
import pytest
from viser import _messages as viser_messages
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.sync.connection import Connection
from websockets.typing import Subprotocol

from crenel.api.viewer.frames import unpack_frame
from crenel.api.viewer.labels import LabelWriter
from crenel.api.viewer.point_limit import PointLimiter
from crenel.api.viewer.proxy import KEY, decode_camera
from crenel.formats.clouds.cuts import Cut, read_cuts, write_cuts
from crenel.formats.clouds.files import cloud_writer, read_cloud
from crenel.formats.clouds.points import pack_points
from crenel.operations.library import scan_records
from crenel.station.view3d.cloud_node import NODE_POINTS
from crenel.station.view3d.meshes import box
from crenel.station.view3d.scene import Scene
from crenel.store.scans import ScanRecord
from crenel.workflows.clouds.cloud_picture import cloud_picture
from tests.api.conftest import PATIENCE_S, Server, run_command, wait_for
from tests.bench.station.viewer_client import PROTOCOL
from tests.present import present
from tests.sent_texts import english
from tests.station.conftest import until
from tests.station.test_scene import records, surface
from tests.station.viewer import Viewer

pytestmark = pytest.mark.device

CAMERA = viser_messages.ViewerCameraMessage(
    wxyz=(1.0, 0.0, 0.0, 0.0),
    position=(1.0, 2.0, 3.0),
    fov=0.8,
    near=0.1,
    far=100.0,
    image_height=600,
    image_width=800,
    look_at=(0.0, 0.0, 0.0),
    up_direction=(0.0, 0.0, 1.0),
)
VIEW_KEY = "0123456789abcdef" * 2
# From above the middle of the plate: x to the right, y down, z ahead.
LOOK = dataclasses.replace(
    dataclasses.replace(CAMERA, near=0.01, far=50.0, image_width=900),
    wxyz=(0.0, 1.0, 0.0, 0.0),
    position=(0.5, 0.0, 0.3),
    look_at=(0.5, 0.0, 0.0),
)
MOST = 20_000


def viewer_socket(server: Server, path: str, protocol: Subprotocol = PROTOCOL) -> ClientConnection:
    return connect(
        f"ws://127.0.0.1:{server.port}{path}",
        additional_headers=server.cookie,
        subprotocols=[protocol],
        max_size=None,
        close_timeout=0.5,
    )


def as_sent(message: viser_messages.Message) -> bytes:
    assert dataclasses.is_dataclass(message)
    return msgspec.msgpack.encode({"type": type(message).__name__, **dataclasses.asdict(message)})


def test_a_camera_message_is_passed_on_whole() -> None:
    through = decode_camera(as_sent(CAMERA))
    assert through is not None
    assert viser_messages.Message.deserialize(msgspec.msgpack.encode(through)) == CAMERA


def test_no_other_message_is_passed_on() -> None:
    kinds = viser_messages.Message.get_subclasses()
    assert len(kinds) > 50
    for kind in kinds:
        if kind is not viser_messages.ViewerCameraMessage:
            assert dataclasses.is_dataclass(kind)
            fields = {field.name: None for field in dataclasses.fields(kind)}
            assert decode_camera(msgspec.msgpack.encode({"type": kind.__name__, **fields})) is None
    assert decode_camera(as_sent(viser_messages.ShareUrlRequest())) is None


@pytest.mark.parametrize(
    "sent",
    [
        *(b"", b"\xc1", b"\x93\x01\x02\x03", as_sent(CAMERA)[:-3]),
        msgspec.msgpack.encode({"type": "ViewerCameraMessage"}),
        *(
            msgspec.msgpack.encode({**msgspec.msgpack.decode(as_sent(CAMERA)), **change})
            for change in ({"more": 1}, {"fov": "wide"})
        ),
    ],
)
def test_a_message_that_only_looks_like_a_camera_is_dropped(sent: bytes) -> None:
    assert decode_camera(sent) is None


def test_the_viewers_page_comes_through_with_a_policy_of_its_own(server: Server) -> None:
    page = server.http.get("/viewer/", headers={"accept-encoding": "gzip"})
    assert page.status_code == 200
    assert "<title>Viser</title>" in page.text
    policy = page.headers["content-security-policy"]
    assert "frame-ancestors 'self'" in policy
    own = f"127.0.0.1:{server.port}/viewer/"
    assert f"connect-src http://{own} https://{own} ws://{own} wss://{own} data: blob:;" in policy
    for path in ("/viewers", "/viewer-x", "/viewer.html"):
        assert "unsafe-eval" not in server.http.get(path).headers["content-security-policy"]
    assert server.http.get("/viewer").status_code == 307
    assert server.http.get("/viewer/nothing.js").status_code == 404


def test_the_scene_comes_through_and_cameras_do_not_end_it(server: Server) -> None:
    with viewer_socket(server, "/viewer") as socket:
        assert socket.subprotocol == PROTOCOL
        assert isinstance(socket.recv(PATIENCE_S), bytes)
        socket.send(as_sent(viser_messages.ShareUrlRequest()))
        socket.send(b"\x00 nonsense")
        socket.send(as_sent(CAMERA))
        server.context.scene.set_laser(True)
        assert isinstance(socket.recv(PATIENCE_S), bytes)


def test_a_page_of_another_version_is_turned_away_as_viser_does(server: Server) -> None:
    other = Subprotocol("viser-v0.0.1")
    with viewer_socket(server, "/viewer/", other) as socket, pytest.raises(ConnectionClosed):
        socket.recv(PATIENCE_S)


@pytest.fixture
def scan(server: Server) -> Iterator[ScanRecord]:
    """A finished scan of a plate, 5 mm over the arm's zero."""
    folder = server.data / "scans" / "plate"
    folder.mkdir()
    xy = np.random.default_rng(1).uniform(-40, 40, (30_000, 2))
    off = np.random.default_rng(2).normal(0, 0.01, 30_000)
    points = np.column_stack([500 + xy[:, 0], xy[:, 1], 5 + off])
    ones = np.ones(30_000)
    with cloud_writer(folder / "cloud.ply") as writer:
        writer.append(pack_points(points, 80 * ones, 4 * ones, np.arange(30_000) // 300))
    record = ScanRecord("plate", "Plate", folder, "2026-11-21T10:00:00", 30_000, 100, 9.0, "c1")
    server.context.store.scans.add(record)
    server.context.scene.begin()  # what other tests have scanned is not in the picture
    yield record
    with contextlib.suppress(KeyError):
        server.http.delete("/api/scans/plate")


def view(server: Server) -> dict[str, Any]:
    return dict(server.http.get("/api/view").json())


def wait(server: Server, ready: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    return wait_for(lambda: view(server), ready)


def show(server: Server) -> None:
    assert server.http.post("/api/scans/plate/shown", json={"on": True}).status_code == 200
    wait(server, lambda view: [scan["loaded"] for scan in view["scans"]] == [1.0])


def test_a_shown_scan_is_coloured_hidden_and_shown(server: Server, scan: ScanRecord) -> None:
    show(server)
    asked = {"measure": "intensity", "low": 0, "high": 160}
    legend = server.http.post("/api/view/colours", json=asked).json()["legend"]
    assert (legend["measure"], legend["automatic"]) == ("intensity", False)
    assert legend["unit"] == {"message_id": "grey-levels", "values": {}}
    assert len(legend["colours"]) == 17
    for wrong in ({"measure": "taste"}, {"measure": "age", "low": "a"}, {"low": 1, "high": 2}):
        assert server.http.post("/api/view/colours", json=wrong).status_code == 422
    refused = server.http.post("/api/view/colours", json={"measure": "deviation"})
    assert "no fitted shape" in refused.text
    server.http.post("/api/view/colours", json={"measure": "height"})
    assert not server.http.post("/api/scans/plate/shown", json={"on": False}).json()["scans"]
    assert server.http.post("/api/scans/none/shown", json={"on": True}).status_code == 404


def test_a_rectangle_is_fitted_as_its_page_looks_at_it(server: Server, scan: ScanRecord) -> None:
    show(server)
    region = {
        "view": VIEW_KEY,
        "shape": "plane",
        "left": 0.4,
        "top": 0.4,
        "right": 0.6,
        "bottom": 0.6,
    }
    assert "not connected" in server.http.post("/api/view/fits", json=region).text
    with viewer_socket(server, f"/viewer/{VIEW_KEY}") as socket:
        socket.send(as_sent(LOOK))
        run_command(lambda: server.http.post("/api/view/fits", json=region))
    (fitted,) = wait(server, lambda view: bool(view["fits"]))["fits"]
    figures = {english(figure["label"]): figure for figure in fitted["figures"]}
    offset = figures["Distance from the arm's origin"]
    assert fitted["every"]
    assert offset["value"] == pytest.approx(5.0, abs=4 * offset["scatter"])
    assert 0 < offset["scatter"] < 0.005
    assert fitted["rms_um"] == pytest.approx(10, rel=0.1)
    assert "not connected" in server.http.post("/api/view/fits", json=region).text
    assert not server.http.delete(f"/api/view/fits/{fitted['id']}").json()["fits"]
    assert server.http.post("/api/view/fits", json={**region, "left": 1.5}).status_code == 422


def test_saved_clouds_leave_out_what_is_cut_away(
    server: Server, scan: ScanRecord, tmp_path: Path
) -> None:
    def saved(form: str) -> int:
        answer = server.http.get(f"/api/scans/plate/cloud.{form}")
        assert answer.status_code == 200, answer.text
        file = tmp_path / f"saved.{form}"
        file.write_bytes(answer.content)
        return len(read_cloud(file).points_mm)

    show(server)
    region = {"view": VIEW_KEY, "left": 0.4, "top": 0.4, "right": 0.6, "bottom": 0.6}
    with viewer_socket(server, f"/viewer/{VIEW_KEY}") as socket:
        socket.send(as_sent(LOOK))
        asked = {**region, "outside": False}
        state = run_command(lambda: server.http.post("/api/view/cuts", json=asked))
    assert state["content"]["points_cut"] > 0
    formats = server.http.get("/api/cloud-formats").json()
    forms = [one["form"] for one in formats if not one["why_not"]]
    assert {"ply", "pcd", "xyz"} <= set(forms)
    (left,) = {saved(form) for form in forms}
    assert 10_000 < left < 15_000
    assert server.http.get("/api/scans/plate/cloud.stl").status_code == 422
    assert server.http.delete("/api/view/cuts/last").json()["content"]["points_cut"] == 0
    assert saved("ply") == 30_000


def test_arm_and_weak_places_are_hidden_and_shown(server: Server) -> None:
    for path, field in (("/api/view/arm", "arm_shown"), ("/api/view/weak", "weak_shown")):
        for on in (False, True):
            content = server.http.post(path, json={"on": on}).json()["content"]
            assert content[field] is on


def test_a_page_is_turned_to_see_the_whole_cloud_and_others_keep_their_view(
    server: Server, scan: ScanRecord
) -> None:
    def turn(viewpoint: str) -> int:
        asked = {"view": VIEW_KEY, "viewpoint": viewpoint}
        return server.http.post("/api/view/viewpoint", json=asked).status_code

    def read_turn(socket: Connection) -> tuple[np.ndarray, np.ndarray]:
        """Position and the point looked at, in metres, as this page receives it."""
        moves: dict[str, Any] = {}
        while len(moves) < 2:
            content, _ = unpack_frame(socket.recv(decode=False))
            moves |= {
                each["type"]: each
                for each in content["messages"]
                if each["type"].startswith("SetCamera") and not each.get("initial", True)
            }
        position, centre = moves["SetCameraPositionMessage"], moves["SetCameraLookAtMessage"]
        return np.array(position["position"]), np.array(centre["look_at"])

    show(server)
    assert turn("above") == 422
    with viewer_socket(server, f"/viewer/{VIEW_KEY}") as socket:
        socket.send(as_sent(LOOK))
        wait_for(lambda: turn("above"), lambda status: status == 204)
        distance_m = []
        for direction, following in (
            ([0, 0, 1], "front"),
            ([0, -1, 0], "side"),
            ([1, 0, 0], "whole"),
            ([0, 0, 1], "above"),  # the page has not moved its camera: it looks down
        ):
            position, centre = read_turn(socket)
            assert turn(following) == 204
            distance_m.append(float(np.linalg.norm(position - centre)))
            np.testing.assert_allclose((position - centre) / distance_m[-1], direction, atol=2e-3)
        assert max(distance_m) == pytest.approx(min(distance_m))
    assert turn("below") == 422


def test_a_scan_is_renamed_and_deleted_with_its_files(server: Server, scan: ScanRecord) -> None:
    def names() -> list[str]:
        return [found["name"] for found in server.http.get("/api/scans").json()]

    show(server)
    foreign = server.http.delete("/api/scans/plate", headers={"origin": "http://elsewhere"})
    assert (foreign.status_code, scan.folder.exists()) == (403, True)
    scan.folder.with_name(".deleted-before").mkdir()  # as a killed server leaves it
    before = view(server)["records"]
    assert server.http.post("/api/scans/plate/name", json={"name": " Cover  2 "}).status_code == 204
    assert "Cover 2" in names()
    assert server.http.post("/api/scans/plate/name", json={"name": "  "}).status_code >= 400
    assert server.http.delete("/api/scans/plate").status_code == 204
    assert "Cover 2" not in names()
    assert view(server)["records"] == before + 2
    assert not view(server)["scans"]
    assert not scan.folder.exists()
    assert not list((server.data / "pictures").glob("plate*"))
    assert not list(Path(scan.folder.parent).glob(".deleted-*"))
    assert server.http.delete("/api/scans/plate").status_code == 404


def test_an_opened_record_is_played_compared_and_left(server: Server, scan: ScanRecord) -> None:
    def opened() -> dict[str, Any] | None:
        found: dict[str, Any] | None = server.http.get("/api/library").json()["opened"]
        return found

    def ask(path: str, **body: Any) -> int:
        return server.http.post(f"/api/{path}", json=body).status_code

    assert ask("view/replay", playing=True) == 422
    assert ask("scans/plate/opened", on=True) == 204
    wait(server, lambda view: [one["loaded"] for one in view["scans"]] == [1.0])
    assert present(opened())["id"] == "plate"
    assert ask("view/replay", at_s=3.0, playing=False) == 204
    (half,) = view(server)["scans"]
    assert ask("view/replay", at_s=9.0, playing=False) == 204
    (whole,) = wait(server, lambda view: view["scans"][0]["points_shown"] > half["points_shown"])[
        "scans"
    ]
    assert half["points_shown"] < 0.5 * whole["points_shown"]
    assert ask("view/replay", at_s=1.0, playing=True, speed=1000.0) == 204
    wait_for(opened, lambda one: one is not None and one["replay"]["at_s"] == 9.0)
    assert not present(opened())["replay"]["playing"]

    assert ask("scans/plate/comparison", reference="plate") == 204
    compared = present(wait_for(opened, lambda one: bool(one and one["comparison"])))
    assert abs(compared["comparison"]["deviation"]["mean_um"]) < 2.0
    assert compared["comparison"]["same_calibration"]
    assert view(server)["legend"]["measure"] == "deviation"
    assert server.http.delete("/api/view/comparison").status_code == 204
    assert view(server)["legend"]["measure"] == "height"
    assert ask("scans/plate/opened", on=False) == 204
    assert opened() is None
    assert not view(server)["scans"]


def test_a_record_is_opened_and_played_without_what_was_cut_away(
    server: Server, scan: ScanRecord
) -> None:
    """Whenever the cut is undone, also in the middle of a replay."""
    cut = Cut(((1.0, 0.0, 0.0, -500.0),), False, 1)
    scene = server.context.scene

    def play(at_s: float) -> None:
        body = {"at_s": at_s, "playing": False}
        assert server.http.post("/api/view/replay", json=body).status_code == 204

    def largest_x_mm() -> float:
        return float(scene.visible_points("plate")[0][:, 0].max())

    (scan.folder / "cuts.json").write_text("{}")
    refused = server.http.post("/api/scans/plate/opened", json={"on": True})
    assert refused.status_code == 422
    assert "cuts.json" in refused.text
    assert not view(server)["scans"]
    write_cuts(scan.folder, [cut])
    assert server.http.post("/api/scans/plate/opened", json={"on": True}).status_code == 204
    play(3.0)  # while it is being read
    assert view(server)["scans"][0]["loaded"] == 1.0
    third = scene.scans["plate"]
    assert largest_x_mm() < 500 < largest_x_mm() + 5
    play(9.0)
    wait(server, lambda view: view["scans"][0]["points_shown"] > 1.5 * third)
    play(2.0)
    assert scene.scans["plate"] < third
    assert largest_x_mm() < 500
    assert server.http.delete("/api/view/cuts/last").json()["cuts"] == 0
    assert largest_x_mm() > 530
    assert read_cuts(scan.folder) == ()
    play(3.0)
    assert scene.scans["plate"] > 1.5 * third
    assert server.http.post("/api/scans/plate/opened", json={"on": False}).status_code == 204


def test_a_cut_scan_has_another_picture_until_the_cut_is_undone(
    server: Server, scan: ScanRecord
) -> None:
    """Also if it is cut while the picture is drawn."""

    def seen() -> tuple[str, bytes]:
        found = server.http.get("/api/scans").json()
        changed = next(one["changed_ns"] for one in found if one["id"] == "plate")
        return changed, server.http.get("/api/scans/plate/picture.png").content

    cut = Cut(((1.0, 0.0, 0.0, -500.0),), False, 1)
    whole = seen()
    write_cuts(scan.folder, [cut])
    part = seen()
    assert part[0] != whole[0]
    assert part[1] != whole[1]
    write_cuts(scan.folder, [])
    assert seen()[1] == whole[1]

    def cut_meanwhile(cloud: Path, size_px: int) -> bytes:
        drawn = cloud_picture(cloud, size_px)
        write_cuts(scan.folder, [cut])
        return drawn

    write_cuts(scan.folder, [])
    with patch.object(scan_records, "cloud_picture", cut_meanwhile):
        assert seen()[1] == whole[1]
    assert seen()[1] == part[1]


def test_parts_are_named_and_files_are_in_every_format(server: Server, scan: ScanRecord) -> None:
    def listed() -> dict[str, Any]:
        found: list[dict[str, Any]] = server.http.get("/api/scans").json()
        return next(one for one in found if one["id"] == "plate")

    part = {"part": " Housing  left ", "serial_number": "7", "order": "A-1", "customer": "井上"}
    kept = {**part, "part": "Housing left"}
    assert server.http.post("/api/scans/plate/part", json=part).status_code == 204
    assert listed()["part"] == kept
    assert json.loads((scan.folder / "scan.json").read_text("utf-8"))["part"] == kept
    assert server.http.post("/api/part", json=part).json() == kept
    assert server.http.get("/api/part").json() == kept
    assert server.http.post("/api/part", json={}).json() == dict.fromkeys(kept, "")
    report = server.http.get("/api/scans/plate/report.html?lang=de")
    assert all(word in report.text for word in ("Scanbericht", "Housing left", "A-1", "井上"))
    small, large = (
        server.http.get(f"/api/scans/plate/picture.png{query}") for query in ("", "?large=true")
    )
    assert small.content[1:4] == large.content[1:4] == b"PNG"
    assert len(large.content) > 3 * len(small.content)
    for form in server.http.get("/api/cloud-formats").json():
        answer = server.http.get(f"/api/scans/plate/cloud.{form['form']}")
        assert answer.status_code == (422 if form["why_not"] else 200)
        assert form["form"] in answer.headers.get("content-disposition", form["form"])
    assert server.http.get("/api/scans/plate/cloud.exe").status_code == 422


def test_scans_that_do_not_belong_together_are_neither_merged_nor_continued(
    server: Server, scan: ScanRecord
) -> None:
    merged = server.http.post("/api/merged-scans", json={"ids": ["plate", "plate"]})
    assert "from 2 to 50 scans" in merged.text
    continued = server.http.post("/api/scans/plate/continued", json={"on": True})
    assert (continued.status_code, "cannot be continued" in continued.text) == (422, True)
    assert server.http.get("/api/library").json()["continued"] is None


def test_labels_and_scale_bar_are_in_the_unit_and_language_of_their_page() -> None:
    with contextlib.closing(Scene()) as scene:
        scene.add_points(records(surface(5_000)))
        until(lambda: scene._scale_bar._root is not None)
        scene.show_shape(3, box(np.zeros(3), np.ones(3)), "Plane 3")
        seen = {}
        for inch, language in ((False, "en"), (True, "de")):
            with contextlib.closing(Viewer(scene, LabelWriter(inch, language).filter_frame)) as one:
                nodes = one.listen().nodes
            names = ("/scale/length", "/table/cell", "/fits/3/label")
            bar = 1e3 * nodes["/scale/dark"]["props"]["vertices"].reshape(-1, 3)
            seen[language] = [*(nodes[name]["props"]["text"] for name in names), bar[:, 0].max()]
    assert seen["en"] == ["20 mm", "□ 100 mm", "Plane 3", pytest.approx(20.0, abs=1e-3)]
    assert seen["de"] == ["0,5 in", "□ 3,94 in", "Ebene 3", pytest.approx(12.7, abs=1e-3)]


def large(viewer: Viewer) -> dict[str, np.ndarray]:
    """The nodes of one tier each."""
    return {name: points for name, points in viewer.clouds().items() if "-" in name}


def test_a_slow_browser_gets_an_even_picture_of_fewer_points_and_nothing_goes_wrong() -> None:
    scene = Scene(point_budget=400_000)
    fewer, all_of_it = Viewer(scene, PointLimiter(MOST).filter_frame), Viewer(scene)
    try:
        for seed in range(6):
            scene.add_points(records(surface(60_000, seed)))
            until(lambda: scene.waiting == 0)
        until(lambda: sum(map(len, all_of_it.listen(0.2).clouds().values())) == scene.points_shown)
        fewer.listen()
        assert scene.points_shown > 2 * NODE_POINTS
        assert MOST / 4 < sum(map(len, large(fewer).values())) <= MOST
        assert set(fewer.clouds()) < set(all_of_it.clouds())
        shown = np.concatenate(list(large(fewer).values()))
        cells = np.unique(np.floor(shown[:, :2] / 4).astype(int), axis=0)
        assert len(cells) >= 0.95 * 15 * 15
        (name, *_) = large(fewer)
        size, usual = (viewer.nodes[name]["props"]["point_size"] for viewer in (fewer, all_of_it))
        assert size > 2 * usual

        scene.colour_by("intensity", None)
        joined = Viewer(scene, PointLimiter(MOST).filter_frame)
        assert set(large(joined.listen())) <= set(large(fewer.listen()))
        joined.close()

        scene.begin()
        until(lambda: not fewer.listen(0.2).clouds())
        scene.add_points(records(surface(5_000)))
        until(lambda: sum(map(len, fewer.listen(0.2).clouds().values())) == scene.points_shown)
    finally:
        fewer.close()
        all_of_it.close()
        scene.close()


@pytest.mark.parametrize(
    ("key", "most"), [("ab" * 16, None), ("ab" * 16 + "-75", "75"), ("ab" * 16 + "-9999", "9999")]
)
def test_a_page_says_in_its_address_what_it_can_draw(key: str, most: str | None) -> None:
    known = KEY.fullmatch(key)
    assert known
    assert known[2] == most


@pytest.mark.parametrize("key", ["ab" * 16 + "-0", "ab" * 16 + "-", "ab" * 16 + "-x", "-75", "ab"])
def test_what_is_no_key_is_none(key: str) -> None:
    assert KEY.fullmatch(key) is None
