"""The thread of the archive: at its own pace, again after a failure, and at an end."""

import threading

import pytest

from crenel.archive.pace import ArchiveEndedError, Pace
from crenel.archive.worker import FIRST_PAUSE_S, LONGEST_PAUSE_S, ArchiveWorker, pause_after
from crenel.messages.message import Text
from tests.archive.filled import Room
from tests.station.conftest import until

pytestmark = pytest.mark.device

DEADLINE_S = 60.0


def test_a_place_that_is_away_is_tried_again_and_reported_once(room: Room) -> None:
    room.place.rmdir()
    room.add_scan("one", 1000)
    said: list[Text] = []
    worker = ArchiveWorker(room.archive(), said.append, 0.01, 0.01)
    worker.start()
    try:
        until(lambda: worker.failures >= 3)
        assert worker.trouble is not None
        assert worker.trouble.code == "archive-missing"
        assert len(said) == 1
        room.place.mkdir()
        until(lambda: worker.state().waiting == 0 and worker.trouble is None)
    finally:
        worker.close()
    assert len(room.manifests()) == 1


def test_pauses_grow_up_to_an_hour() -> None:
    pauses = [pause_after(failures) for failures in range(1, 1000)]
    assert pauses[:3] == [FIRST_PAUSE_S, 2 * FIRST_PAUSE_S, 4 * FIRST_PAUSE_S]
    assert pauses == sorted(pauses)
    assert pauses[-1] == LONGEST_PAUSE_S


def test_a_copy_waits_only_while_a_scan_runs(room: Room) -> None:
    room.add_scan("one", 1000)
    idle = Pace(1.0, lambda: False)
    room.archive(pace=idle).run()
    assert idle.waited_s == 0.0
    scanning = threading.Event()
    scanning.set()
    room.add_scan("two", 1000)
    slow = Pace(0.01, scanning.is_set)  # a byte takes a hundred seconds
    working = threading.Thread(target=room.archive(pace=slow).run)
    working.start()
    until(lambda: slow.waited_s > 0)
    assert len(room.manifests()) == 1
    scanning.clear()
    working.join(DEADLINE_S)
    assert len(room.manifests()) == 2


def test_the_end_of_the_station_ends_a_copy_which_goes_on_later(room: Room) -> None:
    room.add_scan("one", 1000)
    slow = Pace(0.01, lambda: True)
    worker = ArchiveWorker(room.archive(pace=slow), lambda text: None)
    worker.start()
    until(lambda: slow.waited_s > 0)
    worker.close()
    assert worker.trouble is None
    with pytest.raises(ArchiveEndedError):
        slow.take(1)
    assert room.manifests() == []
    assert room.archive().run() == 1
