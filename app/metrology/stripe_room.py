"""The memory in which stripes are extracted: kept, since fetching it anew costs time."""

from collections import deque
from typing import TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from app.metrology.grey_lanes import Grey
from app.metrology.stripe_block import BLOCK_ROWS, LANES, PROFILE_ROWS
from app.metrology.stripe_fit import FIT_ROWS
from app.metrology.stripe_noise import BLOCKS, LEVELS, LISTS
from app.metrology.stripe_search import PADDING, RING, STRIP_ROWS

ALIGNED_BYTES = 64
SIZES_KEPT, ROOMS_KEPT = 4, 16
Key = tuple[tuple[int, int], np.dtype[np.uint8] | np.dtype[np.uint16]]
Kind = TypeVar("Kind", bound=np.generic)


class Room:
    """What the kernels work in, for images of one size and type; one thread at a time."""

    def __init__(self, key: Key) -> None:
        (height, width), kind = key
        strips, padded = -(-height // STRIP_ROWS) + 2, -(-width // PADDING) * PADDING
        pixels = PROFILE_ROWS * LANES
        self.key = key
        grey = kind.type
        self.ring = cast(Grey, _aligned((RING + 2, padded), grey))
        self.score = cast(Grey, _aligned((strips, padded), grey))
        self.at = _aligned((strips, padded), np.uint8)
        self.places = np.zeros((3, strips * width // 2), np.int32)
        self.chosen = np.zeros((2, width), np.int32)
        self.raw = cast(Grey, _aligned((pixels,), grey))
        self.blocks = _aligned((BLOCKS, BLOCK_ROWS * LANES), np.float32)
        self.profiles = _aligned((BLOCKS, pixels), np.float32)
        self.fits = _aligned((FIT_ROWS, padded), np.float32)
        self.peaks = np.zeros((5, width))
        self.counts = np.zeros((LISTS, min(LEVELS, np.iinfo(kind).max + 1)), np.int32)


# Rooms that nobody works in, by images' size and type: taking one from a deque and putting
# it back are each one step for every thread.
_free: dict[Key, deque[Room]] = {}


def take_room(image: Grey) -> Room:
    """A room for images like this one that is the caller's alone until it is given back."""
    key = ((image.shape[0], image.shape[1]), image.dtype)
    try:
        return _free[key].pop()
    except (KeyError, IndexError):
        return Room(key)


def give_back(room: Room) -> None:
    """Keeps a room for the next who needs one; those of other sizes go when they are many."""
    if room.key not in _free:
        if len(_free) >= SIZES_KEPT:
            _free.clear()
        _free[room.key] = deque(maxlen=ROOMS_KEPT)
    kept = _free.get(room.key)
    if kept is not None:
        kept.append(room)


def _aligned(shape: tuple[int, ...], kind: type[Kind]) -> NDArray[Kind]:
    """Zeros that begin on a line of the caches, so that no vector lies across two."""
    size = int(np.prod(shape)) * np.dtype(kind).itemsize
    raw = np.zeros(size + ALIGNED_BYTES, np.uint8)
    begin = -raw.ctypes.data % ALIGNED_BYTES
    return raw[begin : begin + size].view(kind).reshape(shape)
