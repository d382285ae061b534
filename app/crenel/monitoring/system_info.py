"""State of the machine and the process, as reported by the operating system."""

import os
import platform
import resource
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from crenel.formats.io_errors import error_from_os
from crenel.messages.message import Text

Network = Literal["here", "encrypted", "proxied", "open"]
"""From where the station can be reached: from this machine only, or from others."""

MEMINFO = Path("/proc/meminfo")
JUMP_S = 1.0


@dataclass(frozen=True, slots=True)
class Memory:
    """In bytes; null if the system does not report it."""

    process: int
    free: int | None


def memory() -> Memory:
    """The memory of this process, and the memory that is free."""
    return Memory(resident() or _peak(), _bytes(MEMINFO, "MemAvailable"))


def resident(process: int | None = None) -> int | None:
    """Memory of a process in bytes, by its id, or of this one; null if unknown."""
    return _bytes(Path(f"/proc/{process or 'self'}/status"), "VmRSS")


def _bytes(path: Path, key: str) -> int | None:
    try:
        for line in path.read_text().splitlines():
            if line.startswith(f"{key}:"):
                return int(line.split()[1]) * 1024
    except (OSError, ValueError, IndexError):
        pass
    return None


def _peak() -> int:
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak * 1024


class WallClock:
    """Detects that the wall clock is set while the station runs."""

    def __init__(self) -> None:
        self._offset_s = time.time() - time.monotonic()
        self.jumps = 0
        self.last_jump_s = 0.0

    def look(self) -> None:
        """Called every few seconds; a slow drift is followed and does not count as a jump."""
        offset_s = time.time() - time.monotonic()
        if abs(offset_s - self._offset_s) > JUMP_S:
            self.jumps += 1
            self.last_jump_s = offset_s - self._offset_s
        self._offset_s = offset_s


def versions() -> dict[str, str]:
    """The platform of the program."""
    return {
        "Python": platform.python_version(),
        "system": f"{platform.system()} {platform.release()}",
        "machine": platform.machine(),
        "processors": str(os.cpu_count() or 0),
    }


def writable(folder: Path) -> Text:
    """Empty if a file can be written in the folder, otherwise the reason."""
    trial = folder / f".trial-{os.getpid()}"
    try:
        trial.write_bytes(b"x")
        trial.unlink()
    except OSError as error:
        return error_from_os(error).why
    return ""
