"""The firmware as machine code in simavr, with encoders, buttons and trigger: ``board.c``."""

import contextlib
import shutil
import signal
import subprocess
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

STARTED_MODULES = ()  # compilers, and what they make
FIRMWARE = Path(__file__).parents[3] / "hardware/firmware/avr"
SOURCE = Path(__file__).with_name("board.c")
CLOCK_HZ = 16_000_000
WITHIN_S = 120.0


def missing_tool() -> str | None:
    for tool in ("make", "gcc", "avr-gcc", "avr-objcopy"):
        if shutil.which(tool) is None:
            return tool
    return None if Path("/usr/include/simavr/sim_avr.h").exists() else "libsimavr-dev"


def build_firmware(folder: Path, **settings: object) -> Path:
    """``arm.elf`` in a folder, made by the firmware's own Makefile."""
    values = [f"{name}={value}" for name, value in settings.items()]
    command = ["make", "-s", "-C", str(FIRMWARE), f"BUILD={folder}", *values]
    subprocess.run(command, check=True, capture_output=True, text=True)
    return folder / "arm.elf"


def build_board(folder: Path) -> Path:
    """The program that runs the firmware; skips the test if it cannot be built here."""
    program = folder / "board"
    command = ["gcc", "-O2", "-Wall", "-Wextra", "-Werror", str(SOURCE), "-o", str(program)]
    done = subprocess.run([*command, "-lsimavr", "-lelf", "-lutil"], capture_output=True, text=True)
    if done.returncode and ("cannot find -l" in done.stderr or "No such file" in done.stderr):
        pytest.skip(done.stderr)
    assert done.returncode == 0, done.stderr
    return program


class Board:
    """A powered board; ``pulses`` are the cycles of rise, latching and fall of each trigger."""

    def __init__(self, program: Path, firmware: Path, link: Path, joints: int = 6) -> None:
        self.url = str(link)
        self.joints = joints
        self.contacts = 0
        self.pulses: list[tuple[int, int, int]] = []
        self.on_pulse: Callable[[int], None] = lambda number: None
        """Called with the number of each trigger, counted from power on."""
        self._command = [str(program), str(firmware), str(joints), str(link)]
        self._process: subprocess.Popen[str] | None = None
        self._marked = threading.Event()
        self.power_on()

    def power_on(self) -> None:
        if self._process is not None:
            return
        self._process = subprocess.Popen(
            self._command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        started = threading.Event()
        arguments = (self._process, started)
        threading.Thread(target=self._listen, args=arguments, daemon=True).start()
        assert started.wait(WITHIN_S), "the board does not start"

    def power_off(self) -> None:
        """The terminal disappears at once."""
        process, self._process = self._process, None
        if process is not None:
            process.kill()
            process.wait()
            assert process.stdin is not None
            with contextlib.suppress(BrokenPipeError):
                process.stdin.close()

    def stop_clock(self, stop: bool) -> None:
        """The microcontroller stands still, and goes on later."""
        assert self._process is not None
        self._process.send_signal(signal.SIGSTOP if stop else signal.SIGCONT)

    def tell(self, *words: object) -> None:
        assert self._process is not None
        assert self._process.stdin is not None
        self._process.stdin.write(" ".join(str(word) for word in words) + "\n")
        self._process.stdin.flush()

    def turn(self, values: list[int]) -> None:
        """Where the encoders stand, 14 bits each."""
        for joint, value in enumerate(values):
            self.tell("angle", joint, value % (1 << 14))

    def await_pulses(self, count: int) -> None:
        deadline = time.monotonic() + WITHIN_S
        while len(self.pulses) < count:
            assert time.monotonic() < deadline, f"{len(self.pulses)} pulses"
            time.sleep(0.01)

    def pulses_by_now(self) -> int:
        """How many triggers there were."""
        self._marked.clear()
        self.tell("mark")
        assert self._marked.wait(WITHIN_S), "the board does not answer"
        return len(self.pulses)

    def _listen(self, process: "subprocess.Popen[str]", started: threading.Event) -> None:
        assert process.stdout is not None
        for line in process.stdout:
            word, *numbers = line.split()
            if word == "running":
                started.set()
            elif word == "mark":
                self._marked.set()
            elif word == "host":
                self.contacts += 1
            elif word == "pulse":
                rose, latched, fell = map(int, numbers)
                self.pulses.append((rose, latched, fell))
                self.on_pulse(len(self.pulses))
        process.stdout.close()
