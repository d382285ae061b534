"""What the station reports of its own health: the loop's watchdog, the log, losses, checks."""

import asyncio
import json
import logging
import threading
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.findings import GRAVEST_FIRST
from crenel.messages.catalogue import translator
from crenel.messages.message import MessageList, message, quantity
from crenel.monitoring import health, storage_health
from crenel.monitoring.log_store import FILE, FILE_BYTES, MOST_WAITING, LogStore
from crenel.monitoring.loop_watchdog import LoopWatchdog, Stalls
from crenel.monitoring.system_info import Memory, WallClock, memory, writable
from crenel.station.devices.device_thread import Link, LinkState
from crenel.station.devices.link_state import device_state
from crenel.station.devices.losses import Losses, LossWindow
from crenel.station.devices.temperature import Temperature, TemperatureWatch
from crenel_hardware.simulator.scene.world import RoomThermometer
from crenel_hardware.thermometer import FileThermometer
from tests.station.conftest import until

pytestmark = pytest.mark.device

LOG = logging.getLogger("crenel.test_health")


def hold_up(seconds: float) -> None:
    time.sleep(seconds)


def test_a_held_up_loop_is_counted_with_the_stack_of_why(caplog: pytest.LogCaptureFixture) -> None:
    watchdog = LoopWatchdog(0.1)

    async def run() -> None:
        watchdog.start(asyncio.get_running_loop())
        await asyncio.sleep(0.3)
        hold_up(0.5)
        await asyncio.sleep(0.3)

    asyncio.run(run())
    watchdog.stop()
    stalls = watchdog.stalls
    # on a busy machine there may be more of them
    assert stalls.count + stalls.pauses >= 1
    assert max(stalls.longest_s, stalls.longest_pause_s) > 0.2
    stacks = [getattr(record, "trace", "") for record in caplog.records]
    assert "hold_up" in "".join(stacks) or stalls.pauses
    assert health.event_loop(stalls, 0.1).quality == "neutral"
    assert health.event_loop(Stalls(1, 3.0), 0.1).quality == "attention"
    assert health.event_loop(Stalls(), 0.1).quality == "good"


@pytest.fixture
def book(tmp_path: Path) -> Iterator[LogStore]:
    with closing(LogStore(tmp_path)) as opened:
        yield opened


def test_what_is_logged_is_read_by_level_and_words(book: LogStore) -> None:
    began = time.time()
    LOG.debug("too small")
    LOG.info("the arm %s", "came back")
    LOG.warning("the camera is slow", extra={"trace": "in this place"})
    logging.getLogger("other").info("not ours")
    try:
        raise RuntimeError("three")
    except RuntimeError:
        LOG.exception("the camera failed")
    written(book, 3)
    texts = [line.text for line in book.read("info", "", 10)]
    assert texts == ["the camera failed", "the camera is slow", "the arm came back"]
    assert [line.level for line in book.read("warning", "CAMERA", 10)] == ["error", "warning"]
    (failure,) = book.read("error", "runtimeerror", 10)
    assert "RuntimeError: three" in failure.trace
    assert book.read("warning", "slow", 1)[0].trace == "in this place"
    assert book.read("info", "", 1)[0].text == "the camera failed"
    assert book.errors_since(began - 1) == 1
    assert book.errors_since(time.time() + 1) == 0
    for text in (book.folder / FILE).read_text().splitlines():
        assert set(json.loads(text)) >= {"at", "level", "logger", "thread", "text"}


def test_a_message_is_logged_with_data_and_searched_in_the_readers_language(book: LogStore) -> None:
    stood = message("log-program-stood-still", duration=quantity(1.5, "s", 1))
    LOG.warning(stood)
    LOG.info("the arm came back")
    written(book, 2)
    german = translator("de")
    assert german is not None
    assert [line.text for line in book.read("info", "", 10)] == ["the arm came back", stood]
    for words in ("PROGRAMM 1,5", "program 1.5"):
        assert [line.text for line in book.read("info", words, 10, german)] == [stood]
    assert book.read("info", "programm", 10) == []
    assert book.read("error", "programm", 10, german) == []
    warning = json.loads((book.folder / FILE).read_text().splitlines()[0])
    assert warning["text"] == "the whole program was suspended for 1.5 s"
    assert warning["text_message"]["message_id"] == "log-program-stood-still"


