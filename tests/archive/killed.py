"""Run as a program: archives copies of a data folder, each killed one piece later than the last.

Prints how many attempts were killed. After each, whatever has a manifest must be whole, and the
next attempt must complete.
"""

import os
import shutil
import signal
import sys
from collections.abc import Callable
from pathlib import Path

from crenel.archive.pace import Pace
from crenel.store.store import Store
from tests.archive.filled import LATER, Content, archive_of, check_whole, content_of


class EndingPace(Pace):
    """Ends the archive in some way when so many pieces were moved."""

    def __init__(self, pieces: int, end: Callable[[], None]) -> None:
        super().__init__(1.0, lambda: False)
        self._left, self._end = pieces, end

    def take(self, count: int) -> None:
        self._left -= 1
        if self._left < 0:
            self._end()


def attempt(data: Path, place: Path, pieces: int, later: bool) -> bool:
    """Archives in a process of its own; whether it was not killed."""
    child = os.fork()
    if not child:
        store = Store(data)
        rules, seen = ({"keep_days": 1.0}, LATER) if later else ({}, LATER * 0)
        pace = EndingPace(pieces, lambda: os.kill(os.getpid(), signal.SIGKILL))
        archive_of(store, str(place), pace=pace, later=seen, rules=rules).run()
        os._exit(0)
    status = os.waitpid(child, 0)[1]
    if os.WIFSIGNALED(status):
        assert os.WTERMSIG(status) == signal.SIGKILL
        return False
    assert os.WEXITSTATUS(status) == 0
    return True


def check(data: Path, place: Path, originals: dict[str, Content]) -> None:
    """Each scan is on the disk as it was, or whole in the archive."""
    archived = content_of(place)
    whole = {one.id: one for one in check_whole(archived)}
    for scan_id, files in originals.items():
        here = data / "scans" / scan_id
        if here.exists():
            assert content_of(here) == files
        else:
            folder = whole[scan_id].folder
            assert all(archived[f"{folder}/{name}"] == one for name, one in files.items())


def main(top: Path) -> None:
    originals = {path.name: content_of(path) for path in (top / "data/scans").iterdir()}
    killed = pieces = 0
    went_through = False
    while not went_through:
        data, place = top / f"data-{pieces}", top / f"archive-{pieces}"
        shutil.copytree(top / "data", data)
        place.mkdir()
        went_through = True
        for later in (False, True):
            if not attempt(data, place, pieces, later):
                killed += 1
                went_through = False
                check(data, place, originals)
                assert attempt(data, place, 10_000, later)
            check(data, place, originals)
        assert {one.id for one in check_whole(content_of(place))} == set(originals)
        assert list((data / "scans").iterdir()) == []
        pieces += 1
    print(killed)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
