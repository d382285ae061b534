"""What strangers cause in a log: nothing that acts, and few lines."""

import json
import logging
from pathlib import Path

import pytest

from crenel.formats.file_names import escape_unprintable
from crenel.monitoring.log_store import FILE, LogStore
from crenel.monitoring.log_text import FIRST, FORGOTTEN_S, RepeatFilter
from crenel.server.listener import OneLineFormatter
from tests.clocks import Clock

pytestmark = pytest.mark.slow

HOSTILE = "\x1b[31m red \x00\x7f\x9b\u2028 next \u202e back \ud800 end"


def record(text: str, *args: object, level: int = logging.ERROR) -> logging.LogRecord:
    return logging.LogRecord("crenel.test", level, "file.py", 1, text, args, None)


def test_what_acts_on_terminals_and_readers_is_written_as_numbers() -> None:
    reported = escape_unprintable(HOSTILE)
    assert reported.isprintable()
    assert "\\x1b[31m red" in reported
    assert "\\u2028" in reported
    assert "\\ud800" in reported
    assert escape_unprintable("µm ″ Prüfkörper") == "µm ″ Prüfkörper"
    assert escape_unprintable("a\nb", "\n") == "a\nb"


def test_the_log_and_the_console_have_hostile_lines_harmless(tmp_path: Path) -> None:
    book = LogStore(tmp_path)
    logging.getLogger("crenel.test").error("before")
    # pytest's own workers cannot pass on a lone surrogate that was logged
    encodable = HOSTILE.replace("\ud800", "")
    logging.getLogger("crenel.test").error("GET %s failed", encodable + "x" * 10_000)
    logging.getLogger("crenel.test").error("after")
    book.close()
    begun = [str(line.text)[:6] for line in book.read("error", "", 10)]
    assert begun == ["after", "GET \\x", "before"]
    raw = (book.folder / FILE).read_text("utf-8")
    assert all(sign.isprintable() or sign == "\n" for sign in raw)
    assert len(raw) < 3000
    line = OneLineFormatter("%(message)s").format(record("GET %s failed", HOSTILE + "x" * 10_000))
    assert line.isprintable()
    assert len(line) < 600


def test_equal_errors_are_counted_instead_of_repeated() -> None:
    clock = Clock()
    repeats = RepeatFilter(clock)
    passed = []
    for _ in range(1000):
        one = record("the request failed")
        if repeats.filter(one):
            passed.append(one.repeated)  # type: ignore[attr-defined]
    assert passed[:FIRST] == [None] * FIRST
    assert str(passed[-1]).startswith("(1000 of these since ")
    assert len(passed) == FIRST + 3  # the 10th, 100th and 1000th
    other = record("something else")
    assert repeats.filter(other)
    clock.now_s += FORGOTTEN_S + 1
    again = record("the request failed")
    assert repeats.filter(again)
    assert again.repeated is None  # type: ignore[attr-defined]


def test_one_line_in_ever_other_words_is_counted_too() -> None:
    repeats = RepeatFilter(Clock())
    paths = [chr(0x4E00 + number) for number in range(5000)]
    assert sum(repeats.filter(record("GET /%s failed", path)) for path in paths) < 30


def test_an_hour_of_a_flood_is_a_few_lines() -> None:
    clock = Clock()
    repeats, written = RepeatFilter(clock), 0
    for number in range(3600 * 20):
        clock.now_s += 0.05
        words = f"GET /{chr(0x4E00 + number % 200)} failed"
        written += repeats.filter(record(words, level=logging.WARNING))
    assert written < 400


def test_what_is_said_of_normal_work_is_not_counted() -> None:
    repeats = RepeatFilter(Clock())
    assert all(repeats.filter(record("point %d", n, level=logging.INFO)) for n in range(100))


def test_a_flood_hides_no_logged_fault(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.CRITICAL)
    book, log = LogStore(tmp_path), logging.getLogger("crenel.test")
    log.setLevel(logging.INFO)
    log.error("the camera is gone")
    for number in range(5_000):
        try:
            raise ValueError(number)
        except ValueError:
            log.exception("GET /%s failed", "a" * 5000)
    book.close()
    assert book.read("error", "camera", 10)[0].text == "the camera is gone"
    assert sum(file.stat().st_size for file in book.files()) < 200_000
    assert "of these since" in json.dumps([str(line.text) for line in book.read("error", "", 5)])
