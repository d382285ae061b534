"""A simulated station, and a real browser to look at it with."""

import os
import re
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, TypeVar
from unittest.mock import patch

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect, sync_playwright

from tests.bench.faults.served import HALF_SIZE
from tests.forked import ForkedProgram, fork_server

__all__ = ["fork_server"]

PATIENCE_S = 240
"""For everything that is waited for: station and browser share the machine with other tests."""
expect.set_options(timeout=1000 * PATIENCE_S)

ROOT = Path(__file__).resolve().parents[2]
T = TypeVar("T", Page, BrowserContext)
NEWCOMER = (sys.executable, "-c", "from crenel.cli.main import main; main()", "demo", "--no-open")
"""Begins the demonstration as people do."""
# software rendering, and none of the browser's own talk to the outside
CHROMIUM_FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-quic",
    "--disable-features=OverlayScrollbar",
]


@pytest.fixture(scope="package")
def browser() -> Iterator[Browser]:
    """Debian's chromium; where it is missing the tests skip, except in CI. Closed with the last of
    them: while it runs, this thread may run no other loop."""
    path = shutil.which("chromium") or shutil.which("chromium-browser")
    if path is None:
        if os.environ.get("CI"):
            pytest.fail("chromium is not installed, and CI must run the browser tests")
        pytest.skip("chromium is not installed")
    with (
        patch.multiple(
            Browser, new_page=patient(Browser.new_page), new_context=patient(Browser.new_context)
        ),
        ThreadPoolExecutor(1, "browser") as files,
        sync_playwright() as playwright,
    ):
        files.submit(int).result()  # its thread is not left by the test that first writes a file
        playwright._loop.set_default_executor(files)
        # a bar that takes space, as on most computers
        running = playwright.chromium.launch(
            executable_path=path, args=CHROMIUM_FLAGS, ignore_default_args=["--hide-scrollbars"]
        )
        yield running
        running.close()


@pytest.fixture(autouse=True)
def closed_pages(request: pytest.FixtureRequest) -> Iterator[None]:
    """What a test leaves open, as one that fails does, would be drawn on beside all others."""
    if "browser" not in request.fixturenames:
        yield
        return
    running: Browser = request.getfixturevalue("browser")
    before = set(running.contexts)
    yield
    for context in set(running.contexts) - before:
        context.close()


def patient(opened: Callable[..., T]) -> Callable[..., T]:
    """What is opened waits as long as the tests do."""

    def open_patient(*arguments: Any, **options: Any) -> T:
        made = opened(*arguments, **options)
        made.set_default_timeout(1000 * PATIENCE_S)
        return made

    return open_patient


QUIET = ("crenel.monitoring.loop_watchdog", "crenel.operations.publishers")


class Demo:
    """A simulated station in a process of its own, or another program that begins as it does.

    Args:
        command: a module and its arguments, for a process that begins in a moment, or the whole
            command of another; the bench's station, without one.
        patient: waits until it is ready, not only for its first page.
        folder: in which it runs.
    """

    def __init__(
        self, data: Path, command: Sequence[str] = (), patient: bool = True, folder: Path = ROOT
    ) -> None:
        self.data = data
        first, *arguments = command or ("tests.bench.faults.served", str(data), *HALF_SIZE)
        self.process: ForkedProgram | subprocess.Popen[str] = (
            subprocess.Popen(
                command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
            )
            if first == sys.executable
            else ForkedProgram(first, arguments, folder)
        )
        self.errors: list[str] = []
        self.listener = threading.Thread(target=self._listen, daemon=True)
        self.listener.start()
        watchdog = threading.Timer(PATIENCE_S, self.process.kill)
        watchdog.start()
        assert self.process.stdout is not None
        output = ""
        for line in self.process.stdout:
            output += line
            if line.startswith("Ready" if patient else "Crenel is at"):
                break
        watchdog.cancel()
        address = re.search(r"http://\S+", output)
        assert address, f"the demo did not start: {output}{''.join(self.errors)}"
        self.link = address.group()
        self.address = self.link.partition("#")[0]

    def _listen(self) -> None:
        assert self.process.stderr is not None
        with self.process.stderr:
            self.errors.extend(self.process.stderr)

    @property
    def complaints(self) -> list[str]:
        """What went wrong by its log: not messages to the operator, as of a device that a busy
        machine kept waiting, nor that it was held up itself for a moment."""
        found, skipping = [], False
        for line in self.errors:
            if re.match(r"\d{4}-\d\d-\d\d ", line):
                skipping = any(f" {name}: " in line for name in QUIET)
            if not skipping:
                found.append(line)
        return found

    def end(self) -> int:
        """Ends the demo as Ctrl-C does; returns its exit status."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            return self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        finally:
            self.listener.join(PATIENCE_S)
            assert self.process.stdout is not None
            self.process.stdout.close()


@pytest.fixture(scope="module")
def demo(fork_server: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Demo]:
    running = Demo(tmp_path_factory.mktemp("demo") / "data")
    yield running
    running.end()


@pytest.fixture(scope="session")
def pictures() -> Path:
    """Where the screenshots are left for people to look at."""
    folder = ROOT / "test-output" / "e2e"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.fixture(scope="session")
def screenshots(request: pytest.FixtureRequest, pictures: Path) -> Path | None:
    """Where every view of a long visit is left for people to look at; None without the option
    ``--screenshots``, since drawing them takes long."""
    return pictures if request.config.getoption("screenshots") else None


def wait_in_page(page: Page, condition: str, argument: object = None) -> None:
    """Wait until a function of JavaScript is true in the page: ``page.wait_for_function`` evaluates
    text again at each look, which the station's policy forbids."""
    page.evaluate(
        f"""async argument => {{
          const condition = {condition};
          const end = Date.now() + {1000 * PATIENCE_S};
          while (!condition(argument)) {{
            if (Date.now() > end) throw new Error("not true for minutes");
            await new Promise(resolve => setTimeout(resolve, 20));
          }}
        }}""",
        argument,
    )
