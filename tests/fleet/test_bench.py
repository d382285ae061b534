"""``python -m tests.bench catalogue`` stores what it says, and its questions have answers."""

from pathlib import Path

import pytest

from crenel.progress import no_progress
from crenel.settings.station_toml import DEFAULT_FILE, read_settings
from tests.bench.fleet.catalogue import run, table
from tests.bench.fleet.recording_stations import SECRET, make_station

pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_a_small_catalogue_is_filled_and_asked() -> None:
    found = run(10_000, 20, "", no_progress)
    assert found.rows >= 10_000
    assert found.records >= 500
    assert found.bytes > 100_000
    answers = {one.question: one.answers for one in found.questions}
    assert answers["one record with results and files"] == 1
    assert answers["all stations with their counts"] == 20
    assert answers["calibrations of every sensor"] == 20
    assert answers["ageing of a gauge's offset at one station"] > 0
    assert answers["a word that an eighth of all records have"] > 0
    assert len(table(found)) == len(found.questions) + 2


def test_relative_folders_find_the_secret(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    station = make_station(Path(), "room-1", "http://127.0.0.1:1")
    settings = read_settings(station.data / DEFAULT_FILE)
    assert settings.archive is not None
    assert settings.archive.secret() == station.archive.secret() == SECRET
