"""A command of any installed copy of the program as a process: how long it takes, what it holds."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx

from crenel.errors import OperationError
from tests.bench.station.subprocess_station import free_port, memory_mb

PATIENCE_S = 900.0
"""Some copies compile for minutes before they answer."""
LOOK_S = 0.02
VIEW_S = 0.1
IDLE_S = 15.0
"""After its start a station is left alone so long before its memory is read."""
LOST = re.compile(r"\b(?:arm|sensor)-lost: ")
DISTRIBUTIONS = """
import re, sys
from importlib import metadata, util
from pathlib import Path

found, wanted, total = set(), ["crenel"], 0
while wanted:
    name = re.sub("[-_.]+", "-", wanted.pop()).lower()
    if name in found:
        continue
    found.add(name)
    try:
        one = metadata.distribution(name)
    except metadata.PackageNotFoundError:
        continue
    for needed in one.requires or ():
        if "extra ==" not in needed:
            wanted.append(re.match(r"[\\w.-]+", needed).group())
    files = {Path(one.locate_file(file)).resolve() for file in one.files or ()}
    total += sum(file.stat().st_size for file in files if file.is_file())
root = Path(sys.prefix)
for package in ("crenel", "crenel_hardware"):
    folder = Path(util.find_spec(package).origin).parent
    if root not in folder.parents:
        total += sum(file.stat().st_size for file in folder.rglob("*") if file.is_file())
print(total)
"""
"""Bytes of the package and all that it needs; of a checkout, also its sources."""


@dataclass(frozen=True)
class InstalledCopy:
    """An installed copy of the program, by its ``crenel``; its caches are ours alone."""

    name: str
    executable: Path

    def seconds(self, cache: Path, *arguments: str | Path) -> float:
        """How long a command takes.

        Raises:
            OperationError: it fails.
        """
        began_s = time.monotonic()
        done = subprocess.run(
            [self.executable, *arguments],
            env=_environment(cache),
            cwd=cache,
            capture_output=True,
            text=True,
            check=False,
        )
        taken_s = time.monotonic() - began_s
        if done.returncode:
            raise failure_error(f"{self.name}: crenel {arguments[0]} failed", done.stderr)
        return taken_s

    def size_mb(self) -> float:
        """Of the package and what it needs, without extras."""
        python = self.executable.with_name("python")
        asked = [str(python), "-P", "-c", DISTRIBUTIONS]  # not what lies in this folder
        done = subprocess.run(asked, capture_output=True, text=True, check=False)
        if done.returncode:
            raise failure_error(f"{python} does not list its packages", done.stderr)
        return float(done.stdout) / 1e6


def running_copy() -> InstalledCopy:
    """The copy that runs this."""
    return find_copy("this", Path(sys.executable).with_name("crenel"))


def find_copy(name: str, place: Path) -> InstalledCopy:
    """A copy by its executable, or by a checkout with a ``.venv``.

    Raises:
        OperationError: there is none.
    """
    executable = place / ".venv" / "bin" / "crenel" if place.is_dir() else place
    if not executable.is_file():
        raise OperationError(
            "bench-copy",
            f"{executable}: there is no such program",
            remedy="Name the crenel of an installed copy, or a checkout with its .venv",
        )
    return InstalledCopy(name, executable.absolute())


def failure_error(what: str, output: str) -> OperationError:
    """That a copy under test did not do what was asked."""
    last = (output.strip().splitlines() or ["it said nothing"])[-1]
    return OperationError("bench-failed", what, last)


class DemoProcess:
    """A demonstration of a copy in a process of its own, from the moment of its start."""

    def __init__(self, copy: InstalledCopy, cache: Path, data: Path) -> None:
        self._copy = copy
        self._address = f"http://127.0.0.1:{free_port()}"
        port = self._address.rpartition(":")[2]
        self._output = data / "output.txt"
        data.mkdir()
        self._began_s = time.monotonic()
        with self._output.open("w") as output:
            self._process = subprocess.Popen(
                [copy.executable, "demo", "--no-open", "--port", port, "--data", data / "data"],
                env=_environment(cache),
                cwd=cache,
                stdout=output,
                stderr=subprocess.STDOUT,
            )

    def __enter__(self) -> "DemoProcess":
        return self

    def __exit__(self, *_: object) -> None:
        self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(20.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()

    def first_page_s(self) -> float:
        """Until any page answers."""
        return self._until("/", lambda answer: True)

    def ready_s(self) -> float:
        """Until it is the whole station."""
        return self._until("/api/session", lambda answer: answer.status_code == 200)

    def idle_mb(self) -> float:
        """What it holds after it was left alone for a while."""
        time.sleep(IDLE_S)
        return memory_mb(self._process.pid)

    def losses(self) -> int:
        """How often it has reported a lost device."""
        return len(LOST.findall(self._output.read_text()))

    def calibration_s(self) -> float:
        """Until a calibration by the simulated operator is accepted."""
        with httpx.Client(base_url=self._address, timeout=PATIENCE_S) as http:
            _enter(http, self._output.read_text())
            http.post("/api/flow/start").raise_for_status()
            while (view := self._view(http))["step"] != "review" or view["busy"] is not None:
                if view["busy"] is None:  # at first, and after a device was lost
                    _command(http, view, "run_simulation", all=True)
                time.sleep(VIEW_S)
            while _command(http, self._view(http), "accept") != 200:
                time.sleep(VIEW_S)
        return time.monotonic() - self._began_s

    def _view(self, http: httpx.Client) -> dict[str, Any]:
        self._check()
        return dict(http.get("/api/flow").json())

    def _until(self, path: str, enough: Callable[[httpx.Response], bool]) -> float:
        while True:
            with contextlib.suppress(httpx.TransportError):
                if enough(httpx.get(self._address + path, timeout=30.0)):
                    return time.monotonic() - self._began_s
            self._check()
            time.sleep(LOOK_S)

    def _check(self) -> None:
        """Raises ``OperationError`` where it has ended, or takes longer than anybody waits."""
        if self._process.poll() is not None or time.monotonic() - self._began_s > PATIENCE_S:
            raise failure_error(
                f"{self._copy.name}: the demo does not go on", self._output.read_text()
            )


def _enter(http: httpx.Client, output: str) -> None:
    code = re.search(r"#code=(\w+)", output)
    http.post("/api/session/code", json={"code": code and code[1]}).raise_for_status()


def _command(http: httpx.Client, view: dict[str, Any], name: str, **args: object) -> int:
    """The status of a command's answer; one that comes too early or too late is no failure."""
    body = {"name": name, "args": args, "rev": view["rev"], "key": uuid.uuid4().hex}
    return http.post("/api/flow/command", json=body).status_code


def _environment(cache: Path) -> dict[str, str]:
    """Python's and the compiled loops' caches are in a folder of ours, and are written."""
    ours = ("PYTHONPATH", "PYTHONDONTWRITEBYTECODE")
    kept = {key: value for key, value in os.environ.items() if key not in ours}
    return {
        **kept,
        "PYTHONPYCACHEPREFIX": str(cache / "python"),
        "NUMBA_CACHE_DIR": str(cache / "loops"),
    }


@contextlib.contextmanager
def busy_machine() -> Iterator[None]:
    """A process beside that never rests, for each core."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    burners = [
        subprocess.Popen([sys.executable, "-S", "-c", "while True: pass"])
        for _ in range(cores or 1)
    ]
    try:
        yield
    finally:
        for burner in burners:
            burner.kill()
            burner.wait()
