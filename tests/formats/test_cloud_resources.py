"""What writing a cloud takes of disk and memory, each in a process of its own."""

import subprocess
import sys
from pathlib import Path

import pytest

from crenel.formats.clouds.files import COPC, SUFFIXES

pytestmark = pytest.mark.device


@pytest.mark.parametrize("suffix", [*SUFFIXES, COPC])
def test_a_full_disk_leaves_nothing(tmp_path: Path, suffix: str) -> None:
    """In a process whose files may not grow beyond 200 kB."""
    if suffix == COPC:
        pytest.importorskip("copclib")
    script = f"""
import resource, signal, sys
import numpy as np
from pathlib import Path
from crenel.formats.clouds.files import cloud_writer
from crenel.errors import OperationError
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
list(map(__import__, ("pye57", "laspy", "lazrs")))
path, rng = Path(sys.argv[1]), np.random.default_rng(0)
with cloud_writer(path.with_name("small{suffix}")) as cloud:  # kernels are compiled, then
    cloud.write(np.ones((3, 3)), *np.ones((2, 3)), 0)
sys.dont_write_bytecode = True
resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))
try:
    with cloud_writer(path) as cloud:
        for i in range(4):
            cloud.write(rng.normal(0, 300, (70_000, 3)), *rng.uniform(0, 99, (2, 70_000)), i)
except OperationError as refusal:
    print(refusal.line)
"""
    path = tmp_path / f"c{suffix}"
    done = subprocess.run(
        [sys.executable, "-c", script, str(path)], capture_output=True, text=True, check=True
    )
    assert str(path) in done.stdout
    assert len(done.stdout.splitlines()) == 1
    assert done.stderr == ""
    assert [entry.name for entry in tmp_path.iterdir()] == [f"small{suffix}"]


def test_memory_stays_bounded_however_large_the_cloud(tmp_path: Path) -> None:
    """Four times the points of every format, and no more memory."""
    script = """
import resource, sys
import numpy as np
from pathlib import Path
from crenel.formats.clouds.files import SUFFIXES, cloud_writer
rng, folder = np.random.default_rng(0), Path(sys.argv[1])
piece = (rng.normal(0, 300, (50_000, 3)), *rng.uniform(0, 99, (2, 50_000)))
def write(count):
    for suffix in SUFFIXES:
        with cloud_writer(folder / f"c{suffix}") as cloud:
            for i in range(count):
                cloud.write(*piece, i)
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
first = write(6)
print(write(24) - first)
"""
    done = subprocess.run(
        [sys.executable, "-c", script, str(tmp_path)], capture_output=True, text=True, check=True
    )
    unit = 1 if sys.platform == "darwin" else 1024
    assert int(done.stdout) * unit < 20e6  # 900 000 points more are 32 MB in memory