def test_what_is_no_message_of_this_version_is_shown_in_english(book: LogStore) -> None:
    line = {"at": "", "level": "info", "logger": "", "thread": "", "text": "plain"}
    for data in ({"message_id": "of-another-version", "values": {}}, {"value": 1}, 3, None):
        with (book.folder / FILE).open("a") as file:
            file.write(json.dumps({**line, "text_message": data}) + "\n")
    assert [one.text for one in book.read("info", "", 10)] == ["plain"] * 4


def test_a_repeated_message_keeps_its_data(book: LogStore) -> None:
    for _ in range(10):
        LOG.warning(message("log-program-stood-still", duration=quantity(1.5, "s", 1)))
    written(book, 4)
    newest = book.read("info", "", 1)[0].text
    assert str(newest).startswith("the whole program was suspended for 1.5 s (10 of these since ")
    assert isinstance(newest, MessageList)


def test_what_strangers_put_into_a_message_does_nothing_to_readers(book: LogStore) -> None:
    LOG.warning(message("log-file-not-used", file="\x1b[31m\u202e", reason="x" * 100_000))
    LOG.warning(message("log-file-not-used", file="\x1b[31m\u202e", reason="x"))
    written(book, 2)
    raw = (book.folder / FILE).read_text("utf-8")
    assert all(sign.isprintable() or sign == "\n" for sign in raw)
    assert len(raw) < 3000
    assert "\\x1b[31m" in str(book.read("info", "", 1)[0].text)


def written(book: LogStore, count: int) -> None:
    until(lambda: len(book.read("info", "", 10_000)) >= count)


def test_a_log_is_rotated_and_a_line_cut_off_by_a_kill_is_left_out(book: LogStore) -> None:
    LOG.info("first")
    written(book, 1)
    with (book.folder / FILE).open("a") as file:
        file.write("x" * (FILE_BYTES - 200) + "\n")
    for number in range(3):
        LOG.info("after %d", number)
    written(book, 4)
    assert len(book.files()) == 2
    texts = [line.text for line in book.read("info", "", 100)]
    assert texts == ["after 2", "after 1", "after 0", "first"]


def test_a_hanging_disk_keeps_few_lines(book: LogStore, monkeypatch: pytest.MonkeyPatch) -> None:
    hanging, whole = threading.Event(), book._file.handle
    monkeypatch.setattr(book._file, "handle", lambda line: hanging.wait() and whole(line))
    for number in range(MOST_WAITING + 101):  # one may be in the hands of the writer
        LOG.info("line %d", number)
    assert book.lost_lines in (100, 101)
    hanging.set()
    written(book, MOST_WAITING)
    (lost,) = book.read("warning", "lines of the log were lost", 10)
    assert str(lost.text).startswith(f"{book.lost_lines} lines")


def test_a_closed_log_leaves_nothing_behind(tmp_path: Path) -> None:
    before = logging.getLogger().handlers[:], threading.active_count()
    opened = LogStore(tmp_path)
    opened.close()
    opened.close()
    assert (logging.getLogger().handlers, threading.active_count()) == before


def test_losses_are_of_the_last_minutes() -> None:
    now_s = 0.0
    window = LossWindow(lambda: now_s)
    assert window.over(0, 0, 0) == Losses(0, 0, 0)
    for second in range(0, 2000, 5):
        now_s = float(second)
        window.note(100 * second, 1000 if second > 300 else 0, 0)
    assert window.over(100 * 1995, 1000, 0).lost == 0, "those were long ago"
    lately = window.over(100 * 1995, 1060, 60)
    assert (lately.lost, lately.corrupt) == (60, 60)
    assert 0.001 < lately.share < 0.01
    assert health.losses("arm", lately).quality == "attention"
    assert health.losses("arm", Losses(100, 5, 0)).quality == "bad"
    assert health.losses("arm", Losses(100_000, 5, 0)).quality == "good"


@pytest.mark.parametrize("state", LinkState)
@pytest.mark.parametrize("silent", [False, True])
@pytest.mark.parametrize("lately", [(900, 0, 0), (99_999, 1, 0), (997, 2, 1), (20_000, 2_265, 0)])
@pytest.mark.parametrize("losing", [False, True])
def test_every_sign_of_a_device_is_that_of_its_state(
    state: LinkState, silent: bool, lately: tuple[int, int, int], losing: bool
) -> None:
    """What *Health* shows is the worst that the other pages show, however much was lost before."""
    link = Link(state, "", 0.1, None, 9**9, 17_663, 7, silent, losing, Losses(*lately))
    shown = device_state("Camera", link, None)
    items = [health.device("sensor", shown), health.losses("sensor", shown.lately, losing)]
    assert shown.quality == min((item.quality for item in items), key=GRAVEST_FIRST.index)
    assert (shown.quality == "good") == (
        state is LinkState.CONNECTED and not silent and not losing and sum(lately[1:]) < 2
    )


