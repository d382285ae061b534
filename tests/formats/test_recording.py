"""Recordings: what is written reads back, up to any cut; the joints between their samples."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import cv2
import numpy as np
import pytest
from foxglove import Channel, Context, open_mcap
from foxglove.channels import CompressedImageChannel, JointStatesChannel, RawImageChannel
from foxglove.mcap import MCAPCompression, MCAPWriteOptions
from foxglove.messages import CompressedImage, JointState, JointStates, RawImage, Timestamp
from hypothesis import given
from hypothesis import strategies as st
from mcap.reader import make_reader
from mcap.summary import Summary

from crenel.errors import OperationError
from crenel.formats.images import GreyImage
from crenel.formats.recording.decoders import ImageRecord, JointRecord, Record, StripeRecord
from crenel.formats.recording.reader import Recording, open_recording
from crenel.formats.recording.reading_track import ReadingTrack
from crenel.formats.recording.stripe_message import encode_stripe, stripe_descriptors
from crenel.formats.recording.writer import RecordingWriter
from crenel.metrology.stripe import Stripe
from tests.present import present

NAMES = tuple(f"J{i + 1}" for i in range(6))
FIRST_NS = 1_700_000_000_123_456_789


def stripe_of_length(count: int) -> Stripe:
    rng = np.random.default_rng(count)
    u, v = rng.uniform(0, 1280, (2, count))
    height, sigma = rng.uniform(0, 255, (2, count)).astype(np.float32).astype(np.float64)
    return Stripe(u, v, height, sigma, axis="v" if count % 2 else "u")


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "scan.mcap"


def grey_picture(seed: int, shape: tuple[int, int] = (1024, 1280)) -> GreyImage:
    return np.random.default_rng(seed).integers(0, 255, shape).astype(np.uint8)


def read(path: Path) -> tuple[Recording, list[Record]]:
    recording = open_recording(path)
    return recording, list(recording.records())


def written(path: Path, frames: int = 20, images: bool = True) -> list[Stripe]:
    stripes = [stripe_of_length(100 + i) for i in range(frames)]
    with RecordingWriter(path, NAMES, {"sensor_serial": "S-1", "arm_serial": "A-1"}) as writer:
        for i, stripe in enumerate(stripes):
            stamp_ns = FIRST_NS + i * 10_000_000
            writer.joints(stamp_ns, [0.1 * i + k for k in range(6)])
            writer.stripe(stamp_ns + 1, stripe, 1280, 1024)
            if images:
                writer.image(stamp_ns + 1, grey_picture(i))
    return stripes


def test_what_was_written_reads_back(path: Path) -> None:
    stripes = written(path)
    recording, records = read(path)
    assert recording.cut == ""
    assert recording.station == {"sensor_serial": "S-1", "arm_serial": "A-1"}
    joints = [record for record in records if isinstance(record, JointRecord)]
    found = [record for record in records if isinstance(record, StripeRecord)]
    images = [record for record in records if isinstance(record, ImageRecord)]
    assert (len(joints), len(found), len(images)) == (20, 20, 20)
    fourth_ns = FIRST_NS + 30_000_000
    assert joints[3] == JointRecord(fourth_ns, NAMES, tuple(0.1 * 3 + k for k in range(6)))
    for record, stripe in zip(found, stripes, strict=True):
        for name in ("u", "v", "intensity", "sigma_px"):
            np.testing.assert_array_equal(getattr(record.stripe, name), getattr(stripe, name))
        assert record.stripe.axis == stripe.axis
    size_px = (found[3].width_px, found[3].height_px)
    assert (found[3].stamp_ns, size_px) == (fourth_ns + 1, (1280, 1024))
    for i, image in enumerate(images):
        np.testing.assert_array_equal(image.picture(), grey_picture(i))


def summary_of(path: Path) -> Summary:
    with open(path, "rb") as file:
        summary = make_reader(file).get_summary()
    return present(summary)


def test_the_file_is_a_whole_mcap_to_others(path: Path) -> None:
    written(path, frames=3)
    summary = summary_of(path)
    assert present(summary.statistics).message_count == 9
    topics = {channel.topic for channel in summary.channels.values()}
    assert topics == {"/arm/joints", "/sensor/image", "/sensor/stripe"}


def test_pictures_have_chunks_of_their_own(path: Path) -> None:
    written(path, frames=5)
    summary = summary_of(path)
    topics = {number: channel.topic for number, channel in summary.channels.items()}
    held = [
        {topics[channel] for channel in chunk.message_index_offsets}
        for chunk in summary.chunk_indexes
    ]
    assert held.count({"/sensor/image"}) == 5
    assert held.count({"/arm/joints", "/sensor/stripe"}) == len(held) - 5 > 0


def test_sixteen_bit_pictures_read_back(path: Path) -> None:
    grey = np.random.default_rng(2).integers(0, 65535, (30, 41)).astype(np.uint16)
    with RecordingWriter(path, NAMES) as writer:
        writer.image(5, grey)
    _, records = read(path)
    assert isinstance(records[0], ImageRecord)
    np.testing.assert_array_equal(records[0].picture(), grey)


def test_a_recording_still_being_written_reads_up_to_its_last_chunk(path: Path) -> None:
    writer = RecordingWriter(path, NAMES)
    for i in range(8):
        writer.joints(i, [0.0] * 6)
        writer.image(i, grey_picture(i))
    recording, records = read(path)
    writer.close()
    assert sum(isinstance(record, ImageRecord) for record in records) >= 6
    assert "is incomplete" in str(recording.cut)
    assert read(path)[0].cut == ""
    writer.close()


@pytest.mark.slow
@pytest.mark.parametrize("compression", [None, MCAPCompression.Zstd, MCAPCompression.Lz4])
@pytest.mark.parametrize("chunks", [True, False])
def test_a_cut_file_reads_up_to_the_cut(
    path: Path, compression: MCAPCompression | None, chunks: bool
) -> None:
    cut = path.with_name("cut.mcap")
    context = Context()
    options = MCAPWriteOptions(compression=compression, chunk_size=2000, use_chunks=chunks)
    with open_mcap(path, context=context, writer_options=options):
        channel = JointStatesChannel("/arm/joints", context=context)
        for i in range(200):
            states = [JointState(name=name, position=i + 0.1) for name in NAMES]
            channel.log(JointStates(timestamp=Timestamp(sec=i), joints=states), log_time=i * 10**9)
    whole = path.read_bytes()
    _, all_records = read(path)
    assert len(all_records) == 200
    counts = []
    for length in [*range(8, len(whole), len(whole) // 40), len(whole)]:
        cut.write_bytes(whole[:length])
        recording, records = read(cut)
        assert records == all_records[: len(records)]
        counts.append(len(records))
        if len(records) < 200:
            assert f"of {length} bytes" in str(recording.cut)
            where = f"{len(records) - 1}.000 s" if records else "before its first message"
            assert where in str(recording.cut)
    assert counts == sorted(counts)
    assert counts[len(counts) // 2] > 50


def test_a_damaged_chunk_ends_the_reading(path: Path) -> None:
    written(path, frames=8)
    damaged = bytearray(path.read_bytes())
    damaged[len(damaged) // 2] ^= 1
    path.write_bytes(damaged)
    recording, records = read(path)
    assert "damaged" in str(recording.cut)
    assert 0 < len(records) < 24


@pytest.mark.parametrize("content", [b"", b"\x89MCAP", b"PK\x03\x04 and more than eight bytes"])
def test_what_is_no_mcap_is_refused(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    with pytest.raises(OperationError, match=r"scan\.mcap"):
        read(path)


def test_a_recording_that_is_not_there_is_refused(tmp_path: Path) -> None:
    for path in (tmp_path / "none.mcap", tmp_path):
        with pytest.raises(OperationError, match=str(path)):
            read(path)


def test_an_existing_recording_is_not_overwritten(path: Path) -> None:
    path.write_bytes(b"precious")
    with pytest.raises(OperationError, match=r"scan\.mcap"):
        RecordingWriter(path, NAMES)
    assert path.read_bytes() == b"precious"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
def test_a_full_disk_is_reported_at_once(
    path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    real_open = open
    monkeypatch.setattr(
        "builtins.open", lambda path, mode, **rest: real_open("/dev/full", "wb", **rest)
    )

    def fill() -> None:
        with RecordingWriter(path, NAMES) as writer:
            for stamp in range(5):
                writer.image(stamp, grey_picture(0))

    with pytest.raises(OperationError, match="the disk is full"):
        fill()
    assert capfd.readouterr().err == ""


@contextmanager
def by_others(path: Path) -> Iterator[Context]:
    """The channels of what another program records."""
    context = Context()
    with open_mcap(path, context=context):
        yield context


def test_joints_of_another_type_are_refused(path: Path) -> None:
    with by_others(path) as context:
        RawImageChannel("/arm/joints", context=context).log(RawImage(width=1, height=1))
    with pytest.raises(OperationError, match=r"/arm/joints contains foxglove\.RawImage"):
        read(path)
    path.unlink()
    with by_others(path) as context:
        Channel("/arm/joints", context=context).log({"joints": []})
    with pytest.raises(OperationError, match="/arm/joints contains"):
        read(path)


def test_foreign_topics_are_left_alone(path: Path) -> None:
    with by_others(path) as context:
        Channel("/rosout", context=context).log({"text": "hello"})
        JointStatesChannel("/arm/joints", context=context).log(
            JointStates(joints=[JointState(name="J1", position=0.5)]), log_time=77
        )
    recording, records = read(path)
    assert records == [JointRecord(77, ("J1",), (0.5,))]  # no stamp of its own: the log time
    assert recording.topics == {"/rosout", "/arm/joints"}


def one_image(path: Path, image: RawImage | CompressedImage) -> ImageRecord:
    with by_others(path) as context:
        if isinstance(image, RawImage):
            RawImageChannel("/sensor/image", context=context).log(image)
        else:
            CompressedImageChannel("/sensor/image", context=context).log(image)
    _, (record,) = read(path)
    assert isinstance(record, ImageRecord)
    return record


@pytest.mark.parametrize("kind", ["png", "jpeg"])
def test_compressed_pictures_are_read(path: Path, kind: str) -> None:
    smooth = np.add.outer(np.arange(48), 2 * np.arange(64)).astype(np.uint8)
    _, packed = cv2.imencode(f".{kind}", smooth)
    image = CompressedImage(format=kind, data=packed.tobytes(), timestamp=Timestamp(sec=3))
    record = one_image(path, image)
    assert record.stamp_ns == 3_000_000_000
    difference = record.picture().astype(int) - smooth
    assert np.abs(difference).max() <= (0 if kind == "png" else 3)


def test_rows_with_padding_are_read(path: Path) -> None:
    data = np.arange(3 * 10, dtype=np.uint8).reshape(3, 10)
    image = RawImage(width=7, height=3, encoding="mono8", step=10, data=data.tobytes())
    record = one_image(path, image)
    np.testing.assert_array_equal(record.picture(), data[:, :7])


@pytest.mark.parametrize(
    ("image", "said"),
    [
        (RawImage(width=4, height=3, encoding="rgb8", step=12, data=bytes(36)), "rgb8"),
        (RawImage(width=4, height=3, encoding="mono8", step=4, data=bytes(11)), "11 bytes"),
        (RawImage(width=4, height=3, encoding="mono16", step=4, data=bytes(99)), "4 per row"),
        (RawImage(width=0, height=3, encoding="mono8", step=0, data=b""), "0 × 3"),
        (CompressedImage(format="png", data=b"\x89PNG\r\n\x1a\n...."), "incomplete"),
        (CompressedImage(format="jpeg", data=b""), "empty"),
    ],
)
def test_a_picture_that_is_none_is_refused(
    path: Path, image: RawImage | CompressedImage, said: str
) -> None:
    record = one_image(path, image)
    with pytest.raises(OperationError, match=said):
        record.picture()


def test_the_stripe_schema_in_the_file_is_the_published_one(path: Path) -> None:
    """The bytes in the recording, decoded by the schema in it alone."""
    from mcap.well_known import MessageEncoding
    from mcap_protobuf.decoder import DecoderFactory

    written(path, frames=1, images=False)
    with open(path, "rb") as file:
        ((schema, _, message),) = make_reader(file).iter_messages(topics="/sensor/stripe")
    assert schema is not None
    assert schema.data == stripe_descriptors()
    decode = present(DecoderFactory().decoder_for(MessageEncoding.Protobuf, schema))
    assert list(decode(message.data).u) == stripe_of_length(100).u.tolist()
    assert message.data == encode_stripe(stripe_of_length(100), FIRST_NS + 1, 1280, 1024)


def test_joints_between_samples_lie_on_the_straight_line() -> None:
    track = ReadingTrack("joints", 2)
    assert track.at(0) is None
    for stamp_ns in (0, 10_000_000, 30_000_000, 20_000_000):  # the last one comes late
        track.add(stamp_ns, np.array([stamp_ns * 1e-9, -2.0]))
    track.add(20_000_000, np.array([9.0, 9.0]))  # a repeated stamp changes nothing
    assert len(track) == 4
    for stamp_ns in (0, 1, 9_999_999, 10_000_000, 12_345_678, 25_000_000, 30_000_000):
        found = present(track.at(stamp_ns))
        np.testing.assert_allclose(found, [stamp_ns * 1e-9, -2.0], rtol=1e-12)
    assert track.at(-1) is None
    assert track.at(30_000_001) is None


@given(st.floats(-3.1, 3.1), st.floats(-1.5, 1.5), st.floats(0, 1))
def test_a_joint_is_followed_the_short_way_round(start: float, turn: float, share: float) -> None:
    track = ReadingTrack("joints", 1)
    end = (start + turn + np.pi) % (2 * np.pi) - np.pi
    track.add(0, np.array([start]))
    track.add(10_000_000, np.array([end]))
    stamp_ns = int(share * 10_000_000)
    found = present(track.at(stamp_ns))
    away = float(found[0]) - (start + turn * stamp_ns / 1e7)
    assert abs((away + np.pi) % (2 * np.pi) - np.pi) < 1e-9


def test_a_gap_between_samples_is_not_bridged() -> None:
    track = ReadingTrack("joints", 1)
    for i in range(100):
        track.add(i * 4_000_000 + (10**9 if i >= 50 else 0), np.zeros(1))
    assert track.at(49 * 4_000_000) is not None
    assert track.at(49 * 4_000_000 + 1) is None
    assert track.at(50 * 4_000_000 + 10**9 - 1) is None
    assert track.at(50 * 4_000_000 + 10**9 + 1) is not None


def test_a_slow_arm_may_have_its_own_periods() -> None:
    track = ReadingTrack("joints", 1)
    for i in range(20):
        track.add(i * 33_000_000, np.array([float(i)]))
    found = present(track.at(5 * 33_000_000 + 16_500_000))
    np.testing.assert_allclose(found, [5.5])
