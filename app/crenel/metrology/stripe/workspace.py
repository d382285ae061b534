"""The memory for stripe extraction: reused, because allocating it again takes time."""

import ctypes
import math
from collections import deque
from typing import Any

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe.settings import CHOICES, StripeSettings
from crenel.native.arguments import BOOL, F32, I64, Array, Function, Integer, pointer
from crenel.native.library import CRENEL

ALIGNED_BYTES = 64
MOST_SIZES, MOST_WORKSPACES = 12, 16
PER_FULL_WIDTH = 1 / 2.3548
"""Standard deviation of a Gaussian whose width at half height is one."""
# As in workspace.h, search.c and read_noise.c.
STRIP_ROWS, RING_ROWS, GREYS, BLOCK = 16, 16, 64, 64
BLOCK_ROWS, PROFILE_ROWS, FIT_ROWS, PEAK_ROWS = 26, 112, 8, 5
NOISE_BLOCKS, COUNT_LISTS, COUNT_LEVELS = 2, 4, 4096
PIECE_BYTES = 32
LEAST_ROWS = 20
"""Fewer rows cannot contain a core with its surroundings."""
PARTS = Array(I64, "parts", 4)
ALLOWED = Array(BOOL, "height", "width")
KNOWN = Array(F32, 4, written=True)

_clipped_bytes = Function(CRENEL, "clipped_bytes", Integer(), returns=int)

PixelType = np.dtype[np.uint8] | np.dtype[np.uint16]
Key = tuple[tuple[int, int], PixelType]


class Fields(ctypes.Structure):
    """``Workspace`` of ``app/crenel/native/c/stripe/workspace.h``."""

    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("pixels",)),
        *((name, ctypes.c_int64) for name in ("height", "width")),
        *((name, ctypes.c_void_p) for name in ("allowed", "parts")),
        *((name, ctypes.c_int64) for name in ("part_count", "rule", "shortest_run")),
        *((name, ctypes.c_double) for name in ("threshold", "narrowest_px", "widest_px", "climb")),
        ("known", ctypes.c_void_p),
        *((name, ctypes.c_int64) for name in ("padded", "strips", "most_peaks")),
        *((name, ctypes.c_void_p) for name in ("ring", "score", "place")),
        *((name, ctypes.c_void_p) for name in ("peak_columns", "peak_rows", "peak_heights")),
        *((name, ctypes.c_void_p) for name in ("track", "track_order", "reached", "track_count")),
        *((name, ctypes.c_void_p) for name in ("track_total", "worth")),
        *((name, ctypes.c_void_p) for name in ("best", "second", "begin", "columns", "rows")),
        ("counts", ctypes.c_void_p),
        ("count_levels", ctypes.c_int64),
        *((name, ctypes.c_void_p) for name in ("blocks", "profiles", "fits", "peaks")),
        *((name, ctypes.c_void_p) for name in ("points", "scratch", "pieces", "clutter", "levels")),
        ("clipped", ctypes.c_void_p),
        *((name, ctypes.c_double) for name in ("evidence", "length", "saturated")),
        *((name, ctypes.c_double) for name in ("core_rows", "half_fall")),
        *((name, ctypes.c_int64) for name in ("is_clipped", "flanks", "decision", "left")),
    )


