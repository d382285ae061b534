"""The 3D view through the server's own origin: everything comes, only the camera goes."""

import dataclasses

import msgspec
import pytest
from viser import _messages as viser_messages
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from app.api.viewer.proxy import decode_camera
from app.bench.station.viewer_client import PROTOCOL
from tests.api.conftest import PATIENCE_S, Server

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
