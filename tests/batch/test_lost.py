"""A worker that is killed, a scheduler that is lost, and a store that does not answer."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

pytest.importorskip("distributed")
pytest.importorskip("moto")
pytest.importorskip("s3fs")

from app.archive.archive import Archive
from app.archive.archive_settings import ArchiveSettings
from app.archive.pace import full_speed
from app.batch.patience import Patience
from app.batch.places import find_places, settings_for
from app.batch.rebuild import plan_rebuild
from app.batch.recordings import Selection
from app.batch.results import ResultStore
from app.batch.task import perform
from app.bench.fleet.losses import CLOUDS, rebuild_with_losses
from app.bench.fleet.result_count import MadeScan, ResultCount, count_results
from app.bench.fleet.s3_server import BUCKET, CuttingProxy, S3Server
from app.cli.main import cli
from app.messages.message import Text
from tests.archive.filled import lists_of
from tests.archive.test_s3 import loop_of_s3fs as loop_of_s3fs
from tests.batch.filled import CALIBRATION, fill_station

pytestmark = [pytest.mark.device, pytest.mark.soak]
SCANS = tuple(f"scan-{number}" for number in range(10))


def s3_settings(folder: Path, server: S3Server) -> ArchiveSettings:
    """An archive in the S3 store, with its secret in the folder."""
    given = {
        "url": f"s3://{BUCKET}/room-2",
        "endpoint": server.url,
        "access_key": "key",
        "secret_file": "secret",
    }
    return ArchiveSettings.model_validate(given, context=folder / "station.toml")


def fill_store(data: Path, server: S3Server) -> None:
    """An archive in the S3 store, of a station with scans."""
    (data.parent / "secret").write_text("secret\n")
    settings = s3_settings(data.parent, server)
    store = fill_station(data, SCANS, 100)
    try:
        Archive(settings, data.name, data, lists_of(store), full_speed()).run()
    finally:
        store.close()


def test_every_result_is_there_once_whatever_is_lost(tmp_path: Path) -> None:
    (tmp_path / "work").mkdir()
    with S3Server() as server:
        fill_store(tmp_path / "data", server)
        proxy = CuttingProxy(server.port, 1)
        proxy.restore(float("inf"))
        try:
            ran = rebuild_with_losses(
                server, proxy, tmp_path / "work", "room-2", len(SCANS), away_s=0.0
            )
        finally:
            proxy.close()
        counted = count_results(
            made_scans(tmp_path),
            server.names(CLOUDS),
            lambda name: server.read(CLOUDS + name),
            tmp_path / "work",
        )
    assert counted == ResultCount(results=len(SCANS), doubled=0, missing=0, differing=0)
    assert ran.printed["refused"] == {}
    assert "is lost; the work goes on" in ran.said


def test_a_bucket_that_is_missing_is_named_before_anything_is_done(tmp_path: Path) -> None:
    fill_station(tmp_path / "data", SCANS[:1]).close()
    (tmp_path / "secret").write_text("secret\n")
    with S3Server() as server:
        (tmp_path / "station.toml").write_text(
            f'[archive]\nurl = "s3://{BUCKET}/room-2"\nendpoint = "{server.url}"\n'
            'access_key = "key"\nsecret_file = "secret"\n'
        )
        options = ("--config", tmp_path / "station.toml", "--workers", "1", "-o")
        command = ["rebuild", str(tmp_path / "data"), *map(str, options)]
        refused = CliRunner().invoke(cli, [*command, "s3://no-such/out"])
        assert refused.exit_code == 1
        (line,) = refused.stderr.splitlines()
        assert line.startswith("crenel: The output s3://no-such/out is not there: ")
        assert line.endswith("Create the folder or the bucket, or name another output with -o.")
        output = ResultStore(settings_for(f"s3://{BUCKET}/out", s3_settings(tmp_path, server)))
        output.prepare()
        assert server.names("out") == []


def test_planning_waits_for_a_store_that_is_away(tmp_path: Path) -> None:
    with S3Server() as server:
        fill_store(tmp_path / "data", server)
        proxy = CuttingProxy(server.port, 1)  # takes nothing yet
        settings = s3_settings(tmp_path, server)
        settings = settings.model_copy(update={"endpoint": f"http://127.0.0.1:{proxy.port}"})
        said: list[str] = []

        def note(text: Text) -> None:
            said.append(str(text))
            proxy.restore(float("inf"))

        patience = Patience(note)
        try:
            places = find_places([settings.url], settings, patience)
            output = settings_for(str(tmp_path / "out"))
            planned = plan_rebuild(places, Selection(), output, ".ply", patience=patience)
        finally:
            proxy.close()
    assert len(planned.tasks) == len(SCANS)
    assert len(said) == 2
    assert "cannot be reached" in said[0]


def made_scans(tmp_path: Path, scans: Sequence[str] = SCANS) -> list[MadeScan]:
    data = tmp_path / "data"
    session = data / "sessions" / CALIBRATION
    return [MadeScan("room-2", data / "scans" / one, session) for one in scans]


def test_what_is_doubled_missing_or_wrong_is_counted(tmp_path: Path) -> None:
    scans = SCANS[:3]
    fill_station(tmp_path / "data", scans).close()
    out = tmp_path / "out"
    out.mkdir()
    place, settings = find_places([str(tmp_path / "data")]), settings_for(str(out))
    tasks = plan_rebuild(place, Selection(), settings, ".ply").tasks

    def count() -> tuple[int, int, int, int]:
        made = [replace(one, station="data") for one in made_scans(tmp_path, scans)]
        names = sorted(path.name for path in out.iterdir())
        found = count_results(made, names, lambda name: (out / name).read_bytes(), tmp_path)
        return found.results, found.doubled, found.missing, found.differing

    for task in tasks[1:]:
        assert perform(task, tmp_path, 1).state == "done"
    assert count() == (2, 0, 1, 0)
    assert perform(tasks[0], tmp_path, 1).state == "done"
    assert count() == (3, 0, 0, 0)
    document, cloud = out / f"{tasks[0].stem}.json", out / f"{tasks[1].stem}.ply"
    (out / "again.json").write_bytes(document.read_bytes())
    assert count() == (3, 1, 0, 0)
    (out / "other.ply").write_bytes(b"ply")
    assert count() == (3, 2, 0, 0)
    cloud.write_bytes(cloud.read_bytes()[:-1])
    assert count() == (3, 2, 0, 1)
    cloud.unlink()
    assert count() == (2, 2, 1, 0)
