"""The station's log: JSON lines in the data folder, and read again by level and words.

Each line is an object with ``at``, ``level``, ``logger``, ``thread``, ``text`` and, of a
failure, ``trace``.
"""

import json
import logging
import logging.handlers
import queue
import sys
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import islice
from pathlib import Path
from typing import Literal

from app.errors import OperationError
from app.formats.file_names import escape_unprintable
from app.formats.open_file import check_ordinary, read_bounded
from app.monitoring.log_text import NUMBER, RepeatFilter

FOLDER, FILE = "logs", "station.jsonl"
FILE_BYTES, FILES = 2_000_000, 5
LONGEST_TEXT, LONGEST_TRACE = 1000, 4000
STATION_LOGGERS = ("app", "hardware")
"""Loggers that are heard from ``info`` on; all others from ``warning`` on."""

MAX_TRANSLATED = 1000
"""Sentences of a log that are put into another language for one search of it."""

Translate = Callable[[str], str]
Level = Literal["info", "warning", "error"]
LEVELS: dict[Level, int] = {
    "info": logging.INFO,
    "warning": logging.WARNING,
    "error": logging.ERROR,
}


@dataclass(frozen=True, slots=True)
class LogLine:
    """One line, as the browser shows it."""

    at: str
    level: Level
    logger: str
    thread: str
    text: str
    trace: str


class LogStore:
    """Writes on a thread of its own, so that no disk holds up the event loop.

    Args:
        folder: the data folder.

    Raises:
        Refusal: the folder of the logs cannot be written.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder / FOLDER
        try:
            self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            self.folder.chmod(0o700)  # names and addresses are in them
            check_ordinary(self.folder / FILE)
            file = _File(
                self.folder / FILE, maxBytes=FILE_BYTES, backupCount=FILES - 1, encoding="utf-8"
            )
        except OSError as error:
            raise OperationError(
                "data-folder-unwritable",
                f"The logs in {self.folder} cannot be written",
                error.strerror or str(error),
                "Give a folder that this user may write with --data",
            ) from error
        file.setFormatter(_JsonLine())
        self._errors: deque[float] = deque(maxlen=1000)
        lines: queue.SimpleQueue[logging.LogRecord] = queue.SimpleQueue()
        self._handler = _Handler(lines)
        self._handler.addFilter(_ErrorCounter(self._errors))
        self._handler.addFilter(RepeatFilter())
        self._file = file
        self._listener = logging.handlers.QueueListener(lines, file)
        self._listener.start()
        self._levels = {name: logging.getLogger(name).level for name in STATION_LOGGERS}
        for name in STATION_LOGGERS:
            logging.getLogger(name).setLevel(logging.INFO)
        logging.getLogger().addHandler(self._handler)

    def close(self) -> None:
        """Writes what waits, and gives the loggers back as they were; idempotent."""
        if not self._levels:
            return
        logging.getLogger().removeHandler(self._handler)
        for name, level in self._levels.items():
            logging.getLogger(name).setLevel(level)
        self._levels = {}
        self._listener.stop()
        self._file.close()

    def errors_since(self, after: float) -> int:
        """How many errors were logged after a moment (``time.time``)."""
        return sum(at > after for at in tuple(self._errors))

    def files(self) -> list[Path]:
        """All files of the log, the newest first."""
        numbered = [self.folder / f"{FILE}.{number}" for number in range(1, FILES)]
        return [path for path in (self.folder / FILE, *numbered) if path.is_file()]

    def read(
        self, level: Level, words: str, count: int, say: Translate | None = None
    ) -> list[LogLine]:
        """The newest lines of a level or above that contain the words, newest first.

        Args:
            say: what is written into another language; the words may be of that, too.
        """
        wanted = words.lower().split()
        # most lines are passed over without being parsed; these signs are spelled otherwise in JSON
        plain = [word for word in wanted if say is None and not set(word) & {'"', "\\"}]
        sought = _SearchWords(wanted, say)
        high = (one for one in self._newest_first(plain) if LEVELS[one.level] >= LEVELS[level])
        return list(islice(filter(sought.is_in, high), count))

    def _newest_first(self, words: list[str]) -> Iterator[LogLine]:
        for path in self.files():
            try:
                raw = read_bounded(path).decode("utf-8", "replace").split("\n")
            except OSError:  # rotated away meanwhile
                continue
            for text in reversed(raw):
                low = text.lower()
                line = _parse_line(text) if all(word in low for word in words) else None
                if line is not None:
                    yield line


class _SearchWords:
    """Words, in small letters, that lines are sought by."""

    def __init__(self, words: Sequence[str], say: Translate | None) -> None:
        self._words, self._translator = words, say
        self._translations: dict[str, str] = {}

    def is_in(self, line: LogLine) -> bool:
        """Whether all of them stand in a line, as it was written or as it is said."""
        hay = f"{line.text} {line.logger} {line.thread} {line.trace}".lower()
        missing = [word for word in self._words if word not in hay]
        if not missing or self._translator is None:
            return not missing
        said = self._translate(line.text, self._translator)
        return all(word in said for word in missing)

    def _translate(self, text: str, say: Translate) -> str:
        """Lines that differ in their numbers only are put into the language once."""
        alike = NUMBER.sub("#", text)
        if alike not in self._translations and len(self._translations) < MAX_TRANSLATED:
            self._translations[alike] = say(alike).lower()
        return self._translations.get(alike, "")


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
    """Makes the trace into text at once."""

    def prepare(self, record: logging.LogRecord) -> logging.LogRecord:
        trace = str(getattr(record, "trace", ""))
        if record.exc_info:
            trace = logging.Formatter().formatException(record.exc_info)
        plain = logging.makeLogRecord(record.__dict__)
        plain.msg = record.getMessage()[:LONGEST_TEXT] + getattr(record, "repeated", "")
        plain.args = None
        plain.exc_info, plain.exc_text, plain.stack_info = None, trace or None, None
        return plain


class _File(logging.handlers.RotatingFileHandler):
    """Says once that the disk takes no lines, until it does again."""

    failing = False

    def emit(self, record: logging.LogRecord) -> None:
        failed, self.failing = self.failing, False
        super().emit(record)
        if self.failing and not failed:
            print("The log cannot be written; the Health page says more.", file=sys.stderr)

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 - of an interface by others
        self.failing = True


class _JsonLine(logging.Formatter):
    def format(self, record: logging.LogRecord) -> str:
        at = datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds")
        line = {
            "at": at.replace("+00:00", "Z"),
            "level": _level(record.levelno),
            "logger": record.name,
            "thread": record.threadName or "",
            "text": escape_unprintable(str(record.msg), "\n\t"),
        }
        if record.exc_text:
            line["trace"] = escape_unprintable(record.exc_text[-LONGEST_TRACE:], "\n\t")
        return json.dumps(line, ensure_ascii=False)


def _level(number: int) -> Level:
    if number >= logging.ERROR:
        return "error"
    return "warning" if number >= logging.WARNING else "info"


def _parse_line(text: str) -> LogLine | None:
    """A line; None for one that a killed server left half."""
    try:
        line = json.loads(text)
        return LogLine(
            at=str(line["at"]),
            level=line["level"] if line["level"] in LEVELS else "info",
            logger=str(line["logger"]),
            thread=str(line["thread"]),
            text=str(line["text"]),
            trace=str(line.get("trace", "")),
        )
    except (ValueError, KeyError, TypeError, AttributeError):
        return None
