"""An archive in an S3-compatible store that fails in every way."""

import asyncio
import shutil
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path

import pytest

pytest.importorskip("moto")
pytest.importorskip("s3fs")

import fsspec.asyn

from crenel.archive.archive import Archive
from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.pace import full_speed
from crenel.archive.remote_store import open_store
from crenel.archive.store_errors import DamagedCopyError, StoreError
from crenel.errors import OperationError
from crenel.store.store import Store
from tests.archive.filled import add_scan, archive_of, check_whole, content_of, lists_of
from tests.archive.full_bucket import full_bucket
from tests.bench.fleet.s3_server import BUCKET, CuttingProxy, S3Server

pytestmark = pytest.mark.device
LARGE = 6 << 20
"""Sent in two parts."""


@pytest.fixture(scope="session", autouse=True)
def loop_of_s3fs() -> None:
    """s3fs runs one loop for all stores, and a thread that finds hosts, for good."""
    loop = fsspec.asyn.get_loop()
    asyncio.run_coroutine_threadsafe(loop.getaddrinfo("127.0.0.1", 1), loop).result()


@pytest.fixture(scope="module")
def server() -> Iterator[S3Server]:
    with S3Server() as running:
        yield running


def settings_of(tmp_path: Path, port: int, bucket: str = BUCKET) -> ArchiveSettings:
    (tmp_path / "secret").write_text("secret\n")
    given = {
        "url": f"s3://{bucket}/{tmp_path.name}",
        "endpoint": f"http://127.0.0.1:{port}",
        "access_key": "key",
        "secret_file": "secret",
    }
    return ArchiveSettings.model_validate(given, context=tmp_path / "station.toml")


def open_archive(store: Store, tmp_path: Path, port: int, bucket: str = BUCKET) -> Archive:
    settings = settings_of(tmp_path, port, bucket)
    return Archive(settings, "Room 2", store.folder, lists_of(store), full_speed())


def refusal(archive: Archive) -> OperationError:
    with pytest.raises(OperationError) as refused:
        archive.run()
    assert refused.value.remedy
    return refused.value


def test_records_go_to_the_store_and_back(store: Store, tmp_path: Path, server: S3Server) -> None:
    folder = add_scan(store, "a scan + one", LARGE)
    (folder / "empty").touch()
    before = content_of(folder)
    archive = open_archive(store, tmp_path, server.port)
    assert archive.run() == 1
    (manifest,) = check_whole(server.content(f"{tmp_path.name}/"))
    assert {file.path for file in manifest.files} == set(before)
    assert archive.verify() == []
    assert archive.look().incomplete == []
    archive.store.remove(f"{manifest.folder}/empty")
    assert archive.look().incomplete == [f"{manifest.folder}/empty"]
    archive.store.write(f"{manifest.folder}/empty", [], 0)
    shutil.rmtree(folder)
    archive.fetch("scans", "a scan + one")
    assert content_of(folder) == before


def test_another_stations_place_is_refused(store: Store, tmp_path: Path, server: S3Server) -> None:
    add_scan(store, "one", 1000)
    assert open_archive(store, tmp_path, server.port).run() == 1
    before = server.content(f"{tmp_path.name}/")
    with closing(Store(tmp_path / "other")) as other:
        add_scan(other, "two", 1000)
        refused = refusal(open_archive(other, tmp_path, server.port))
    assert refused.code == "archive-foreign"
    assert "Room 2" in refused.line
    assert server.content(f"{tmp_path.name}/") == before


def test_cut_uploads_leave_nothing_partial(store: Store, tmp_path: Path, server: S3Server) -> None:
    for number in range(3):
        add_scan(store, f"scan-{number}", LARGE if number == 1 else 400_000)
    proxy = CuttingProxy(server.port, seed=7)
    archive = open_archive(store, tmp_path, proxy.port)
    complete = 0
    try:
        for most in (50_000, 6_000_000, 20_000_000, float("inf")):
            proxy.restore(most)
            with suppress(StoreError):
                archive.run()
            whole = len(check_whole(server.content(f"{tmp_path.name}/")))
            assert whole >= complete
            complete = whole
    finally:
        proxy.close()
    assert proxy.cuts >= 2
    assert complete == 3


def test_a_missing_file_is_no_lost_store(store: Store, tmp_path: Path, server: S3Server) -> None:
    add_scan(store, "one", 1000)
    opened = open_archive(store, tmp_path, server.port).store
    opened.write("there", [b"content"], 7)
    for read in (
        lambda: b"".join(opened.read("gone")),
        lambda: opened.read_start("gone", 3),
        lambda: opened.read_spans("gone", [(0, 3)]),
    ):
        with pytest.raises(DamagedCopyError):
            read()


def test_a_store_that_fails_has_a_remedy(store: Store, tmp_path: Path, server: S3Server) -> None:
    add_scan(store, "one", 1000)
    server.check_keys(True)
    try:
        assert refusal(open_archive(store, tmp_path, server.port)).code == "archive-forbidden"
    finally:
        server.check_keys(False)
    other = open_archive(store, tmp_path, server.port, "no-such-bucket")
    assert refusal(other).code == "archive-missing"
    assert "no-such-bucket" not in [one["Name"] for one in server.client.list_buckets()["Buckets"]]
    proxy = CuttingProxy(server.port, seed=1)
    proxy.close()  # nobody listens
    assert refusal(open_archive(store, tmp_path, proxy.port)).code == "archive-away"
    assert open_archive(store, tmp_path, server.port).run() == 1


@pytest.mark.parametrize("kind", ["MinIO", "Ceph"])
@pytest.mark.parametrize("size", [400_000, LARGE])
def test_a_full_bucket_is_named_keeps_nothing_partial_and_goes_on_with_more_room(
    kind: str, size: int, store: Store, tmp_path: Path, server: S3Server
) -> None:
    add_scan(store, "one", 1000)
    add_scan(store, "two", size)
    with full_bucket(server.port, kind, size - 10_000) as bucket:
        archive = open_archive(store, tmp_path, bucket.port)
        assert refusal(archive).code == "archive-full"
        assert bucket.refused
        there = server.content(f"{tmp_path.name}/")
        assert [one.id for one in check_whole(there)] == ["one"]
        assert "Uploads" not in server.client.list_multipart_uploads(Bucket=BUCKET)
        bucket.room = 100_000_000
        assert archive.run() == 1
    assert len(check_whole(server.content(f"{tmp_path.name}/"))) == 2


def test_another_fsspec_store_works_as_well(store: Store) -> None:
    add_scan(store, "one", LARGE)
    archive = archive_of(store, "memory://archive-of-tests/room")
    assert archive.run() == 1
    assert archive.verify() == []


def test_an_address_without_a_library_says_what_to_install(store: Store) -> None:
    add_scan(store, "one", 1000)
    error = refusal(archive_of(store, "nonsense://bucket/x"))
    assert error.code == "archive-library"
    assert "nonsense" in str(error.remedy)


def test_a_password_in_an_address_is_not_shown() -> None:
    settings = ArchiveSettings.model_validate(
        {"url": "sftp://user:secret@host/folder"}, context=Path("station.toml")
    )
    assert settings.place == "sftp://host/folder"
    open_store(settings)
