"""A recording whose process is killed, or whose disk is full, while a fast sensor scans."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from crenel.formats.clouds.files import read_cloud
from crenel.formats.recording.decoders import JointRecord, StripeRecord
from crenel.formats.recording.reader import open_recording
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.formats.builders import ARM, little_calibration

pytestmark = [pytest.mark.device, pytest.mark.soak]

ROOT = Path(__file__).resolve().parents[2]
RATE_HZ, POINTS = 600, 2000
WRITE = f"""
import resource, signal, sys, time
from pathlib import Path
import numpy as np
from crenel.formats.recording.writer import RecordingWriter
from crenel.errors import OperationError
from crenel.metrology.stripe import Stripe
from tests.formats.builders import ARM, HEIGHT, POSE_DEG, WIDTH

rng = np.random.default_rng(0)
u = np.linspace(1, WIDTH - 2, {POINTS})
stripes = [
    Stripe(u, 24 + rng.normal(0, 0.05, {POINTS}), *rng.uniform(0.02, 0.2, (2, {POINTS})))
    for _ in range(16)
]
largest = int(sys.argv[2])
if largest:
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    sys.dont_write_bytecode = True
    resource.setrlimit(resource.RLIMIT_FSIZE, (largest, largest))
q_rad, start_s, flushed_s = np.deg2rad(POSE_DEG), time.monotonic(), time.monotonic()
try:
    with RecordingWriter(Path(sys.argv[1]), [joint.name for joint in ARM.joints]) as writer:
        print("writing", flush=True)
        for i in range({RATE_HZ} * 30):
            wait_s = start_s + i / {RATE_HZ} - time.monotonic()
            time.sleep(max(wait_s, 0))
            now_ns = time.monotonic_ns()
            writer.joints(now_ns - 1, q_rad)
            writer.stripe(now_ns, stripes[i % 16], WIDTH, HEIGHT)
            writer.joints(now_ns + 1, q_rad)
            if time.monotonic() - flushed_s > 0.5:  # as the station does
                writer.flush()
                print(i, flush=True)
                flushed_s = time.monotonic()
except OperationError as refusal:
    print(refusal.line, flush=True)
"""


def writing(path: Path, largest: int = 0) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-c", WRITE, str(path), str(largest)],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.mark.parametrize("after_s", [0.1, 0.87, 1.61])
def test_a_killed_recording_loses_what_was_not_flushed(tmp_path: Path, after_s: float) -> None:
    """1.2 million points a second; whatever is there is rebuilt."""
    path = tmp_path / "scan.mcap"
    with writing(path) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "writing\n"
        flushes = [process.stdout.readline()]
        time.sleep(after_s)
        process.send_signal(signal.SIGKILL)
        flushes += process.stdout.readlines()
    recording = open_recording(path)
    records = list(recording.records())
    assert "incomplete" in str(recording.cut)
    stamps = [record.stamp_ns for record in records if isinstance(record, StripeRecord)]
    flushed = int(flushes[-1]) + 1
    assert len(stamps) >= flushed
    assert sum(isinstance(record, JointRecord) for record in records) >= 2 * flushed
    assert (np.diff(stamps) > 0).all()
    result = reconstruct_cloud(path, little_calibration(), ARM, tmp_path / "cloud.ply")
    assert "read up to" in str(result.cut)
    # the last frame's later joints may be in the second that was lost
    assert result.frames + result.frames_still >= len(stamps) - 1
    assert result.points == result.frames * POINTS
    # the writer has 16 stripes, and the reader leaves out what repeats them
    cloud = read_cloud(tmp_path / "cloud.ply")
    assert len(cloud.points_mm) == min(result.frames, 16) * POINTS


def test_a_full_disk_ends_the_recording_and_keeps_what_is_there(tmp_path: Path) -> None:
    path = tmp_path / "scan.mcap"
    with writing(path, largest=5_000_000) as process:
        said, errors = process.communicate(timeout=300)
    assert said.splitlines()[-1:] == [
        f"{path}: the largest file size of the disk is reached. Choose another."
    ]
    assert errors == ""
    assert path.stat().st_size <= 5_000_000
    recording = open_recording(path)
    stamps = [one.stamp_ns for one in recording.records() if isinstance(one, StripeRecord)]
    assert "incomplete" in str(recording.cut)
    assert recording.bytes_read > 3_900_000  # all but the last chunk
    result = reconstruct_cloud(path, little_calibration(), ARM, tmp_path / "cloud.ply")
    assert result.frames + result.frames_still >= len(stamps) - 1 > 80
