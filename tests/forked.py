"""A program of the project in a process that begins with what is imported once, and so in a moment.

A file whose tests start such programs uses ``fork_server``, so that one worker imports for all.
"""

import multiprocessing
import os
import runpy
import subprocess
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from multiprocessing.connection import Connection
from multiprocessing.context import ForkServerProcess
from pathlib import Path
from typing import TextIO

import pytest

CONTEXT = multiprocessing.get_context("forkserver")
CONTEXT.set_forkserver_preload(["crenel.server.application", "tests.bench.faults.served"])
COMMAND_LINE = "crenel.cli.main"
ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def fork_server() -> None:
    """Begins with the first program; shared by a file, it keeps its tests in one worker."""


class ForkedProgram:
    """Runs a module as ``python -m`` does; has the methods of ``subprocess.Popen``. ``output``: a
    file for all that it says."""

    def __init__(
        self,
        module: str,
        arguments: Sequence[str] = (),
        folder: Path = ROOT,
        output: Path | None = None,
    ) -> None:
        with ExitStack() as theirs:
            if output is None:
                self.stdout, out = _pipe(theirs)
                self.stderr, err = _pipe(theirs)
                said: Path | tuple[Connection, Connection] = (out, err)
            else:
                output.touch()
                said = output
            self._process: ForkServerProcess = CONTEXT.Process(
                target=_run, args=(module, [*arguments], folder, said), daemon=True
            )
            self._process.start()

    def __enter__(self) -> "ForkedProgram":
        return self

    def __exit__(self, *_: object) -> None:
        self.stdout.close()
        self.stderr.close()
        self.wait()

    @property
    def pid(self) -> int:
        assert self._process.pid is not None
        return self._process.pid

    @property
    def returncode(self) -> int | None:
        return self._process.exitcode

    def poll(self) -> int | None:
        return self._process.exitcode

    def wait(self, timeout: float | None = None) -> int:
        self._process.join(timeout)
        if self._process.exitcode is None:
            raise subprocess.TimeoutExpired("the program", timeout or 0.0)
        return self._process.exitcode

    def send_signal(self, sig: int) -> None:
        if self.poll() is None:
            os.kill(self.pid, sig)

    def kill(self) -> None:
        self._process.kill()


def _pipe(theirs: ExitStack) -> tuple[TextIO, Connection]:
    """The end that we read, and the one that the process writes to."""
    ours, writer = CONTEXT.Pipe(duplex=False)
    theirs.enter_context(writer)
    with ours:
        return open(os.dup(ours.fileno()), encoding="utf-8"), writer


def _run(
    module: str, arguments: list[str], folder: Path, said: Path | tuple[Connection, Connection]
) -> None:
    if isinstance(said, Path):
        console = os.open(said, os.O_WRONLY | os.O_APPEND)
        descriptors = [console, console]
    else:
        descriptors = [one.fileno() for one in said]
    for number, descriptor in zip((1, 2), descriptors, strict=True):
        os.dup2(descriptor, number)
    for descriptor in set(descriptors):
        os.close(descriptor)
    os.chdir(folder)
    sys.argv = [module, *arguments]
    if module == COMMAND_LINE:
        from crenel.cli.main import main

        main()
    else:
        sys.modules.pop(module, None)  # what was imported before is run again
        runpy.run_module(module, run_name="__main__")
