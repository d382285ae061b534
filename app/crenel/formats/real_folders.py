"""Where folders really are: within one another, whatever their names, and on which disks."""

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

BLOCK_DEVICES = Path("/sys/dev/block")
"""Where Linux lists each block device by its number."""


def is_within(inner: Path, outer: Path) -> bool:
    """Whether a path leads into a folder, or to the folder itself: with links and ``..`` followed,
    and where another mount shows the same folder. Neither needs to exist."""
    place, top = (Path(os.path.realpath(path)) for path in (inner, outer))  # resolve fails in loops
    if place.is_relative_to(top):
        return True
    with suppress(OSError):
        return _identity(top) in set(_identities(place))
    return False


def share_disk(one: Path, other: Path) -> bool:
    """Whether two folders are on one disk, in whichever of its partitions; folders that do not
    exist yet are where the folder above them is. Each mount of a network drive counts as a disk."""
    return bool(_disks(one) & _disks(other))


def _identity(path: Path) -> tuple[int, int]:
    found = path.stat()
    return found.st_dev, found.st_ino


def _identities(place: Path) -> Iterator[tuple[int, int]]:
    """The identities of a folder and those around it, as far as they exist."""
    for path in (place, *place.parents):
        with suppress(OSError):
            yield _identity(path)


def _disks(folder: Path) -> frozenset[str]:
    """The disks that carry a folder, each by a name; a volume may have several."""
    place = Path(os.path.realpath(folder))
    number, _ = next(_identities(place))
    device = BLOCK_DEVICES / f"{os.major(number)}:{os.minor(number)}"
    return frozenset(_disks_below(device)) if device.exists() else frozenset({str(number)})


def _disks_below(device: Path) -> Iterator[str]:
    """The disks of a partition, of a volume on others, or the disk itself."""
    device = device.resolve()
    below = sorted((device / "slaves").glob("*"))
    if below:
        for each in below:
            yield from _disks_below(each)
    elif (device / "partition").exists():
        yield from _disks_below(device.parent)
    else:
        yield device.name
