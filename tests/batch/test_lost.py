"""A worker that is killed, a scheduler that is lost, and a store that does not answer."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

pytest.importorskip("distributed")
pytest.importorskip("moto")
pytest.importorskip("s3fs")

from crenel.archive.archive_settings import ArchiveSettings
from crenel.batch.patience import Patience
from crenel.batch.places import find_places, settings_for
from crenel.batch.rebuild import plan_rebuild
from crenel.batch.recordings import Selection
from crenel.batch.results import ResultStore
from crenel.batch.task import perform
from crenel.messages.message import Text
from tests.archive.test_s3 import loop_of_s3fs as loop_of_s3fs
from tests.batch.filled import CALIBRATION, fill_station
from tests.batch.s3 import archive_in_s3, s3_settings, through_proxy
from tests.bench.fleet.losses import CLOUDS, rebuild_with_losses
from tests.bench.fleet.result_count import MadeScan, ResultCount, count_results
from tests.bench.fleet.s3_server import BUCKET, CuttingProxy, S3Server
from tests.cli.test_cli import refused

pytestmark = [pytest.mark.device, pytest.mark.soak]
SCANS = tuple(f"scan-{number}" for number in range(10))


def fill_store(data: Path, server: S3Server) -> ArchiveSettings:
    return archive_in_s3(fill_station(data, SCANS, 100), server)


def test_every_result_is_there_once_whatever_is_lost(tmp_path: Path) -> None:
    (tmp_path / "work").mkdir()
    with S3Server() as server:
        fill_store(tmp_path / "data", server)
        proxy = CuttingProxy(server.port, 1)
        proxy.restore(float("inf"))
        try:
            work = tmp_path / "work"
            ran = rebuild_with_losses(server, proxy, work, "room-2", len(SCANS), away_s=0.0)
        finally:
            proxy.close()
        names = server.names(CLOUDS)
        made = made_scans(tmp_path)
        counted = count_results(made, names, lambda name: server.read(CLOUDS + name), work)
    assert counted == ResultCount(results=len(SCANS), doubled=0, missing=0, differing=0)
    assert ran.printed["refused"] == {}
    assert "is lost; the work goes on" in ran.said


def test_a_bucket_that_is_missing_is_named_before_anything_is_done(tmp_path: Path) -> None:
    fill_station(tmp_path / "data", SCANS[:1]).close()
    with S3Server() as server:
        settings = s3_settings(tmp_path, server)
        (tmp_path / "station.toml").write_text(
            f'[archive]\nurl = "s3://{BUCKET}/room-2"\nendpoint = "{server.url}"\n'
            'access_key = "key"\nsecret_file = "secret"\n'
        )
        options = ("--config", tmp_path / "station.toml", "--workers", "1", "-o")
        line = refused("rebuild", tmp_path / "data", *options, "s3://no-such/out").rstrip()
        assert line.startswith("crenel: The output s3://no-such/out is not there: ")
        assert line.endswith("Create the folder or the bucket, or name another output with -o.")
        ResultStore(settings_for(f"s3://{BUCKET}/out", settings)).prepare()
        assert server.names("out") == []


def test_planning_waits_for_a_store_that_is_away(tmp_path: Path) -> None:
    with S3Server() as server:
        settings = fill_store(tmp_path / "data", server)
        proxy = CuttingProxy(server.port, 1)  # takes nothing yet
        settings = through_proxy(settings, proxy)
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
