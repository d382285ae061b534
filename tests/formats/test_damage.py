"""Whatever happens to the bytes of a file, reading it ends well or in a refusal."""

import zlib
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.formats.clouds.files import cloud_writer, read_cloud
from crenel.formats.images import read_grey
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.calibration import read_calibration
from crenel.formats.session.calibration_session import read_session
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.formats.builders import ARM, joints_every, little_calibration, write_session
from tests.formats.test_clouds import POINTS
from tests.formats.test_documents import calibration_file
from tests.formats.test_image_sizes import png
from tests.refusals import refused_as
from tests.workflows.test_reconstruct import MS, NAMES, record_stripe

pytestmark = pytest.mark.slow

Damage = list[tuple[float, bytes, int]]
changes = st.lists(
    st.tuples(st.floats(0, 1), st.binary(max_size=4), st.integers(0, 4)), min_size=1, max_size=3
)


def damaged(whole: bytes, damage: Damage) -> bytes:
    """Some bytes replaced, put in or taken out, at places from 0 (start) to 1 (end)."""
    content = bytearray(whole)
    for place, put_in, taken_out in damage:
        at = int(place * len(content))
        content[at : at + taken_out] = put_in
    return bytes(content)


relaxed = settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture
def session(tmp_path: Path) -> Path:
    return write_session(tmp_path / "s")


@given(
    st.sampled_from(
        ["arm.json", "object.json", "sensor.json", "probing.csv", "images.csv", "images/a.png"]
    ),
    changes,
)
@relaxed
def test_a_damaged_session(session: Path, name: str, damage: Damage) -> None:
    whole = (session / name).read_bytes()
    (session / name).write_bytes(damaged(whole, damage))
    with suppress(OperationError):
        read_grey(read_session(session).poses[0].ambient)
    (session / name).write_bytes(whole)


@given(changes)
@relaxed
def test_a_damaged_calibration(tmp_path: Path, damage: Damage) -> None:
    path = tmp_path / "c.json"
    calibration_file().write(path)
    path.write_bytes(damaged(path.read_bytes(), damage))
    with suppress(OperationError):
        read_calibration(path)


@given(changes)
@relaxed
def test_a_damaged_cloud(tmp_path: Path, damage: Damage) -> None:
    path = tmp_path / "c.ply"
    with cloud_writer(path) as cloud:
        cloud.write(POINTS[:9], POINTS[:9, 0], POINTS[:9, 0], 0)
    path.write_bytes(damaged(path.read_bytes(), damage))
    with suppress(OperationError):
        read_cloud(path)


@pytest.mark.device
@pytest.mark.parametrize(
    ("place", "content"), [("chunk size", b"\xfe\xff\xff\xff"), ("chunks", b"~")]
)
def test_a_laz_whose_library_would_abort(tmp_path: Path, place: str, content: bytes) -> None:
    path = tmp_path / "c.laz"
    with cloud_writer(path) as cloud:
        cloud.write(POINTS, POINTS[:, 0], POINTS[:, 0], 0)
    whole = path.read_bytes()
    begin_of_points = int.from_bytes(whole[96:100], "little")
    chunk_table = int.from_bytes(whole[begin_of_points:][:8], "little")
    at = {"chunk size": whole.index(b"laszip encoded") + 64, "chunks": chunk_table + 7}[place]
    path.write_bytes(whole[:at] + content + whole[at + len(content) :])
    with refused_as("cloud-malformed", "not a complete LAS/LAZ file", "bytes failed"):
        read_cloud(path)


@pytest.fixture
def recording(tmp_path: Path) -> bytes:
    path = tmp_path / "whole.mcap"
    with RecordingWriter(path, NAMES) as writer:
        joints_every(writer, 0, 40 * MS, 4 * MS)
        record_stripe(writer, 20 * MS)
    return path.read_bytes()


@given(changes)
@relaxed
def test_a_damaged_recording(tmp_path: Path, recording: bytes, damage: Damage) -> None:
    path = tmp_path / "scan.mcap"
    path.write_bytes(damaged(recording, damage))
    with suppress(OperationError):
        reconstruct_cloud(path, little_calibration(), ARM, tmp_path / "cloud.ply")


def test_a_length_that_no_machine_could_hold(tmp_path: Path, recording: bytes) -> None:
    """A byte too many, somewhere in the first records: lengths with their highest bit set."""
    path = tmp_path / "scan.mcap"
    for at in range(400):
        path.write_bytes(recording[:at] + b"\x80" + recording[at:])
        with suppress(OperationError):
            reconstruct_cloud(path, little_calibration(), ARM, tmp_path / "cloud.ply")


def test_a_text_cloud_that_announces_more_than_any_disk_holds(tmp_path: Path) -> None:
    path = tmp_path / "cloud.ply"
    head = ["ply", "format ascii 1.0", "element other 1000000000000000000", "property float a"]
    head += ["element vertex 1", *(f"property float {axis}" for axis in "xyz"), "end_header"]
    path.write_text("\n".join([*head, "1", "2"]) + "\n")
    with pytest.raises(OperationError, match="0 of 1 points"):
        read_cloud(path)


def test_a_picture_larger_than_can_be_read(tmp_path: Path) -> None:
    """A whole PNG of 60,000 x 60,000 black pixels, which takes no space in the file."""
    path = tmp_path / "huge.png"
    path.write_bytes(png(60_000, 60_000, data=zlib.compress(b"")))
    with pytest.raises(OperationError, match=r"huge\.png"):
        read_grey(path)
