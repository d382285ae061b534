"""Datagrams that anybody on the network can send to a port where a robot is expected."""

from collections.abc import Callable
from contextlib import closing

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from crenel_hardware.arm.robots.abb_egm import AbbEgmOptions, EgmStream
from crenel_hardware.arm.robots.egm_message import decode_robot
from crenel_hardware.arm.robots.kuka_rsi import KukaRsiOptions, RsiStream
from crenel_hardware.arm.robots.listening import ListeningStream
from crenel_hardware.arm.robots.readings import StreamJudge
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmInfo, LinkHealth

pytestmark = [pytest.mark.device, pytest.mark.soak]

POSES = ArmInfo("Robot", "", 0, 250.0, reports="pose")
DOCUMENT = (
    '<Rob><RIst X="500.0" Y="-20.0" Z="350.0" A="10.0" B="20.0" C="30.0"/><IPOC>{}</IPOC></Rob>'
)


def rsi() -> ListeningStream:
    return RsiStream(KukaRsiOptions(address="127.0.0.1", port=49152))


def egm_packet() -> bytes:
    robot = decode_robot(b"\x0a\x00\x12\x00")
    assert robot is not None
    robot.header.seqno, robot.header.tm = 7, 4000
    pose = robot.feedBack.cartesian
    pose.pos.x, pose.pos.y, pose.pos.z = 500.0, -20.0, 350.0
    pose.orient.u0, pose.orient.u1, pose.orient.u2, pose.orient.u3 = 1.0, 0.0, 0.0, 0.0
    robot.feedBack.time.sec, robot.feedBack.time.usec = 1_760_000_000, 4000
    return bytes(robot.SerializeToString())


def egm() -> ListeningStream:
    return EgmStream(AbbEgmOptions(address="127.0.0.1", port=6510))


def take(make: Callable[[], ListeningStream], *packets: bytes) -> int:
    """How many of the packets were taken, by a station that is not disturbed by the others."""
    judge = StreamJudge("127.0.0.1", 0.0, POSES, LinkHealth())
    taken = 0
    with closing(make()) as stream:
        for count, data in enumerate(packets):
            try:
                reading = stream.decode(data)
                taken += len(judge.accept([reading], 4_000_000 * count)) if reading else 0
            except DeviceError:
                continue
    return taken


@pytest.mark.parametrize("stamp", ["9" * 5000, "9" * 100, "", " ", "-1", "1e3", "²"])
def test_a_stamp_that_no_controller_sends_is_not_read(stamp: str) -> None:
    with closing(rsi()) as stream:
        assert stream.decode(DOCUMENT.format(4_208_163_634).encode()) is not None
        assert stream.decode(DOCUMENT.format(stamp).encode()) is None


@pytest.mark.parametrize("encoding", ["utf-16", "utf-32", "gb2312", "no-such"])
def test_a_document_in_another_encoding_is_not_read(encoding: str) -> None:
    entity = '<!DOCTYPE Rob [<!ENTITY stamp "4208163634">]>' + DOCUMENT.format("&stamp;")
    head = f'<?xml version="1.0" encoding="{encoding}"?>'
    written = "utf-8" if encoding in ("gb2312", "no-such") else encoding
    with closing(rsi()) as stream:
        assert stream.decode((head + entity).encode(written)) is None


def mutated(packet: bytes) -> st.SearchStrategy[bytes]:
    """The packet with some bytes changed, cut or repeated."""

    def change(edits: list[tuple[int, bytes]]) -> bytes:
        data = packet
        for at, piece in edits:
            at %= len(packet) + 1
            data = data[:at] + piece + data[at + len(piece) % 3 :]
        return data

    edit = st.tuples(st.integers(0, 1000), st.binary(max_size=9))
    return st.lists(edit, max_size=6).map(change)


@pytest.mark.parametrize(
    ("make", "data"), [(rsi, DOCUMENT.format(4_208_163_634).encode()), (egm, egm_packet())]
)
def test_any_datagram_is_read_or_refused(make: Callable[[], ListeningStream], data: bytes) -> None:
    @given(st.lists(mutated(data) | st.binary(max_size=200), max_size=6))
    @example([data, data])
    def check(packets: list[bytes]) -> None:
        take(make, *packets)

    assert take(make, data) == 1
    check()