def test_losses_are_those_of_the_device_in_use() -> None:
    now_s = 0.0
    window = LossWindow(lambda: now_s)
    window.note(50_000, 0, 0)
    now_s = 2.0
    window.note(100, 3, 0)  # another device was chosen, whose counts begin with 0
    assert window.over(1100, 3, 0) == Losses(1000, 0, 0)


def test_losses_just_now_are_bad_and_the_drivers_remedy_comes_first() -> None:
    said = health.losses("sensor", Losses(100_000, 5, 0), losing=True, remedy="Raise it.")
    assert said.quality == "bad"
    assert str(said.what).startswith("Much of the data from the sensor is being lost")
    assert said.remedy == "Raise it."
    assert health.losses("sensor", Losses(100_000, 5, 0), remedy="Raise it.").remedy == ""


def test_thermometers(tmp_path: Path) -> None:
    file = tmp_path / "temperature"
    file.write_text("21375\n")
    kept: list[float] = []
    watch = TemperatureWatch(FileThermometer(file), kept.append)
    watch.read()
    watch.read()
    assert watch.now == Temperature(21.375)
    assert kept == [21.375]
    file.write_text("85000")
    watch.read()
    assert watch.now.celsius is None
    assert health.temperature(watch.now, None).quality == "attention"
    assert 20 < RoomThermometer().read_c() < 23
    colder = health.temperature(Temperature(-4.0), -2.5)
    assert colder.quality == "attention"
    assert str(colder.what) == "−4.0 °C, −2.5 °C since the calibration."
    assert health.temperature(Temperature(21.0), 0.3).quality == "good"
    nothing = TemperatureWatch(None, kept.append)
    nothing.read()
    assert (nothing.there, nothing.now.celsius) == (False, None)


def test_the_host(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert memory().process > 10_000_000
    assert writable(tmp_path) == ""
    assert list(tmp_path.iterdir()) == []
    assert writable(tmp_path / "none") != ""
    clock = WallClock()
    clock.look()
    assert clock.jumps == 0
    real = time.time
    monkeypatch.setattr(time, "time", lambda: real() + 3600)
    clock.look()
    assert clock.jumps == 1
    assert 3599 < clock.last_jump_s < 3601


def test_the_worst_comes_first_and_is_what_the_station_is() -> None:
    items = [
        storage_health.disk(100.0, None),
        storage_health.disk(0.5, 20.0),
        health.memory_use(Memory(100, 4_000_000_000)),
        storage_health.backup(None, "", False, ""),
    ]
    whole = health.summarise_health(items, "now")
    assert whole.quality == "bad"
    assert [item.quality for item in whole.items] == ["bad", "attention", "good", "good"]
    for item in whole.items:
        assert item.what
        assert item.why
        assert bool(item.remedy) == (item.quality in ("bad", "attention"))
    assert storage_health.backup(1.0, "x", True, "").quality == "attention"
    assert storage_health.backup(1.0, "x", False, "").quality == "good"
    away = OperationError("archive-away", "away", "no route", "check the network")
    for waiting in (0, 1, 2):
        late = storage_health.archive("x", waiting, 0.1, 3, 1, away, 120.0)
        assert (late.quality, str(late.remedy)) == ("attention", "Check the network.")
        assert "2 min" in str(late.what)
        assert storage_health.archive("x", waiting, 0.1, 3, 1, None, 0.0).quality == "good"
    assert health.clock(0, 0.0, 2.0).quality == "bad"
    assert health.clock(1, 9.0, 0.0).quality == "attention"
    assert health.broker("b", False, "refused", "try", 5.0, False).remedy == "try"
    assert health.broker("b", True, "", "", 5.0, True).quality == "bad"


def test_readings_that_cannot_be_true_are_reported_with_a_remedy() -> None:
    assert health.readings(9, 0, None, None).quality == "good"
    none_yet, plausible = (str(health.readings(n, 0, None, None).what) for n in (0, 9))
    assert (none_yet, "plausible" in plausible) == ("No data yet.", True)
    what = "joint J1 reads 1083.0°"
    refusal = OperationError("joint-implausible", what, "why", "check its cable")
    reported = health.readings(9, 3, refusal, 5.0)
    assert reported.quality == "bad"
    assert str(reported.what) == f"Implausible readings: 3, the last 5 s ago: {what}."
    assert str(reported.remedy) == "Check its cable."
    assert health.readings(9, 3, refusal, 3600.0).quality == "attention"
