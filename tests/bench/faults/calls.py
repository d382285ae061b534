"""The calls of a station that reach the disk and the network: logged, and failing on request.

By a small library that is preloaded into its process (``c/disk_calls.c``); Linux alone.
"""

import sys
from pathlib import Path

from crenel.errors import OperationError
from crenel.native.build import BuildError, build_plain

UNAVAILABLE = "bench-untried"
"""The code of the error where the library cannot be used."""
CODE = Path(__file__).parent / "c" / "disk_calls.c"


def compile_library(folder: Path) -> Path:
    """Compiles the library into a folder.

    Raises:
        OperationError: it cannot be, or preloaded, here.
    """
    if sys.platform != "linux" or not CODE.is_file():
        raise _unavailable_error("this needs Linux, and a checkout of the sources")
    try:
        return build_plain(CODE, folder / "disk_calls.so")
    except BuildError as error:
        raise _unavailable_error(str(error).splitlines()[0]) from error


def preload_environment(folder: Path, library: Path, **files: Path) -> dict[str, str]:
    """The environment in which the preloaded library minds the calls on what is in a folder.

    Args:
        files: ``LOG``, where it writes them; ``DISK``, by which it fails them.
    """
    given = {f"CRENEL_CALLS_{name}": str(path) for name, path in files.items()}
    return {"LD_PRELOAD": str(library), "CRENEL_CALLS_UNDER": str(folder), **given}


def _unavailable_error(why: str) -> OperationError:
    return OperationError(UNAVAILABLE, "A full disk at every call was not tried", why)
