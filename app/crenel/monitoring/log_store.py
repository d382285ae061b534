"""The log of the station: JSON lines in the data folder, searchable by level and words.

Each line is an object with ``at``, ``level``, ``logger``, ``thread``, ``text`` and, for an
exception, ``trace``. The text is English; for a message, ``text_message`` has its data.
"""

import json
import logging
import logging.handlers
import queue
import sys
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import islice
from pathlib import Path
from typing import Literal

from crenel.errors import OperationError
from crenel.formats.file_names import escape_unprintable
from crenel.formats.open_file import check_ordinary, read_bounded
from crenel.loop_states import waiting
from crenel.loops import Loop
from crenel.messages.catalogue import Render
from crenel.messages.message import Message, Text, join, message, text_to_json
from crenel.messages.stored import restore_text
from crenel.monitoring.log_text import RepeatFilter

FOLDER, FILE = "logs", "station.jsonl"
FILE_BYTES, FILES = 2_000_000, 5
LONGEST_TEXT, LONGEST_TRACE = 1000, 4000
WRITER = "log-writer"
"""Name of the thread."""
MOST_WAITING = 2000
"""Lines that wait for the disk; those beyond are lost, and counted."""
LONGEST_LINE = 10_000
"""Longer lines have their text in English alone."""
STATION_LOGGERS = ("crenel", "crenel_hardware")
"""Loggers that write from ``info`` on; all others write from ``warning`` on."""

Level = Literal["info", "warning", "error"]
LEVELS: dict[Level, int] = {
    "info": logging.INFO,
    "warning": logging.WARNING,
    "error": logging.ERROR,
}


@dataclass(frozen=True, slots=True)
class LogLine:
    """One log line, as the browser shows it."""

    at: str
    level: Level
    logger: str
    thread: str
    text: Text
    trace: str


