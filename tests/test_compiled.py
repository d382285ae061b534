"""Compiled loops are kept on disk, and compiled anew once anything that is in them has changed."""

import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

import app.metrology.compiled

OUTER = """
from {room}.inner import SHARE, inner
from {room}.compiled import kernel

@kernel
def outer(x: float) -> float:
    return above(x)

@kernel
def above(x: float) -> float:
    return SHARE * inner(x)
"""
INNER = """
from {room}.compiled import kernel

SHARE = {share}

@kernel
def inner(x: float) -> float:
    return x + {added}
"""
RUN = "from {room}.outer import outer; print(outer(1.0), sum(outer.stats.cache_hits.values()))"


class House:
    """A room with kernels in two files, and a folder in which numba keeps them."""

    def __init__(self, folder: Path, compiled: ModuleType) -> None:
        self._folder, self.room = folder, compiled.__name__.rpartition(".")[0]
        self._files = folder.joinpath(*self.room.split("."))
        self._files.mkdir(parents=True)
        for parent in (self._files, *self._files.parents[: self.room.count(".")]):
            parent.joinpath("__init__.py").touch()
        text = Path(str(compiled.__file__)).read_text()
        self._files.joinpath("compiled.py").write_text(text)
        self.write(OUTER, "outer.py")

    def write(self, text: str, name: str, **values: float) -> None:
        self._files.joinpath(name).write_text(text.format(room=self.room, **values))

    def run(self) -> tuple[float, int]:
        """What a process of its own computes, and how many kernels it found on disk."""
        environment = {**os.environ, "NUMBA_CACHE_DIR": str(self._folder / "kept")}
        command = [sys.executable, "-c", RUN.format(room=self.room)]
        done = subprocess.run(
            command, cwd=self._folder, env=environment, capture_output=True, text=True, check=True
        )
        value, hits = done.stdout.split()
        return float(value), int(hits)


@pytest.mark.parametrize("compiled", [app.metrology.compiled])
def test_a_kernel_is_compiled_anew_when_another_file_changes(
    tmp_path: Path, compiled: ModuleType
) -> None:
    house = House(tmp_path, compiled)
    house.write(INNER, "inner.py", share=2.0, added=1.0)
    assert house.run() == (4.0, 0)
    assert house.run() == (4.0, 1)
    house.write(INNER, "inner.py", share=2.0, added=5.0)
    assert house.run() == (12.0, 0)
    house.write(INNER, "inner.py", share=3.0, added=5.0)
    assert house.run() == (18.0, 0)
    assert house.run() == (18.0, 1)


@pytest.mark.parametrize("compiled", [app.metrology.compiled])
def test_processes_keep_their_code_in_files_of_their_own(
    tmp_path: Path, compiled: ModuleType
) -> None:
    """Two that compile at once must not write one file: each would find the other's code in it."""
    house = House(tmp_path, compiled)
    house.write(INNER, "inner.py", share=2.0, added=1.0)
    house.run()
    first = set(tmp_path.rglob("*.nbc"))
    for index in tmp_path.rglob("*.nbi"):
        index.unlink()  # as a second process that began before the first was done
    house.run()
    second = set(tmp_path.rglob("*.nbc")) - first
    assert len(first) == len(second) > 0
