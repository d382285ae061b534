"""Who may read what the program creates: of a station or a fleet, only its user."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from stat import S_IMODE

ONLY_OWNER = 0o077
"""Taken from the mode of each new file and folder."""
OTHERS = 0o007
READERS = 0o444


@contextmanager
def private_files() -> Iterator[None]:
    """Whatever this process creates meanwhile, in whichever thread, is for its user alone."""
    before = os.umask(ONLY_OWNER)
    try:
        yield
    finally:
        os.umask(before)


def close_to_others(folder: Path) -> None:
    """Takes a folder from the other users of the machine; what its group may do stays. A volume
    that belongs to someone else stays as its owner made it."""
    mode = S_IMODE(folder.stat().st_mode)
    if mode & OTHERS:
        with suppress(PermissionError):
            folder.chmod(mode & ~OTHERS)


def share_as(path: Path, shared: Path) -> None:
    """Lets those read a new file or folder who may read in the folder that is shared.

    Args:
        path: of this user; nobody else gets the right to write there.
        shared: for example an archive, which other programs read with other users.
    """
    readers = shared.stat().st_mode & READERS
    enter = readers >> 2 if path.is_dir() else 0
    with suppress(OSError):  # many network drives have no modes
        path.chmod(S_IMODE(path.stat().st_mode) | readers | enter)
