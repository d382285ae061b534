"""Reads a LAZ in a process of its own, since its library aborts on some damaged files.

The process writes a line of JSON with the names of the columns and the number of points that the
header announces, then the columns of all points as doubles, row by row.
"""

import json
import os
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import numpy as np

from crenel.formats.clouds.las.table import LasTable, format_las_error, open_las
from crenel.formats.clouds.optional_library import first_line
from crenel.formats.open_file import open_file

MOST_MEMORY_BYTES = 8 << 30
"""Address space of the process, where the system can limit it; what is read passes through."""
STARTED_MODULES = ("crenel.formats.clouds.las.laz_process",)
QUIET = {"RUST_BACKTRACE": "0", "RAYON_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
"""No trace of the stack; and threads would reserve address space."""


def read_in_process(path: Path) -> LasTable:
    """The points of a LAZ; raises ``OperationError`` if its library fails, in whatever way."""
    done = subprocess.run(
        [sys.executable, "-P", "-m", *STARTED_MODULES, str(path)],
        env=os.environ | QUIET,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        check=False,
    )
    if done.returncode:
        lines = done.stderr.decode("utf-8", "replace").splitlines()
        said = [line for line in lines if line.strip() and not line.startswith("note:")]
        raise format_las_error(path, said[-1] if said else f"status {done.returncode}")
    head, _, rows = done.stdout.partition(b"\n")
    described = json.loads(head)
    table = np.frombuffer(rows).reshape(-1, len(described["names"]))
    return LasTable(tuple(described["names"]), table, described["announced"])


def _main(path: Path) -> int:
    with suppress(ImportError):  # Windows limits no memory
        import resource

        _, most = resource.getrlimit(resource.RLIMIT_AS)
        limit = MOST_MEMORY_BYTES if most < 0 else min(MOST_MEMORY_BYTES, most)
        resource.setrlimit(resource.RLIMIT_AS, (limit, most))
    try:
        with open_file(path) as file, open_las(path, file) as opened:
            described = {"names": opened.names, "announced": opened.announced}
            sys.stdout.buffer.write(json.dumps(described).encode() + b"\n")
            for rows in opened.pieces():
                sys.stdout.buffer.write(rows.tobytes())
        sys.stdout.buffer.flush()
    except BaseException as error:  # a panic of Rust is no ``Exception``
        print(f"\n{first_line(error) or type(error).__name__}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(_main(Path(sys.argv[1])))
