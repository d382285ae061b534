"""Limits on the content and number of log records, because clients without an account can cause
them.

Whatever they send is written so that it is visible and has no effect: control characters are
commands to a terminal, and some Unicode characters are line ends for readers.
"""

import logging
import re
import threading
import time
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass

from crenel.messages.message import message

FIRST = 3
"""Number of equal lines that are written before they are only counted."""
FORGOTTEN_S = 600.0
MOST_KINDS, MOST_ALIKE = 500, 20
NUMBER = re.compile(r"\d+")
LONGEST_KIND = 80


_Key = tuple[str, int, str]
"""The file and line that logs it, and the text."""


@dataclass
class _RepeatCount:
    count: int
    began: float
    last_s: float
    written_s: float


class RepeatFilter(logging.Filter):
    """Lets warnings and errors of one kind pass three times; then the tenth, the hundredth, the
    thousandth and so on, and one every ten minutes, which state the number.

    Errors raised at one place, and equal texts, are of one kind; of differing texts from one line
    of the program, the first twenty are separate kinds. The number is the record's ``repeated``.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        super().__init__()
        self._clock = clock
        self._lock = threading.Lock()
        self._kinds: OrderedDict[_Key, _RepeatCount] = OrderedDict()

    def filter(self, record: logging.LogRecord) -> bool:
        record.repeated = None
        if record.levelno < logging.WARNING:
            return True
        with self._lock:
            key = _kind(record)
            if key not in self._kinds and self._alike(key) >= MOST_ALIKE:
                key = (*key[:2], "")
            kind = self._count(key, record.created)
            count, late = kind.count, self._clock() - kind.written_s > FORGOTTEN_S
            if count > FIRST and not late and not _is_power_of_ten(count):
                return False
            kind.written_s = self._clock()
        if count > FIRST:
            since = time.strftime("%H:%M:%S", time.localtime(kind.began))
            record.repeated = message("log-repeated", count=count, since=since)
        return True

    def _alike(self, key: _Key) -> int:
        """Number of kinds of one program line that are remembered."""
        soon_s = self._clock() - FORGOTTEN_S
        return sum(
            known[:2] == key[:2] and kind.last_s > soon_s for known, kind in self._kinds.items()
        )

    def _count(self, key: _Key, now: float) -> _RepeatCount:
        known, now_s = self._kinds.pop(key, None), self._clock()
        if known is None or now_s - known.last_s > FORGOTTEN_S:
            known = _RepeatCount(0, now, now_s, now_s)
        known.count, known.last_s = known.count + 1, now_s
        self._kinds[key] = known
        while len(self._kinds) > MOST_KINDS:
            self._kinds.popitem(last=False)
        return known


def _is_power_of_ten(count: int) -> bool:
    return str(count) == f"1{'0' * (len(str(count)) - 1)}"


def _kind(record: logging.LogRecord) -> _Key:
    words = NUMBER.sub("#", record.getMessage())[:LONGEST_KIND]
    if record.exc_info and record.exc_info[0] is not None:
        words, at = record.exc_info[0].__name__, record.exc_info[2]
        while at is not None and at.tb_next is not None:
            at = at.tb_next
        words += str(at.tb_lineno if at else 0)
    return record.pathname, record.lineno, words
