"""The packets: as published, and out of damaged streams."""

import re
from itertools import pairwise

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from crenel_hardware.arm import protocol
from crenel_hardware.arm.packet_reader import PacketReader
from crenel_hardware.arm.protocol import Hello, Packet, PosePacket, PulseAnswer, Sample
from tests.hardware.speaking_arm import (
    hello_2_packet,
    hello_packet,
    packet,
    pose_payload,
    pulse_packet,
    sample_packet,
    sample_payload,
)

COUNTS = [0, 1, -1, 4194304, -2097152, 123456]


def published_examples() -> list[bytes]:
    assert protocol.__doc__ is not None
    blocks = re.findall(r"::\n\n((?:    [0-9A-F ]+\n)+)", protocol.__doc__)
    return [bytes.fromhex(block.replace("\n", " ")) for block in blocks]


def test_the_published_sample_is_what_it_says() -> None:
    example = published_examples()[0]
    assert example == sample_packet(258, 1_000_000_000, 1, COUNTS)
    assert PacketReader().feed(example) == [Sample(258, 1_000_000_000, 1, tuple(COUNTS))]


def test_the_published_request_and_hello_are_what_they_say() -> None:
    hello = Hello(1000.0, (8388608,) * 6, "Sample arm", "SA-0042", "1.4.0")
    assert PacketReader().feed(published_examples()[1]) == [hello]
    assert published_examples()[2] == protocol.HELLO_REQUEST == packet(0x81, b"")


def test_the_published_hellos_of_version_2_are_what_they_say() -> None:
    joints, poses = published_examples()[3:5]
    arm = (1000.0, (8388608,) * 6, "Sample arm", "SA-0042", "2.0.0", 2)
    assert PacketReader().feed(joints) == [Hello(*arm, buttons=5, pulses_hz=(1.0, 200.0))]
    bridge = (100.0, (), "Sample bridge", "SB-7", "1.0", 2, True, True)
    assert PacketReader().feed(poses) == [Hello(*bridge, buttons=1, setting=17)]


SAMPLE = sample_packet(1, 2, 0, [0] * 6)
POSE = (7, 2_500_000, 1, 17, (612.5, -80.25, 433.0), (0.0, 0.6, 0.0, 0.8))


def test_the_published_poses_and_pulses_are_what_they_say() -> None:
    pose, first_pulse, later_pulse, request, answer = published_examples()[5:]
    assert pose == packet(3, pose_payload(*POSE), 2)
    assert first_pulse == pulse_packet(1, 1, sample_payload(259, 1_000_001_000, 0, COUNTS))
    assert later_pulse == pulse_packet(70_000, 3, pose_payload(*POSE))
    assert PacketReader().feed(pose + first_pulse + later_pulse + answer) == [
        PosePacket(*POSE),
        Sample(259, 1_000_001_000, 0, tuple(COUNTS), pulse=1),
        PosePacket(*POSE, pulse=70_000),
        PulseAnswer(5, True, 100.016),
    ]
    assert request == protocol.pulse_request(5, 100.0)
    assert request == packet(0x82, bytes.fromhex("05 A0 86 01 00"), 2)


def test_a_hello_of_version_2_states_every_property() -> None:
    said = hello_2_packet([], 50.0, 0b1101, 2, 0xFFFFFFFF, (0.5, 80.0), "R", "9")
    assert PacketReader().feed(said) == [
        Hello(50.0, (), "R", "9", "2.0", 2, True, False, True, True, 2, 0xFFFFFFFF, (0.5, 80.0))
    ]


def test_a_pulse_without_a_number_or_with_another_packet_inside_is_damage() -> None:
    reader = PacketReader()
    inside = pose_payload(*POSE)
    for bad in (
        pulse_packet(0, 3, inside),
        pulse_packet(1, 1, inside),
        pulse_packet(1, 5, b""),
        packet(4, b"\1\0", 2),
    ):
        assert reader.feed(packet(3, inside, 2) + bad) == [PosePacket(*POSE)]
    assert reader.feed(packet(3, inside, 2)) == [PosePacket(*POSE)]
    assert reader.corrupt == 4


def test_a_hello_of_seven_joints() -> None:
    found = PacketReader().feed(hello_packet([9] * 7, 250.5, "Ärmel", "7"))
    assert found == [Hello(250.5, (9,) * 7, "Ärmel", "7", "1.0")]


def test_an_unknown_type_is_passed_by_silently() -> None:
    """As is a type of version 2 in version 1."""
    reader = PacketReader()
    assert reader.feed(packet(3, pose_payload(*POSE), 1)) == []
    assert len(reader.feed(SAMPLE + packet(0x33, b"abc") + SAMPLE)) == 2
    assert reader.corrupt == 0


