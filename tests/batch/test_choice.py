"""Recordings chosen by id, label, station and calibration; what is not there is named."""

from contextlib import closing
from pathlib import Path

import pytest

pytest.importorskip("distributed")

from crenel.batch.places import find_places, settings_for
from crenel.batch.rebuild import plan_rebuild
from crenel.batch.recordings import Selection
from crenel.cli.choice import name_some
from crenel.store.store import Store
from tests.batch.filled import CALIBRATION, archive_and_close, fill_station
from tests.batch.test_rebuild import run
from tests.cli.test_cli import done, refused

pytestmark = pytest.mark.device

SCANS = ("one", "two", "three")


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    """Of a station whose first two scans were renamed."""
    store = fill_station(tmp_path / "data", SCANS)
    store.scans.rename("one", "4711")
    store.scans.rename("two", "47112")
    archive_and_close(store, tmp_path / "room-2")
    return tmp_path / "room-2"


def chosen(place: Path, selection: Selection) -> list[str]:
    output = settings_for(str(place.with_name("out")))
    planned = plan_rebuild(find_places([str(place)]), selection, output, ".ply")
    return [task.recording.id for task in planned.tasks]


@pytest.mark.parametrize("name", ["room-2", "data"])
def test_recordings_are_chosen_by_id_and_exact_label(archive: Path, name: str) -> None:
    place = archive.with_name(name)
    assert chosen(place, Selection(records=frozenset({"one", "three"}))) == ["one", "three"]
    assert chosen(place, Selection(labels=frozenset({"4711"}))) == ["one"]
    assert chosen(place, Selection(labels=frozenset({"471"}))) == []


def test_a_scan_that_is_renamed_later_has_its_new_label(archive: Path, tmp_path: Path) -> None:
    with closing(Store(tmp_path / "data")) as store:
        store.scans.rename("three", "4713")
    assert chosen(tmp_path / "data", Selection(labels=frozenset({"4713"}))) == ["three"]


def test_the_cloud_of_one_part_with_a_calibration_of_today(archive: Path, tmp_path: Path) -> None:
    calibration = tmp_path / "data/sessions" / CALIBRATION / "calibration.json"
    args = ("--label", "4711", "--calibration", calibration, "--workers", 1, "-o", "parts")
    assert run("rebuild", archive, *args, cwd=tmp_path)["made"] == 1
    (cloud,) = (tmp_path / "parts").glob("*.ply")
    assert cloud.name.startswith("room-2-one-")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--station", "zz"), "there is no station zz in these places. There is: room-2."),
        (("--taken-with", "nope"), f"was taken with nope. There is: {CALIBRATION}."),
        (("--record", "four"), "has the id four. There are: one, three, two."),
        (("--label", "471"), "has the label 471. There are: 4711, 47112, three."),
        (("--label", "4711", "--label", "4799"), "has the label 4799. There are: 4711"),
        (("--record", "one", "--label", "47112"), "none of the scans that they leave is of 47112"),
        (("--record", "one", "--period", "2027"), "this period has the id one. There is none."),
    ],
)
def test_what_is_not_there_ends_the_command_with_what_is(
    archive: Path, tmp_path: Path, options: tuple[str, ...], said: str
) -> None:
    assert said in refused("rebuild", archive, "-o", tmp_path / "out", *options)


def test_a_period_without_a_scan_is_no_mistake(archive: Path, tmp_path: Path) -> None:
    ran = done("rebuild", archive, "-o", tmp_path / "out", "--period", "2027")
    assert "No recording is chosen; the places have 3 scans." in ran.stderr


def test_of_many_the_last_ones_are_named() -> None:
    assert name_some([]) == "There is none."
    assert name_some(f"{number:02d}" for number in range(12)) == (
        "There are: 02, 03, 04, 05, 06, 07, 08, 09, 10, 11, and 2 more."
    )


def test_without_a_place_one_is_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert "Name the archive or the data folder of a station" in refused("rebuild")
