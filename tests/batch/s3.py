"""Archives of stations in the store that speaks S3."""

from pathlib import Path

from crenel.archive.archive import Archive
from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.pace import full_speed
from crenel.store.store import Store
from tests.archive.filled import lists_of
from tests.bench.fleet.s3_server import BUCKET, CuttingProxy, S3Server


def s3_settings(folder: Path, server: S3Server, name: str = "room-2") -> ArchiveSettings:
    """An archive in the store, whose secret is put into the folder."""
    (folder / "secret").write_text("secret\n")
    given = {"url": f"s3://{BUCKET}/{name}", "endpoint": server.url}
    given |= {"access_key": "key", "secret_file": "secret"}
    return ArchiveSettings.model_validate(given, context=folder / "station.toml")


def archive_in_s3(store: Store, server: S3Server, name: str = "room-2") -> ArchiveSettings:
    settings = s3_settings(store.folder.parent, server, name)
    try:
        Archive(settings, "Room 2", store.folder, lists_of(store), full_speed()).run()
    finally:
        store.close()
    return settings


def through_proxy(settings: ArchiveSettings, proxy: CuttingProxy) -> ArchiveSettings:
    return settings.model_copy(update={"endpoint": f"http://127.0.0.1:{proxy.port}"})
