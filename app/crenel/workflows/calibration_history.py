"""What became of a sensor's calibrations over time, from their files."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.results.acceptance import read_acceptance
from crenel.formats.results.calibration import CalibrationFile, calibration_from_document
from crenel.metrology.calibration.drift import Drift, MountedSensor, measure_drift

# Expanded uncertainty, k = 2, of a shift between two calibrations.
K = 2.0
CACHE_SIZE = 1024


@dataclass(frozen=True)
class CalibrationDrift:
    """What moved since the calibration before of the same arm and sensor.

    ``expected_um`` and ``expected_arcsec`` are what the uncertainties of the two let expect of
    a sensor that did not move (k = 2); the angle is of a plane swept straight across.
    """

    drift: Drift
    expected_um: float
    expected_arcsec: float | None


@dataclass(frozen=True)
class HistoryEntry:
    """One calibration of the history."""

    id: str
    good_um: float | None
    temperature_c: float | None
    since: CalibrationDrift | None


@dataclass(frozen=True)
class _FileVersion:
    """A file as it is now: what was read of it holds until it is written again."""

    path: Path
    written_ns: int


@dataclass(frozen=True)
class _CalibrationSummary:
    arm: str
    sensor: str
    good_um: float | None
    temperature_c: float | None


def read_history(files: Sequence[tuple[str, Path]]) -> list[HistoryEntry]:
    """Reads the history of calibrations by their ids and files, the oldest first.

    A file that cannot be read any more is passed over. What was read once is remembered.
    """
    entries: list[HistoryEntry] = []
    newest: dict[tuple[str, str], _FileVersion] = {}
    for name, path in files:
        try:
            file = _FileVersion(path, path.stat().st_mtime_ns)
            head = _read_summary(file)
        except (OperationError, OSError):
            continue
        of = (head.arm, head.sensor)
        before = newest.get(of)
        since = _estimate_drift(before, file) if before else None
        entries.append(HistoryEntry(name, head.good_um, head.temperature_c, since))
        newest[of] = file
    return entries


@lru_cache(maxsize=CACHE_SIZE)
def _read_summary(file: _FileVersion) -> _CalibrationSummary:
    document, accepted = CalibrationFile.read(file.path), read_acceptance(file.path.parent)
    return _CalibrationSummary(
        document.serial_numbers.arm,
        document.serial_numbers.sensor,
        accepted.good_um if accepted else None,
        accepted.temperature_c if accepted else None,
    )


@lru_cache(maxsize=CACHE_SIZE)
def _estimate_drift(before: _FileVersion, now: _FileVersion) -> CalibrationDrift | None:
    old, new = (CalibrationFile.read(file.path) for file in (before, now))
    was, known = old.uncertainty, new.uncertainty
    if was is None or known is None or known.map is None or old.laser_plane is None:
        return None
    inside = np.array(known.map.calibrated)
    uv_px = np.array(known.map.uv_px).reshape(-1, 2)
    found = measure_drift(_mounting(old), _mounting(new), uv_px[inside] if inside.any() else uv_px)
    if found is None:
        return None
    planes = (was.plane, known.plane)
    return CalibrationDrift(
        found,
        expected_um=K * float(np.hypot(was.total_um, known.total_um)),
        expected_arcsec=(
            K * float(np.hypot(planes[0].angle_arcsec, planes[1].angle_arcsec))
            if planes[0] is not None and planes[1] is not None
            else None
        ),
    )


def _mounting(document: CalibrationFile) -> MountedSensor:
    found = calibration_from_document(document)
    return MountedSensor(found.camera, found.plane, found.T_flange_sensor)
