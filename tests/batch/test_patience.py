"""Planning waits for a store that cannot be reached."""

import threading
import time
from pathlib import Path

import pytest

from crenel.archive.remote_store import FolderStore
from crenel.archive.store_errors import StoreError, store_error
from crenel.batch import patience as module
from crenel.batch.patience import Patience, PatientStore
from crenel.batch.places import find_places, settings_for
from crenel.batch.rebuild import plan_rebuild
from crenel.batch.recordings import Selection
from crenel.messages.message import Text
from tests.batch.filled import fill_archive

SCANS = ("one", "two", "three")


class SometimesAway(FolderStore):
    failures = 0

    def fail(self) -> None:
        if self.failures > 0:
            self.failures -= 1
            raise store_error("archive-away", "s3://plant", "the cable is out", "records")

    def size(self, name: str) -> int | None:
        self.fail()
        return super().size(name)

    def names(self, folder: str) -> list[str]:
        self.fail()
        return super().names(folder)

    def read_start(self, name: str, count: int) -> bytes:
        self.fail()
        return super().read_start(name, count)


@pytest.fixture
def said(monkeypatch: pytest.MonkeyPatch) -> list[Text]:
    """What is said; the pauses are short."""
    monkeypatch.setattr(module, "FIRST_PAUSE_S", 0.01)
    monkeypatch.setattr(module, "LONGEST_PAUSE_S", 0.02)
    return []


def test_that_a_store_comes_back_is_said_once(tmp_path: Path, said: list[Text]) -> None:
    (tmp_path / "file").write_bytes(b"content")
    inner = SometimesAway(tmp_path, "records")
    store = PatientStore(inner, Patience(said.append))
    for _ in range(2):
        inner.failures = 3
        assert store.size("file") == 7
    assert store.names("") == ["file"]
    assert [str(text) for text in said] == 2 * [
        "The archive s3://plant cannot be reached: the cable is out; meanwhile the work waits",
        "The store is there again.",
    ]


def test_a_store_is_given_up_in_time_or_for_a_reason(tmp_path: Path, said: list[Text]) -> None:
    store = PatientStore(FolderStore(tmp_path / "none", "records"), Patience(said.append))
    with pytest.raises(StoreError, match="is not there"):
        store.size("file")
    assert said == []
    inner = SometimesAway(tmp_path, "records")
    inner.failures = 10**9
    with pytest.raises(StoreError, match="cannot be reached"):
        PatientStore(inner, Patience(said.append, give_up_s=0.05)).names("")
    assert len(said) == 1


def test_who_waits_ends_with_the_work(tmp_path: Path, said: list[Text]) -> None:
    inner = SometimesAway(tmp_path, "records")
    inner.failures = 10**9
    patience = Patience(said.append)
    store, ended = PatientStore(inner, patience), threading.Event()

    def read() -> None:
        with pytest.raises(StoreError):
            store.names("")
        ended.set()

    threading.Thread(target=read, daemon=True).start()
    while not said:
        time.sleep(0.01)
    patience.end()
    assert ended.wait(20.0)


def test_a_plan_is_complete_although_the_store_was_away(
    tmp_path: Path, said: list[Text], monkeypatch: pytest.MonkeyPatch
) -> None:
    fill_archive(tmp_path / "room-2", tmp_path / "data", SCANS)
    inner = SometimesAway(tmp_path / "room-2", "records")
    monkeypatch.setattr(module, "open_store", lambda settings, purpose: inner)
    inner.failures = 2
    patience = Patience(said.append)
    places = find_places([str(tmp_path / "room-2")], patience=patience)
    inner.failures = 20
    output = settings_for(str(tmp_path / "out"))
    planned = plan_rebuild(places, Selection(), output, ".ply", patience=patience)
    assert sorted(task.recording.id for task in planned.tasks) == sorted(SCANS)
    assert planned.refused == []
    assert inner.failures == 0


class TwoIsAway(FolderStore):
    """Has all records but one."""

    def size(self, name: str) -> int | None:
        if name.startswith("scans/two/"):
            raise store_error("archive-away", "s3://plant", "the cable is out", "records")
        return super().size(name)


def test_an_interruption_ends_the_waiting_of_all_threads(
    tmp_path: Path, said: list[Text], monkeypatch: pytest.MonkeyPatch
) -> None:
    fill_archive(tmp_path / "room-2", tmp_path / "data", SCANS)
    inner = TwoIsAway(tmp_path / "room-2", "records")
    monkeypatch.setattr(module, "open_store", lambda settings, purpose: inner)
    places = find_places([str(tmp_path / "room-2")])

    def interrupt(share: float, text: Text) -> None:
        while not said:
            time.sleep(0.01)
        raise KeyboardInterrupt

    patience = Patience(said.append)
    output = settings_for(str(tmp_path / "out"))
    with pytest.raises(KeyboardInterrupt):
        plan_rebuild(places, Selection(), output, ".ply", None, interrupt, patience)
    assert not [one for one in threading.enumerate() if one.name.startswith("find-record")]
