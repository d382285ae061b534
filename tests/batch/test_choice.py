"""Recordings chosen by id, label, station and calibration; what is not there is named."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

pytest.importorskip("distributed")

from app.batch.places import find_places, settings_for
from app.batch.rebuild import plan_rebuild
from app.batch.recordings import Selection
from app.cli.choice import name_some
from app.cli.main import cli
from app.store.store import Store
from tests.archive.filled import archive_of
from tests.batch.filled import CALIBRATION, fill_station
from tests.batch.test_rebuild import run

pytestmark = pytest.mark.device

SCANS = ("one", "two", "three")


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    """Of a station whose first two scans were renamed."""
    store = fill_station(tmp_path / "data", SCANS)
    try:
        store.scans.rename("one", "4711")
        store.scans.rename("two", "47112")
        (tmp_path / "room-2").mkdir()
        archive_of(store, str(tmp_path / "room-2")).run()
    finally:
        store.close()
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
    store = Store(tmp_path / "data")
    try:
        store.scans.rename("three", "4713")
    finally:
        store.close()
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
    ran = CliRunner().invoke(cli, ["rebuild", str(archive), "-o", str(tmp_path / "out"), *options])
    assert ran.exit_code == 1
    (line,) = ran.stderr.splitlines()
    assert said in line


def test_a_period_without_a_scan_is_no_mistake(archive: Path, tmp_path: Path) -> None:
    args = ["-o", str(tmp_path / "out"), "--period", "2027"]
    ran = CliRunner().invoke(cli, ["rebuild", str(archive), *args])
    assert ran.exit_code == 0
    assert "No recording is chosen; the places have 3 scans." in ran.stderr


def test_of_many_the_last_ones_are_named() -> None:
    assert name_some([]) == "There is none."
    assert name_some(f"{number:02d}" for number in range(12)) == (
        "There are: 02, 03, 04, 05, 06, 07, 08, 09, 10, 11, and 2 more."
    )


def test_a_command_without_a_place_asks_for_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = CliRunner().invoke(cli, ["rebuild"])
    assert ran.exit_code == 1
    (line,) = ran.stderr.splitlines()
    assert "Name the archive or the data folder of a station" in line