class Workspace:
    """The memory for frames of one size and type; for one thread at a time."""

    def __init__(self, key: Key) -> None:
        (height, width), kind = key
        self.key = key
        padded = -(-width // GREYS) * GREYS
        strips = -(-height // STRIP_ROWS) + 2
        most_peaks = strips * width // 2
        levels = min(COUNT_LEVELS, int(np.iinfo(kind).max) + 1)
        self.points = np.zeros((4, width))
        self.fields = Fields(
            height=height,
            width=width,
            padded=padded,
            strips=strips,
            most_peaks=most_peaks,
            count_levels=levels,
        )
        self._memory: dict[str, NDArray[np.uint8]] = {}
        self._reduced: NDArray[np.uint16] | None = None
        self._image = Array(kind, height, width)
        self._give("ring", (RING_ROWS, padded), kind)
        self._give("score", (strips, padded), kind)
        self._give("place", (strips, padded), np.uint8)
        for name in ("peak_columns", "peak_rows", "peak_heights"):
            self._give(name, (most_peaks,), np.int32)
        for name in ("track", "track_order", "reached", "track_count"):
            self._give(name, (most_peaks,), np.int32)
        for name in ("track_total", "worth"):
            self._give(name, (most_peaks,), np.float64)
        for name in ("best", "second", "columns", "rows"):
            self._give(name, (width,), np.int32)
        self._give("begin", (width + 1,), np.int32)
        self._give("counts", (COUNT_LISTS, levels), np.int32)
        self._give("blocks", (NOISE_BLOCKS, BLOCK_ROWS, BLOCK), np.float32)
        self._give("profiles", (NOISE_BLOCKS, PROFILE_ROWS, BLOCK), np.float32)
        self._give("fits", (FIT_ROWS, padded), np.float32)
        self._give("peaks", (PEAK_ROWS, width), np.float64)
        self._give("scratch", (2, width), np.float64)
        self._give("pieces", (width, PIECE_BYTES), np.uint8)
        self._give("clutter", (width,), np.float32)
        self._give("levels", (padded,), np.float32)
        self._give("clipped", (_clipped_bytes(width),), np.uint8)
        self.fields.points = self.points.ctypes.data

    @property
    def reduced(self) -> NDArray[np.uint16]:
        """Memory for an image of 16 bits that is made of another one."""
        if self._reduced is None:
            self._reduced = np.empty(self.key[0], dtype=np.uint16)
        return self._reduced

    def set_frame(
        self,
        grey: Image,
        parts: NDArray[np.int64],
        where: NDArray[np.bool_] | None,
        known: NDArray[np.float32],
    ) -> None:
        """Sets the pointers to a frame: the parts to read, where a peak may lie, and what is known.

        The arrays must be kept alive while the frame is processed.
        """
        fields = self.fields
        fields.pixels = pointer(grey, self._image)
        fields.parts, fields.part_count = pointer(parts, PARTS), len(parts)
        fields.allowed = None if where is None else pointer(where, ALLOWED)
        fields.known = pointer(known, KNOWN)

    def set_settings(self, settings: StripeSettings, climb_rows: float) -> None:
        """Sets the operator's settings, which have been checked, and by how many rows a line may
        climb from one column to the next."""
        fields = self.fields
        fields.climb = climb_rows
        fields.rule, fields.shortest_run = CHOICES.index(settings.choice), settings.min_run
        fields.threshold = math.nan if settings.threshold is None else settings.threshold
        fields.narrowest_px = _sigma(settings.min_width_px)
        fields.widest_px = _sigma(settings.max_width_px)

    def _give(self, name: str, shape: tuple[int, ...], kind: Any) -> None:
        """Allocates zeros for a field, aligned to a cache line, so that no vector crosses two
        lines."""
        size = math.prod(shape) * np.dtype(kind).itemsize
        raw = np.zeros(size + ALIGNED_BYTES, np.uint8)
        begin = -raw.ctypes.data % ALIGNED_BYTES
        self._memory[name] = raw[begin : begin + size].reshape(*shape[:-1], -1)
        setattr(self.fields, name, raw.ctypes.data + begin)

    def view(self, name: str, kind: type[np.generic]) -> NDArray[Any]:
        """The memory of a field as an array of its own type."""
        return self._memory[name].view(kind)


def _sigma(width_px: float | None) -> float:
    """The standard deviation of a width at half height, NaN for None."""
    return math.nan if width_px is None else width_px * PER_FULL_WIDTH


# Unused workspaces by image size and type: taking one from a deque and putting it back are atomic.
_free: dict[Key, deque[Workspace]] = {}


def acquire_workspace(rows: int, columns: int, kind: PixelType) -> Workspace:
    """A workspace for such images, reserved for the caller until it is returned."""
    key: Key = ((rows, columns), kind)
    try:
        return _free[key].pop()
    except (KeyError, IndexError):
        return Workspace(key)


def release_workspace(workspace: Workspace) -> None:
    """Stores a workspace for the next caller; workspaces of other sizes are dropped if there are
    many."""
    if workspace.key not in _free:
        if len(_free) >= MOST_SIZES:
            _free.clear()
        _free[workspace.key] = deque(maxlen=MOST_WORKSPACES)
    kept = _free.get(workspace.key)
    if kept is not None:
        kept.append(workspace)
