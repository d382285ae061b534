"""Whenever the archive is interrupted, nothing whole is missing and nothing partial has a
manifest."""

import shutil
import subprocess
import sys
from contextlib import closing, suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crenel.errors import OperationError
from crenel.store.store import Store
from tests.archive.filled import LATER, add_scan, archive_of, check_whole, content_of
from tests.archive.killed import EndingPace

ROOT = Path(__file__).resolve().parents[2]
SCANS = ("one", "two")
pytestmark = [pytest.mark.device, pytest.mark.soak]


def test_a_process_that_is_killed_anywhere_loses_nothing(store: Store, tmp_path: Path) -> None:
    for scan_id in SCANS:
        add_scan(store, scan_id, 300_000)
    store.close()
    command = [sys.executable, "-m", "tests.archive.killed", str(tmp_path)]
    ran = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, timeout=120, check=False
    )
    assert ran.returncode == 0, ran.stderr
    assert int(ran.stdout) >= 20


class _InterruptedError(BaseException):
    """As a signal would end the process."""


def interrupt() -> None:
    raise _InterruptedError


def damage(place: Path, scan_id: str, how: str) -> None:
    """Changes the copies of a scan behind the station's back."""
    for folder in (place / "scans" / scan_id).glob("*"):
        copy = folder / ("manifest.json" if how == "manifest" else "scan.mcap")
        if how == "flip" and copy.exists():
            content = bytearray(copy.read_bytes())
            content[len(content) // 2] ^= 1
            copy.write_bytes(content)
        elif how == "shorten" and copy.exists():
            copy.write_bytes(copy.read_bytes()[:-1])
        else:
            copy.unlink(missing_ok=True)


STEPS = st.one_of(
    st.tuples(st.just("run"), st.integers(0, 40)),
    st.tuples(st.just("retain"), st.integers(0, 60)),
    st.tuples(st.sampled_from(("flip", "shorten", "missing", "manifest")), st.sampled_from((0, 1))),
)


@given(st.lists(STEPS, min_size=1, max_size=8))
@settings(max_examples=25, deadline=None, database=None)
def test_only_what_is_whole_in_the_archive_leaves_the_disk(steps: list[tuple[str, int]]) -> None:
    with TemporaryDirectory() as top:
        place = Path(top) / "archive"
        place.mkdir()
        with closing(Store(Path(top) / "data")) as store:
            _follow(steps, store, place)


def _follow(steps: list[tuple[str, int]], store: Store, place: Path) -> None:
    scans = {name: add_scan(store, name, 300_000) for name in SCANS}
    before = {name: content_of(folder) for name, folder in scans.items()}
    for what, number in steps:
        if what in ("run", "retain"):
            later, rules = (LATER, {"keep_days": 90.0}) if what == "retain" else (LATER * 0, {})
            here = {name for name, folder in scans.items() if folder.exists()}
            pace = EndingPace(number, interrupt)
            archive = archive_of(store, str(place), pace=pace, later=later, rules=rules)
            with suppress(_InterruptedError, OperationError):
                archive.run()
            for name in here:
                if not scans[name].exists():  # this step removed it
                    copies = [content_of(copy) for copy in (place / "scans" / name).iterdir()]
                    assert any(before[name].items() <= copy.items() for copy in copies)
        else:
            name = SCANS[number]
            if scans[name].exists():  # otherwise the archive loses what only it has
                damage(place, name, what)
    for name, folder in scans.items():
        if folder.exists():
            assert content_of(folder) == before[name]
    archive_of(store, str(place)).verify()  # finds the damage
    archive_of(store, str(place)).run()
    assert {one.id for one in check_whole(content_of(place))} == set(scans)
    shutil.rmtree(place)
