"""A rebuild from a store fetches no pictures of frames that have stripes."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("distributed")
pytest.importorskip("moto")
pytest.importorskip("s3fs")

import numpy as np

from crenel.batch.places import find_places, settings_for
from crenel.batch.rebuild import RebuildTask, plan_rebuild
from crenel.batch.recordings import Selection
from crenel.batch.results import ResultStore
from crenel.batch.task import perform
from crenel.formats.recording.index import find_needless_pictures, read_index
from crenel.formats.recording.reader import SCAN_STARTED
from crenel.formats.recording.writer import RecordingWriter
from tests.archive.test_s3 import loop_of_s3fs as loop_of_s3fs
from tests.batch.filled import ABOUT, FIRST, fill_station
from tests.batch.s3 import archive_in_s3, through_proxy
from tests.batch.test_rebuild import direct_cloud
from tests.bench.fleet.s3_server import BUCKET, CuttingProxy, S3Server
from tests.formats.builders import joints_every
from tests.present import present
from tests.running.usual import usual
from tests.workflows.test_reconstruct import MS, NAMES, record_image, record_stripe

pytestmark = pytest.mark.device

FRAMES = 60
PICTURE = np.random.default_rng(7).integers(0, 255, (400, 500), np.uint8)


@pytest.fixture(scope="module")
def server() -> Iterator[S3Server]:
    with S3Server() as running:
        yield running


def record_with_pictures(path: Path, without_stripe: int | None = None) -> None:
    """Frames with a picture before each sixth stripe; one with its picture only."""
    path.unlink()
    with RecordingWriter(path, NAMES, ABOUT | {SCAN_STARTED: FIRST.isoformat()}) as writer:
        joints_every(writer, 0, (FRAMES + 20) * 4 * MS, 4 * MS)
        for number in range(FRAMES):
            stamp_ns = (10 + number) * 4 * MS
            if number == without_stripe:
                record_image(writer, stamp_ns)
                continue
            if number % 6 == 0:
                writer.image(stamp_ns, PICTURE)
            record_stripe(writer, stamp_ns)


def plan_from_store(
    server: S3Server, proxy: CuttingProxy, tmp_path: Path, without_stripe: int | None = None
) -> tuple[RebuildTask, Path, ResultStore]:
    """The rebuild of a station's only scan, its recording and the results."""
    store = fill_station(tmp_path / "data", ["one"])
    recording = tmp_path / "data/scans/one/scan.mcap"
    record_with_pictures(recording, without_stripe)
    settings = archive_in_s3(store, server, tmp_path.name)
    proxy.restore(float("inf"))
    places = find_places([settings.url], through_proxy(settings, proxy))
    results = ResultStore(settings_for(str(tmp_path / "out")))
    results.prepare()
    (task,) = plan_rebuild(places, Selection(), results.settings, ".ply").tasks
    return task, recording, results


def stripe_chunk(recording: Path) -> int:
    """Where the first chunk with stripes begins."""
    with recording.open("rb") as file:
        index = read_index(file)
    assert index is not None
    return next(one.chunk_start_offset for one in index.chunks if index.stripe_channels(one))


@pytest.mark.parametrize("without_stripe", usual([8, None], 1, pytest.mark.soak))
def test_pictures_stay_in_the_store_and_the_cloud_is_the_same(
    without_stripe: int | None, server: S3Server, tmp_path: Path
) -> None:
    proxy = CuttingProxy(server.port, seed=1)
    try:
        task, recording, results = plan_from_store(server, proxy, tmp_path, without_stripe)
        before = proxy.passed_bytes
        assert perform(task, tmp_path, 1).state == "done"
        fetched = proxy.passed_bytes - before
    finally:
        proxy.close()
    size = recording.stat().st_size
    print(f"fetched {fetched} of {size} bytes")
    assert 10 * PICTURE.size < size
    assert fetched < size - 9 * PICTURE.size
    made = present(results.read(task.stem))
    assert made["frames"] == FRAMES
    assert (tmp_path / "out" / made["cloud"]).read_bytes() == direct_cloud(tmp_path / "data", "one")


def test_a_copy_that_was_damaged_in_the_store_is_not_used(server: S3Server, tmp_path: Path) -> None:
    proxy = CuttingProxy(server.port, seed=1)
    try:
        task, recording, _ = plan_from_store(server, proxy, tmp_path)
        content = bytearray(recording.read_bytes())
        content[stripe_chunk(recording) + 200] ^= 0xFF
        key = f"{tmp_path.name}/{task.recording.file.name}"
        server.client.put_object(Bucket=BUCKET, Key=key, Body=bytes(content))
        outcome = perform(task, tmp_path, 1)
    finally:
        proxy.close()
    assert outcome.state == "again"
    assert present(outcome.refusal).code == "archive-differs"


def test_a_recording_without_its_end_has_no_index(tmp_path: Path) -> None:
    path = tmp_path / "scan.mcap"
    path.touch()
    record_with_pictures(path)
    with path.open("rb") as file:
        index = present(read_index(file))
        assert len(index.pictures) == 10
        assert find_needless_pictures(file, index) == index.picture_spans
    for damage in (-30, -500):
        content = bytearray(path.read_bytes())
        content[damage] ^= 0xFF
        (tmp_path / "damaged").write_bytes(content)
        with (tmp_path / "damaged").open("rb") as file:
            assert read_index(file) is None
    os.truncate(path, path.stat().st_size - 1)
    with path.open("rb") as file:
        assert read_index(file) is None
        assert find_needless_pictures(file, None) == {}
