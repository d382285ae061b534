"""What became of a sensor's calibrations over time, from their files."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.files.acceptance import read_acceptance
from app.files.calibration import CalibrationFile, calibration_in
from app.metrology.drift import Drift, Mounted, drift
from app.metrology.refusal import Refusal

# Expanded uncertainty, k = 2, of a shift between two calibrations.
K = 2.0


@dataclass(frozen=True)
class Since:
    """What moved since the calibration before of the same arm and sensor.

    ``expected_um`` and ``expected_arcsec`` are what the uncertainties of the two let expect of
    a sensor that did not move (k = 2); the angle is of a plane swept straight across.
    """

    id: str
    drift: Drift
    expected_um: float
    expected_arcsec: float | None


@dataclass(frozen=True)
class HistoryEntry:
    """One calibration of the history."""

    id: str
    good_um: float | None
    temperature_c: float | None
    since: Since | None


def history(files: Sequence[tuple[str, Path]]) -> list[HistoryEntry]:
    """Of calibrations by their ids and files, the oldest first.

    A file that cannot be read any more is passed over.
    """
    entries: list[HistoryEntry] = []
    newest: dict[tuple[str, str], tuple[str, CalibrationFile]] = {}
    for name, path in files:
        try:
            sheet, accepted = CalibrationFile.read(path), read_acceptance(path.parent)
        except Refusal:
            continue
        of = (sheet.serial_numbers.arm, sheet.serial_numbers.sensor)
        before = newest.get(of)
        entries.append(
            HistoryEntry(
                name,
                accepted.good_um if accepted else None,
                accepted.temperature_c if accepted else None,
                _since(before, sheet) if before else None,
            )
        )
        newest[of] = (name, sheet)
    return entries


def _since(before: tuple[str, CalibrationFile], sheet: CalibrationFile) -> Since | None:
    name, old = before
    was, now = old.uncertainty, sheet.uncertainty
    if was is None or now is None or now.map is None:
        return None
    inside = np.array(now.map.calibrated)
    uv_px = np.array(now.map.uv_px).reshape(-1, 2)
    found = drift(_mounted(old), _mounted(sheet), uv_px[inside] if inside.any() else uv_px)
    if found is None:
        return None
    planes = (was.plane, now.plane)
    return Since(
        name,
        found,
        expected_um=K * float(np.hypot(was.total_um, now.total_um)),
        expected_arcsec=(
            K * float(np.hypot(planes[0].angle_arcsec, planes[1].angle_arcsec))
            if planes[0] is not None and planes[1] is not None
            else None
        ),
    )


def _mounted(sheet: CalibrationFile) -> Mounted:
    found = calibration_in(sheet)
    return Mounted(found.camera, found.plane, found.T_flange_sensor)