def test_another_version_is_noticed() -> None:
    reader = PacketReader()
    assert reader.feed(packet(1, b"who knows", version=3)) == []
    assert reader.other_version == 3


def test_damage_is_counted_once_a_stretch_and_not_before_the_first_packet() -> None:
    reader = PacketReader()
    bad = SAMPLE[:20] + bytes([SAMPLE[20] ^ 1]) + SAMPLE[21:]
    assert len(reader.feed(b"noise" + bad + SAMPLE)) == 1
    assert reader.corrupt == 0
    assert len(reader.feed(bad + b"noise" + bad + SAMPLE)) == 1
    assert reader.corrupt == 1
    assert len(reader.feed(SAMPLE + bad + SAMPLE)) == 2
    assert reader.corrupt == 2


@pytest.mark.parametrize(
    ("kind", "version"), [(1, 1), (2, 1), (1, 2), (2, 2), (3, 2), (4, 2), (5, 2)]
)
def test_a_good_crc_around_a_wrong_length_is_no_packet(kind: int, version: int) -> None:
    reader = PacketReader()
    for length in (0, 4, 13, 14, 37, 69, 255):
        assert reader.feed(packet(kind, bytes([6] * length), version)) == []
    assert reader.feed(SAMPLE) == [Sample(1, 2, 0, (0,) * 6)]


def test_a_false_start_does_not_delay_the_packet_behind_it() -> None:
    reader = PacketReader()
    false_start = bytes.fromhex("A7 5C 01 01 FF")
    assert len(reader.feed(false_start + SAMPLE)) == 1


Values = tuple[int, int, int, list[int]]
samples = st.tuples(
    st.integers(0, (1 << 32) - 1),
    st.integers(0, (1 << 64) - 1),
    st.integers(0, 7),
    st.integers(6, 7).flatmap(
        lambda n: st.lists(st.integers(-(1 << 31), (1 << 31) - 1), min_size=n, max_size=n)
    ),
)
sync_rich = st.one_of(
    st.binary(max_size=60),
    st.lists(st.sampled_from([0xA7, 0x5C, 0x01, 0x02, 0x26]), max_size=60).map(bytes),
)


def feed_in_pieces(reader: PacketReader, stream: bytes, cuts: list[int]) -> list[Packet]:
    edges = sorted({cut % (len(stream) + 1) for cut in cuts} | {0, len(stream)})
    found: list[Packet] = []
    for start, end in pairwise(edges):
        found += reader.feed(stream[start:end])
    return found


@pytest.mark.slow
@given(st.lists(st.tuples(sync_rich, samples), max_size=12), st.lists(st.integers(0, 9999)))
def test_packets_are_found_in_noise(parts: list[tuple[bytes, Values]], cuts: list[int]) -> None:
    stream = b"".join(noise + sample_packet(*sample) for noise, sample in parts)
    expected = [Sample(s, t, b, tuple(c)) for _, (s, t, b, c) in parts]
    assert feed_in_pieces(PacketReader(), stream, cuts) == expected


@given(samples, samples, st.data())
def test_a_cut_packet_costs_itself(first: Values, second: Values, data: st.DataObject) -> None:
    whole = sample_packet(*first)
    kept = data.draw(st.integers(0, len(whole) - 1))
    from_its_end = data.draw(st.booleans())
    cut = whole[len(whole) - kept :] if from_its_end else whole[:kept]
    s, t, b, c = second
    # a checksum that ends as a packet begins makes it whole again
    assume(not kept or not (cut + sample_packet(*second)).startswith(whole))
    stream = whole + cut + sample_packet(*second)
    reader = PacketReader()
    assert feed_in_pieces(reader, stream, [len(whole) + 3])[1:] == [Sample(s, t, b, tuple(c))]
    assert reader.corrupt == (1 if kept else 0)


@given(st.binary(max_size=2000), st.lists(st.integers(0, 9999)))
def test_noise_alone_never_fails_nor_piles_up(noise: bytes, cuts: list[int]) -> None:
    reader = PacketReader()
    assert feed_in_pieces(reader, noise, cuts) == []
    assert reader.received_bytes == len(noise)


@given(samples, st.integers(0, 50), st.integers(1, 255))
def test_any_changed_byte_is_noticed(sample: Values, at: int, change: int) -> None:
    whole = bytearray(sample_packet(*sample))
    whole[at % len(whole)] ^= change
    assert PacketReader().feed(bytes(whole)) == []