class LogStore:
    """Writes in its own thread, so that a slow disk does not delay the event loop.

    Args:
        folder: the data folder.

    Raises:
        OperationError: the log folder is not writable.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder / FOLDER
        try:
            self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            self.folder.chmod(0o700)  # they contain names and addresses
            check_ordinary(self.folder / FILE)
            file = _File(
                self.folder / FILE, maxBytes=FILE_BYTES, backupCount=FILES - 1, encoding="utf-8"
            )
        except OSError as error:
            raise OperationError(
                "data-folder-unwritable",
                message("logs-cannot-written", folder=self.folder),
                error.strerror or str(error),
                message("give-folder-user-may-write-data"),
            ) from error
        file.setFormatter(_JsonLine())
        self._errors: deque[float] = deque(maxlen=1000)
        self._lines: queue.Queue[logging.LogRecord | None] = queue.Queue(MOST_WAITING)
        self._handler = _Handler(self._lines)
        self._handler.addFilter(_ErrorCounter(self._errors))
        self._handler.addFilter(RepeatFilter())
        self._file = file
        self._lost_reported = 0
        self._writer = Loop(WRITER, self._write)
        self._writer.start()
        self._levels = {name: logging.getLogger(name).level for name in STATION_LOGGERS}
        for name in STATION_LOGGERS:
            logging.getLogger(name).setLevel(logging.INFO)
        logging.getLogger().addHandler(self._handler)

    def close(self) -> None:
        """Writes waiting lines, and restores the loggers; idempotent."""
        if not self._levels:
            return
        logging.getLogger().removeHandler(self._handler)
        for name, level in self._levels.items():
            logging.getLogger(name).setLevel(level)
        self._levels = {}
        self._writer.stop(None, self._wake)
        while not self._lines.empty():
            self._write()
        self._file.close()

    def _wake(self) -> None:
        with suppress(queue.Full):  # then it waits for none
            self._lines.put_nowait(None)

    @property
    def lost_lines(self) -> int:
        """Lines that came when too many waited for the disk."""
        return self._handler.lost

    def _write(self) -> None:
        """Writes the next line, and how many were lost meanwhile."""
        with waiting():
            record = self._lines.get()
        lost, self._lost_reported = self.lost_lines - self._lost_reported, self.lost_lines
        if lost > 0:
            about = {"name": __name__, "levelno": logging.WARNING, "threadName": WRITER}
            text = message("log-lines-lost", count=lost)
            self._file.handle(logging.makeLogRecord({**about, "msg": text}))
        if record is not None:
            self._file.handle(record)

    def errors_since(self, after: float) -> int:
        """Number of errors that were logged after a time (``time.time``)."""
        return sum(at > after for at in tuple(self._errors))

    def files(self) -> list[Path]:
        """All log files, newest first."""
        numbered = [self.folder / f"{FILE}.{number}" for number in range(1, FILES)]
        return [path for path in (self.folder / FILE, *numbered) if path.is_file()]

    def read(
        self, level: Level, words: str, count: int, render: Render | None = None
    ) -> list[LogLine]:
        """The newest lines of at least this level that contain the words, newest first.

        Args:
            render: renders texts in another language, in which the words are also searched.
        """
        wanted = words.lower().split()
        # most lines are skipped without parsing; these characters are escaped in JSON
        plain = [word for word in wanted if render is None and not set(word) & {'"', "\\"}]
        sought = _SearchWords(wanted, render)
        high = (one for one in self._newest_first(plain) if LEVELS[one.level] >= LEVELS[level])
        return list(islice(filter(sought.is_in, high), count))

    def _newest_first(self, words: list[str]) -> Iterator[LogLine]:
        for path in self.files():
            try:
                raw = read_bounded(path).decode("utf-8", "replace").split("\n")
            except OSError:  # rotated away in the meantime
                continue
            for text in reversed(raw):
                low = text.lower()
                line = _parse_line(text) if all(word in low for word in words) else None
                if line is not None:
                    yield line


class _SearchWords:
    """The search words in lower case."""

    def __init__(self, words: Sequence[str], render: Render | None) -> None:
        self._words, self._render = words, render

    def is_in(self, line: LogLine) -> bool:
        """Whether a line contains all of them, in English or in the other language."""
        english = f"{line.text!s} {line.logger} {line.thread} {line.trace}".lower()
        missing = [word for word in self._words if word not in english]
        if not missing or self._render is None or isinstance(line.text, str):
            return not missing
        translated = self._render(line.text).lower()
        return all(word in translated for word in missing)


class _ErrorCounter(logging.Filter):
    """Counts errors as they are logged."""

    def __init__(self, errors: deque[float]) -> None:
        super().__init__()
        self._error_times = errors

    def filter(self, record: logging.LogRecord) -> bool:
        if record.levelno >= logging.ERROR:
            self._error_times.append(record.created)
        return True


class _Handler(logging.handlers.QueueHandler):
    """Converts the traceback to text at once; loses a line if too many wait, but never waits."""

    lost = 0

    def enqueue(self, record: logging.LogRecord) -> None:
        try:
            self.queue.put_nowait(record)
        except queue.Full:
            self.lost += 1

    def prepare(self, record: logging.LogRecord) -> logging.LogRecord:
        trace = str(getattr(record, "trace", ""))
        if record.exc_info:
            trace = logging.Formatter().formatException(record.exc_info)
        text: Text = record.getMessage()[:LONGEST_TEXT]
        if isinstance(record.msg, Message) and not record.args:
            text = record.msg
        if repeated := getattr(record, "repeated", None):
            text = join([text, repeated], " ")
        plain = logging.makeLogRecord(record.__dict__)
        plain.msg, plain.args = text, None
        plain.exc_info, plain.exc_text, plain.stack_info = None, trace or None, None
        return plain


class _File(logging.handlers.RotatingFileHandler):
    """Reports once that the disk accepts no lines, until it does again."""

    failing = False

    def emit(self, record: logging.LogRecord) -> None:
        failed, self.failing = self.failing, False
        super().emit(record)
        if self.failing and not failed:
            print(str(message("log-cannot-written-health-page-says")), file=sys.stderr)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - of an interface by others
        self.failing = True


class _JsonLine(logging.Formatter):
    def format(self, record: logging.LogRecord) -> str:
        at = datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds")
        line: dict[str, object] = {
            "at": at.replace("+00:00", "Z"),
            "level": _level(record.levelno),
            "logger": record.name,
            "thread": record.threadName or "",
            "text": escape_unprintable(str(record.msg)[:LONGEST_TEXT], "\n\t"),
        }
        if record.exc_text:
            line["trace"] = escape_unprintable(record.exc_text[-LONGEST_TRACE:], "\n\t")
        if not isinstance(record.msg, str):
            data = _escape_texts(text_to_json(record.msg))
            whole = json.dumps({**line, "text_message": data}, ensure_ascii=False)
            if len(whole) <= LONGEST_LINE:
                return whole
        return json.dumps(line, ensure_ascii=False)


def _escape_texts(data: object) -> object:
    """The data of a message without characters that affect the display of its texts."""
    if isinstance(data, str):
        return escape_unprintable(data, "\n\t")
    if isinstance(data, dict):
        return {name: _escape_texts(value) for name, value in data.items()}
    if isinstance(data, list):
        return [_escape_texts(value) for value in data]
    return data


def _level(number: int) -> Level:
    if number >= logging.ERROR:
        return "error"
    return "warning" if number >= logging.WARNING else "info"


def _parse_line(text: str) -> LogLine | None:
    """A log line; None for one that a killed server wrote only partly."""
    try:
        line = json.loads(text)
        english = str(line["text"])
        return LogLine(
            at=str(line["at"]),
            level=line["level"] if line["level"] in LEVELS else "info",
            logger=str(line["logger"]),
            thread=str(line["thread"]),
            text=restore_text(english, line["text_message"]) if "text_message" in line else english,
            trace=str(line.get("trace", "")),
        )
    except (ValueError, KeyError, TypeError, AttributeError):
        return None
