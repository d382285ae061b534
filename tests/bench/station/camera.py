"""The station's camera thread on an industrial camera: Aravis's, which sends over GigE Vision.

The camera is a process of its own, ``arv-fake-gv-camera``, which loses packets at random, and does
not send them again. Its pictures carry numbers, so what the station received and what it counted
as lost must add up to what the camera sent.
"""

import contextlib
import shutil
import subprocess
import time
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.progress import Progress, no_progress
from crenel.station.bus import Bus
from crenel.station.devices.device_thread import LinkState
from crenel.station.devices.frame_hub import FrameTap
from crenel.station.devices.sensor_device import StationSensor
from crenel_hardware.clock import now_ns
from crenel_hardware.registry import sensor_driver

STARTED_MODULES = ()  # programs of others

PROGRAM = "arv-fake-gv-camera-0.8"
ADDRESS = "127.0.0.1"
WIDTH_PX, HEIGHT_PX = 1280, 1024
EXPOSURE_US = 1000.0
PACKET_BYTES = 8192
CONNECTED_WITHIN_S = 20.0
_TAP_SIZE = 64


@dataclass(frozen=True)
class CameraBench:
    """What became of the camera's pictures. Ages are from mid-exposure to the station's hub."""

    seconds: float
    openings: int
    """How often the station opened the camera; once if it was never lost."""
    sent: int
    """By the camera's own numbers, from the first picture of each opening to the last one."""
    whole: int
    lost: int
    """As the station counts them."""
    age_median_s: float
    age_99_s: float
    cores: float
    """Processor time of this process by the clock."""

    @property
    def unaccounted(self) -> int:
        return max(0, self.sent - self.whole - self.lost)


COLUMNS = ("measure", "value")


def table(found: CameraBench) -> list[tuple[str, str]]:
    return [
        ("pictures a second", f"{found.sent / found.seconds:.1f} over {found.seconds:.0f} s"),
        ("opened", f"{found.openings}"),
        ("sent, received whole, counted as lost", f"{found.sent}, {found.whole}, {found.lost}"),
        ("neither received nor counted", f"{found.unaccounted}"),
        (
            "age of a picture: median, 99th percentile",
            f"{1e3 * found.age_median_s:.1f} ms, {1e3 * found.age_99_s:.1f} ms",
        ),
        ("processor", f"{found.cores:.2f} cores"),
    ]


def run(
    seconds: float, rate_hz: float, lost_per_mille: int, progress: Progress = no_progress
) -> CameraBench:
    """Streams for so long.

    Args:
        rate_hz: pictures per second that the camera is set to.
        lost_per_mille: packets that the camera loses, of a thousand.

    Raises:
        OperationError: the camera's program is not installed, or no picture arrives.
    """
    options = {
        "address": ADDRESS,
        "region": [0, 0, WIDTH_PX, HEIGHT_PX],
        "exposure_us": EXPOSURE_US,
        "rate_hz": rate_hz,
        "packet_size": PACKET_BYTES,
    }
    sensor = StationSensor(Bus(), lambda: sensor_driver("genicam", options))
    tap = sensor.frames.tap(_TAP_SIZE)
    with _run_camera(lost_per_mille), _read(sensor):
        return _watch(sensor, tap, seconds, progress)


@contextlib.contextmanager
def _run_camera(lost_per_mille: int) -> Iterator[None]:
    program = shutil.which(PROGRAM)
    if program is None:
        raise OperationError(
            "bench-camera-missing",
            f"Nothing was measured: {PROGRAM} is not installed",
            remedy="install the system's package aravis-tools",
        )
    command = [program, "-i", ADDRESS, "-r", str(lost_per_mille)]
    camera = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        yield
    finally:
        camera.terminate()
        camera.wait()


@contextlib.contextmanager
def _read(sensor: StationSensor) -> Iterator[None]:
    sensor.reader.start()
    try:
        deadline = time.monotonic() + CONNECTED_WITHIN_S
        while sensor.reader.link().state is not LinkState.CONNECTED:
            if time.monotonic() > deadline:
                raise OperationError(
                    "bench-camera-silent",
                    "Nothing was measured: the camera sends no pictures",
                    sensor.reader.link().text,
                )
            time.sleep(0.05)
        yield
    finally:
        sensor.reader.stop()


def _watch(sensor: StationSensor, tap: FrameTap, seconds: float, progress: Progress) -> CameraBench:
    ages_ns: list[int] = []
    numbers: list[int] = []
    begin_s, begin_cpu_s = time.monotonic(), time.process_time()
    while (gone_s := time.monotonic() - begin_s) < seconds:
        progress(gone_s / seconds, f"{gone_s:.0f} of {seconds:.0f} s")
        for frame in tap.get(_TAP_SIZE, 0.2):
            ages_ns.append(now_ns() - frame.mid_exposure_ns)
            numbers.append(frame.sequence)
    cores = (time.process_time() - begin_cpu_s) / gone_s
    sensor.reader.stop()
    numbers += [frame.sequence for frame in tap.get(_TAP_SIZE, 0.0)]
    link = sensor.reader.link()
    if not ages_ns:
        raise OperationError(
            "bench-camera-silent", "Nothing was measured: no whole picture arrived", link.text
        )
    median_ns, late_ns = np.percentile(ages_ns, (50, 99))
    # the station's numbers begin with 0 at each opening
    steps = np.diff(numbers, append=-1)
    ends = np.array(numbers)[steps < 0]
    return CameraBench(
        seconds=gone_s,
        openings=len(ends),
        sent=int(np.sum(ends + 1)),
        whole=len(numbers),
        lost=link.lost,
        age_median_s=1e-9 * float(median_ns),
        age_99_s=1e-9 * float(late_ns),
        cores=cores,
    )
