"""The blocks of a recording, with the arm's readings in the order of time.

What Crenel records is in this order. Another program may write one topic after the other, merge
files, or write from several threads. The readings of such a file are then read first, all of them:
they take 8 bytes a number. Frames follow as the file has them, in memory a few blocks at a time.
"""

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import replace

import numpy as np

from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.formats.recording import wire_format as wire
from crenel.formats.recording.blocks import ChunkRecords
from crenel.formats.recording.index import is_in_order, read_index
from crenel.formats.recording.reader import Recording, is_written_here, open_recording
from crenel.formats.recording.stream import Block, ReadingSamples, read_file_blocks


def read_blocks(
    recording: Recording, pool: Executor, ahead: int, all_pictures: bool = True
) -> Iterator[Block]:
    """The blocks of a recording; ``ahead`` of them are opened in advance.

    Args:
        all_pictures: False: those of frames whose stripes were recorded are passed over unread,
            where the recording has its index.

    A file that is truncated or damaged ends at that position, which ``recording.cut`` then states.

    Raises:
        OperationError: as ``Recording.records``.
    """
    with convert_io_errors(recording.path), open_file(recording.path) as file:
        recording.written_here = is_written_here(recording.path, file)
        ordered = recording.written_here or is_in_order(file, read_index(file))
    blocks = read_file_blocks(recording, pool, ahead, all_pictures)
    if ordered:
        yield from blocks
        return
    first_pass = read_file_blocks(open_recording(recording.path), pool, ahead, all_pictures)
    samples = [one for block in first_pass for one in block.readings]
    nothing = ChunkRecords(b"", np.zeros((0, 5), np.int64))
    stripes = np.zeros((0, wire.STRIPE_COLUMNS), np.int64)
    yield Block(nothing, sort_samples(samples), [], stripes)
    for block in blocks:
        frames = sorted(block.frames, key=lambda frame: (frame.log_ns, frame.stamp_ns))
        yield replace(block, readings=[], frames=frames)


def sort_samples(samples: Sequence[ReadingSamples]) -> list[ReadingSamples]:
    """Readings by the time at which they were logged, then by their stamps; together are those of
    the same joints, in the order in which these were named first."""
    together: dict[tuple[str, tuple[str, ...]], list[ReadingSamples]] = {}
    for one in samples:
        together.setdefault((one.kind, tuple(sorted(one.names))), []).append(one)
    return [_join_samples(group) for group in together.values()]


def _join_samples(group: Sequence[ReadingSamples]) -> ReadingSamples:
    first = group[0]
    in_order = [
        one.readings
        if one.names == first.names
        else one.readings[:, [one.names.index(name) for name in first.names]]
        for one in group
    ]
    stamps_ns = np.concatenate([one.stamps_ns for one in group])
    log_ns = np.concatenate([one.log_ns for one in group])
    order = np.lexsort((stamps_ns, log_ns))
    readings = np.concatenate(in_order)[order]
    return ReadingSamples(first.kind, first.names, stamps_ns[order], log_ns[order], readings)
