"""Unwraps the numbers that a camera gives its pictures."""

_WRAP = 0xFFFF
"""GigE Vision 1 counts from 1 to 65535 and then from 1 again: 0 is not a picture."""
_LATE = 0x7FFF


class BlockCounter:
    """Counts a camera's pictures from the block ids in its stream, lost ones included.

    Block ids have 16 bits in GigE Vision 1, and 64 bits in GigE Vision 2 and USB3 Vision. The
    width is not announced here: an id above 65535 shows that it is 64.

    Source:
        AIA, GigE Vision 2.0, sections 24.2 (block_id) and 24.3 (block_id64).
    """

    def __init__(self) -> None:
        self._last: int | None = None
        self._count = 0
        self._long = False

    def count(self, block_id: int, whole: bool = True) -> int | None:
        """The number of a picture, from 0 at the first one; None of a repeated or late one.

        An incomplete picture may have the id 0, which says that its id did not arrive; it has no
        number, either. Its place in the count shows by the next one.
        A 64-bit id that falls back means that the camera began to count again: its picture is the
        next one.
        """
        if block_id == 0 and not whole:
            return None
        self._long |= block_id > _WRAP
        last, self._last = self._last, block_id
        if last is None:
            return self._count
        step = block_id - last if self._long else (block_id - last) % _WRAP
        if self._long and step < 0:
            step = 1
        if step == 0 or (not self._long and step > _LATE):
            self._last = last
            return None
        self._count += step
        return self._count
