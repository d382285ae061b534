"""The live connection: hello, snapshot, what changes, beats; the preview at its reader's pace."""

import json
import logging
import struct
import time
from typing import Any

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import ClientConnection, connect
from websockets.sync.connection import Connection
from websockets.typing import Origin

from tests.api.conftest import PATIENCE_S, Server
from tests.present import present
from tests.sent_texts import english

pytestmark = pytest.mark.device

NO_TEXT = b"\xff\xfe"
"""Sent as a text, it is not UTF-8."""


def live(server: Server, **options: Any) -> ClientConnection:
    # the client closes late while more unread messages wait than its queue holds
    options = {"max_queue": 64, **options}
    return connect(server.live, additional_headers=server.cookie, **options)


def message(socket: Connection) -> dict[str, Any]:
    """The next text message; pictures are passed over."""
    while not isinstance(received := socket.recv(PATIENCE_S), str):
        continue
    return dict(json.loads(received))


def picture(socket: Connection, timeout_s: float) -> dict[str, Any] | None:
    """The header of the next picture, None when none comes in time."""
    deadline = time.monotonic() + timeout_s
    while (left_s := deadline - time.monotonic()) > 0:
        try:
            received = socket.recv(left_s)
        except TimeoutError:
            return None
        if isinstance(received, bytes):
            (length,) = struct.unpack(">I", received[:4])
            assert received[4 + length :].startswith(b"\xff\xd8\xff")
            return dict(json.loads(received[4 : 4 + length]))
    return None


def test_hello_comes_first_then_the_whole_state_then_beats(server: Server) -> None:
    with live(server) as socket:
        assert message(socket)["type"] == "hello"
        seen: set[object] = set()
        while (received := message(socket))["type"] != "beat":
            assert received["type"] in ("topic", "event")
            seen.add(received.get("name"))
        assert {"devices", "flow", "scan", "home", "arm", "verify", "performance"} <= seen
        while message(socket)["type"] != "beat":
            pass


def test_what_one_tab_does_the_other_sees(touching: Server) -> None:
    with live(touching) as socket:
        assert message(socket)["type"] == "hello"
        rev = touching.do("select_face", face="front")["rev"]
        while (sent := message(socket)).get("name") != "flow" or sent["value"]["rev"] != rev:
            pass
        assert english(sent["value"]["instruction"]).startswith("Touch the front face")


def test_an_event_is_numbered_and_sent_once(server: Server) -> None:
    with live(server) as one, live(server) as other:
        for socket in (one, other):
            while message(socket).get("type") != "topic":
                pass
        event = server.context.bus.event("test", "Something happened.", "good")
        for socket in (one, other):
            while (received := message(socket))["type"] != "event":
                pass
            assert received.pop("id") == event.id
            expected = {"type": "event", "kind": "test", "quality": "good"}
            assert received == {**expected, "text": "Something happened."}


def test_the_next_picture_waits_for_the_last_to_be_acknowledged(server: Server) -> None:
    with live(server) as socket:
        assert picture(socket, 0.5) is None
        socket.send(json.dumps({"type": "preview", "on": True}))
        first = present(picture(socket, PATIENCE_S))
        assert first["width_px"] == server.simulation.config.width_px
        assert picture(socket, 1.0) is None
        socket.send(json.dumps({"type": "preview_ack", "seq": first["seq"]}))
        second = present(picture(socket, PATIENCE_S))
        assert second["seq"] > first["seq"]
        socket.send(json.dumps({"type": "preview", "on": False}))
        socket.send(json.dumps({"type": "preview_ack", "seq": second["seq"]}))
        assert picture(socket, 1.0) is None


def send_and_drain(socket: Connection, sent: str | bytes) -> None:
    socket.send(sent, text=True if sent == NO_TEXT else None)
    for _ in range(1000):
        socket.recv(PATIENCE_S)


@pytest.mark.parametrize(
    "sent",
    [
        *("not json", "[]", b"\x00\x01", "x" * 200_000, '{"type": "reboot"}'),
        *('{"type": "preview"}', '{"type": "preview", "on": "yes"}'),
        '{"type": "preview", "on": true, "more": 1}',
        '{"type": "preview", "on": true, "pad": "' + "x" * 5000 + '"}',
        *("[" * 1000, '{"type": "preview", "on": NaN}', NO_TEXT),
    ],
    ids=lambda value: repr(value[:30]),
)
def test_a_malformed_message_ends_this_connection_alone(
    server: Server, sent: str | bytes, caplog: pytest.LogCaptureFixture
) -> None:
    with live(server) as bystander, live(server) as socket:
        with pytest.raises(ConnectionClosed) as closed:
            send_and_drain(socket, sent)
        # the reason is lost where the server hangs up on a message that is still coming
        if len(sent) < 100_000:
            assert closed.value.rcvd is not None
        if closed.value.rcvd is not None:
            assert closed.value.rcvd.code in (1007, 1008, 1009)
        assert message(bystander)["type"] == "hello"
    assert not [one for one in caplog.records if one.levelno >= logging.ERROR]


def test_a_tab_that_does_not_read_delays_nobody(server: Server) -> None:
    bus = server.context.bus
    with live(server, max_queue=1, close_timeout=0.1), live(server, max_size=None) as reader:
        for count in range(60):
            # far more than the buffers of a connection that nobody reads can hold
            bus.publish("bulk", f"{count} " + "x" * 1_000_000)
            while not str(message(reader).get("value", "")).startswith(f"{count} "):
                pass
        bus.publish("bulk", None)


def test_a_foreign_page_gets_no_live_connection(server: Server) -> None:
    foreign = Origin("http://evil.example")
    with pytest.raises(InvalidStatus) as refused:
        live(server, origin=foreign)
    assert refused.value.response.status_code == 403
    with live(server, origin=Origin(f"http://127.0.0.1:{server.port}")) as socket:
        assert message(socket)["type"] == "hello"
