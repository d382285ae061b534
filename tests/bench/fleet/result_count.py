"""Compares what is in the output of ``crenel rebuild`` with the recordings that were made."""

import json
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from crenel.batch.recordings import RECORDING
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.results.calibration import read_calibration
from crenel.workflows.reconstruct import reconstruct_cloud


@dataclass(frozen=True)
class MadeScan:
    """A scan that a station made."""

    station: str
    folder: Path
    session: Path
    """Of its calibration, with the arm."""


@dataclass(frozen=True)
class ResultCount:
    """Of all recordings together."""

    results: int
    """Recordings with a document and its cloud."""
    doubled: int
    """Documents of a recording beyond the first one, and clouds and other files of no document."""
    missing: int
    differing: int
    """Clouds that are not byte for byte that of the station's recording."""


def count_results(
    scans: Sequence[MadeScan],
    names: Sequence[str],
    read: Callable[[str], bytes],
    scratch: Path,
    looked: Callable[[int], None] = lambda done: None,
) -> ResultCount:
    """Counts, and rebuilds each scan once more for the comparison.

    Args:
        names: of all files in the output.
        read: returns the content of one of them.
        scratch: a folder for a cloud.
        looked: called with the number of scans that are compared.
    """
    documents = [json.loads(read(name)) for name in names if name.endswith(".json")]
    known = {(one["station"], one["record"]): str(one["cloud"]) for one in documents}
    per_scan = Counter((one["station"], one["record"]) for one in documents)
    made = {(one.station, one.folder.name): one for one in scans}
    clouds = [name for name in names if not name.endswith(".json")]
    unnamed = len(set(clouds) - set(known.values())) + len(known.keys() - made.keys())
    differing = found = 0
    for number, (key, scan) in enumerate(made.items(), 1):
        cloud = known.get(key)
        if cloud is not None and cloud in clouds:
            found += 1
            differing += read(cloud) != _rebuild(scan, scratch)
        looked(number)
    return ResultCount(
        results=found,
        doubled=sum(count - 1 for count in per_scan.values()) + unnamed,
        missing=len(made) - found,
        differing=differing,
    )


def _rebuild(scan: MadeScan, scratch: Path) -> bytes:
    target = scratch / "compared.ply"
    calibration = read_calibration(scan.session / "calibration.json")
    arm = read_any_arm(scan.session / "arm.json")
    reconstruct_cloud(scan.folder / RECORDING, calibration, arm, target)
    return target.read_bytes()
