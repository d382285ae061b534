"""A worker's copy of a recording in a store, without the pictures that a cloud does not need.

The index at the end of the recording says where its pictures are. They stay holes in the copy,
which readers pass over by the same index.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import BinaryIO

from mcap.records import Chunk

from crenel.archive.remote_store import RemoteStore, Span
from crenel.formats.recording.blocks import open_chunk
from crenel.formats.recording.index import (
    END_BYTES,
    Spans,
    find_needless_pictures,
    read_index,
    summary_start,
)
from crenel.formats.recording.raw import DAMAGE, MAGIC, raw_records

AT_ONCE_BYTES = 64 << 20
"""Fetched together: so much is in memory."""
LONGEST_BYTES = 8 << 20
"""The longest part that one request reads."""


def copy_without_pictures(
    store: RemoteStore, name: str, size: int, target: Path, note: Callable[[int], None]
) -> bool:
    """Copies a recording, checked by the sums of its index and of its chunks.

    Args:
        size: of the recording.
        target: a new file.
        note: called with the bytes that came.

    Returns:
        False, with nothing written, if it has no index or no pictures of their own, or if a sum
        differs: then it is to be copied as a whole, and compared by its hash.

    Raises:
        StoreError: the store cannot be reached.
    """
    (end,) = store.read_spans(name, [(max(size - END_BYTES, 0), size)])
    start = summary_start(end)
    if start is None or not start < size:
        return False
    with open(target, "x+b") as file:
        file.truncate(size)
        copy = _Copy(store, name, file, note)
        copy.fetch([(start, size)])
        index = read_index(file)
        if index is not None and index.pictures:
            copy.fetch(_between(index.picture_spans, start))
            needless = find_needless_pictures(file, index)
            missing = {at: n for at, n in index.picture_spans.items() if at not in needless}
            copy.fetch((at, at + length) for at, length in missing.items())
            if _is_whole(file, needless):
                return True
    target.unlink()
    return False


class _Copy:
    """A file that is filled in parts."""

    def __init__(
        self, store: RemoteStore, name: str, file: BinaryIO, note: Callable[[int], None]
    ) -> None:
        self._store, self._name, self._file, self._note = store, name, file, note

    def fetch(self, spans: Iterable[Span]) -> None:
        for group in _groups(spans):
            for (begin, _), part in zip(
                group, self._store.read_spans(self._name, group), strict=True
            ):
                self._note(len(part))
                self._file.seek(begin)
                self._file.write(part)


def _groups(spans: Iterable[Span]) -> Iterator[Sequence[Span]]:
    """Parts of at most ``LONGEST_BYTES``, together at most ``AT_ONCE_BYTES``."""
    group: list[Span] = []
    waiting = 0
    for begin, end in spans:
        for at in range(begin, end, LONGEST_BYTES):
            piece = at, min(at + LONGEST_BYTES, end)
            if waiting + piece[1] - piece[0] > AT_ONCE_BYTES:
                yield group
                group, waiting = [], 0
            group.append(piece)
            waiting += piece[1] - piece[0]
    if group:
        yield group


def _between(left_out: Spans, end: int) -> Iterator[Span]:
    """What is not left out, up to ``end``."""
    at = 0
    for begin, length in sorted(left_out.items()):
        if begin > at:
            yield at, begin
        at = max(at, begin + length)
    if end > at:
        yield at, end


def _is_whole(file: BinaryIO, skipped: Spans) -> bool:
    """Whether each chunk has its sum."""
    file.seek(len(MAGIC))
    try:
        for record in raw_records(file, skipped=skipped):
            if isinstance(record, Chunk):
                open_chunk(record)
                if not record.uncompressed_crc:
                    return False
    except DAMAGE:
        return False
    return True
