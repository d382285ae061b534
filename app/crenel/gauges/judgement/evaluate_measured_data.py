"""The touches and scans in the folder of a performance test."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.clouds.points import Points, positions_of
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.json_document import file_sha256
from crenel.formats.open_file import open_file
from crenel.formats.recording.index import read_index
from crenel.formats.recording.reader import EXTRACTION, SCAN_STARTED, SMOOTHING, Recording
from crenel.formats.results.calibration import CALIBRATION, Calibration, Input, read_calibration
from crenel.formats.session.calibration_session import ARM, last_touched_at, read_contacts
from crenel.gauges.judgement.evaluate_temperatures import artefact_span
from crenel.gauges.plan.document import PLAN, TOUCHES, PerformancePlan, read_plan
from crenel.gauges.plan.document_temperatures import (
    END_TEMPERATURES,
    EndTemperatures,
    read_end_temperatures,
)
from crenel.gauges.plan.maths_temperature import MeanTemperature, mean_temperature
from crenel.gauges.sphere.maths_articulation import stylus_directions
from crenel.messages.message import Text, message, rounded
from crenel.metrology.arm.kinematics import AnyArm, tip_centres
from crenel.metrology.transforms import Floats
from crenel.timestamps import is_moment, parse_moment
from crenel.workflows.reconstruct import reconstruct_into

RECORDING = "scan.mcap"
ASIDE = "-aside-"
"""In the name of a scan that does not count, before its number."""


@dataclass(frozen=True)
class ScanCloud:
    """One scan, rebuilt with the calibration."""

    points_mm: Floats  # (N, 3), arm frame
    frame: NDArray[np.int64]  # (N,)
    views: Floats  # (N, 3) unit directions from the points to the camera
    R_arm_sensor: Floats  # (3, 3) mean orientation of the sensor over the points


@dataclass(frozen=True)
class MeasuredData:
    """What was measured, by the names of its groups."""

    folder: Path
    plan: PerformancePlan
    arm: AnyArm
    calibration: Calibration | None
    tips_mm: Mapping[str, Floats]
    """Tip centres (N, 3) by the feature of the touches."""
    styli: Mapping[str, Floats]
    """Unit directions (N, 3) from the tip to the wrist by the feature of the touches."""
    inputs: tuple[Input, ...]
    end: EndTemperatures

    @property
    def artefact(self) -> MeanTemperature | None:
        """Temperature of the artefact over the test; None: not measured."""
        span = artefact_span(self.plan, self.end)
        return mean_temperature(span, self.plan.temperature_sd_c)

    @property
    def off_20_c(self) -> tuple[float, float]:
        """By how much it was away from 20 °C, and the standard uncertainty; 0 if not measured."""
        artefact = self.artefact
        return (0.0, 0.0) if artefact is None else (artefact.off_c, artefact.sd_c)

    def has_scan(self, name: str) -> bool:
        """Whether a scan of this name was recorded."""
        return (self.folder / name / RECORDING).is_file()

    def scan(self, name: str) -> ScanCloud:
        """One scan, by the name of its folder.

        Raises:
            OperationError: it cannot be rebuilt, or the folder has no calibration.
        """
        if self.calibration is None:
            raise OperationError("file-missing", message("scans-need-a-calibration"))
        return read_scan(self.folder / name / RECORDING, self.calibration, self.arm)


def thin_points(points: Floats, most: int) -> Floats:
    """Evenly chosen ones of points (N, k), hardly more than ``most``."""
    return points[:: max(1, len(points) // most)]


def read_measured_data(folder: Path, features: Sequence[str]) -> MeasuredData:
    """Reads a folder.

    Args:
        features: the groups of touches that the test knows; without any, none are read.

    Raises:
        OperationError: plan or arm is missing or damaged, or touches of unknown groups.
    """
    plan, arm = read_plan(folder), read_any_arm(folder / ARM)
    calibration_path = folder / CALIBRATION
    calibration = read_calibration(calibration_path) if calibration_path.is_file() else None
    tips: dict[str, Floats] = {}
    styli: dict[str, Floats] = {}
    if features and (folder / TOUCHES).is_file():
        contacts = read_contacts(folder / TOUCHES, arm, features)
        centres = tip_centres(arm, contacts.arm_readings)
        names = np.array(contacts.features)
        directions = stylus_directions(arm, contacts.arm_readings)
        for name in dict.fromkeys(contacts.features):
            tips[name], styli[name] = centres[names == name], directions[names == name]
    end = read_end_temperatures(folder)
    return MeasuredData(folder, plan, arm, calibration, tips, styli, _inputs(folder), end)


def read_scan(recording: Path, calibration: Calibration, arm: AnyArm) -> ScanCloud:
    """A scan with the direction to the camera of each point; raises ``OperationError``."""
    kept: list[Points] = []
    poses: list[Floats] = []
    reconstruct_into(
        recording,
        calibration,
        arm,
        lambda points, _: kept.append(points),
        take_frames=lambda first, sensor, block, readings: poses.append(block),
    )
    points = np.concatenate(kept)
    T_arm_sensor = np.concatenate(poses)
    frame = points["frame"].astype(np.int64)
    xyz = positions_of(points)
    finite = np.isfinite(xyz).all(axis=1)
    xyz, frame = xyz[finite], frame[finite]
    cameras = T_arm_sensor[:, :3, :3] @ calibration.camera.centre_mm + T_arm_sensor[:, :3, 3]
    views = cameras[frame] - xyz
    views /= np.linalg.norm(views, axis=1)[:, None]
    mean = T_arm_sensor[frame, :3, :3].mean(axis=0)
    left, _, right = np.linalg.svd(mean)
    return ScanCloud(xyz, frame, views, np.asarray(left @ right))


def last_measured_at(folder: Path) -> str:
    """When the last touch was taken or the last scan ended, ISO 8601; empty if the folder does not
    tell.

    Raises:
        OperationError: the touches cannot be read.
    """
    moments = [_scan_ended_at(path) for path in folder.glob(f"*/{RECORDING}")]
    if (folder / TOUCHES).is_file() and (touched := last_touched_at(folder / TOUCHES)):
        moments.append(parse_moment(touched))
    last = max((one for one in moments if one is not None), default=None)
    return "" if last is None else last.isoformat(timespec="seconds").replace("+00:00", "Z")


def _scan_ended_at(path: Path) -> datetime | None:
    """Its beginning if it is incomplete; None if it does not tell, or cannot be read."""
    try:
        begun = Recording(path, path.stat().st_size).station_metadata().get(SCAN_STARTED, "")
        with open_file(path) as file:
            index = read_index(file)
    except (OSError, OperationError):
        return None  # a scan that counts is refused where it is measured
    if not is_moment(begun):
        return None
    return parse_moment(begun) + timedelta(seconds=0.0 if index is None else index.seconds)


def _inputs(folder: Path) -> tuple[Input, ...]:
    """Every file that figures follow from, by its hash."""
    names = [PLAN, ARM, CALIBRATION, TOUCHES, END_TEMPERATURES]
    names += sorted(path.relative_to(folder).as_posix() for path in folder.glob(f"*/{RECORDING}"))
    return tuple(
        Input(file=name, sha256=file_sha256(folder / name))
        for name in names
        if (folder / name).is_file()
    )


Settings = Mapping[str, object]
"""What was not automatic."""


def read_scan_settings(data: MeasuredData) -> dict[str, Settings]:
    """By the names of the scans, without those that were put aside or cannot be read."""
    found: dict[str, Settings] = {}
    for path in sorted(data.folder.glob(f"*/{RECORDING}")):
        if ASIDE in path.parent.name:
            continue
        try:
            text = Recording(path, path.stat().st_size).station_metadata().get(EXTRACTION, "")
            settings = json.loads(text or "{}")
        except (OperationError, OSError, ValueError):
            continue  # a scan that counts is refused where it is measured
        found[path.parent.name] = settings if isinstance(settings, dict) else {}
    return found


def find_changed_settings(settings: Mapping[str, Settings]) -> list[Text]:
    """Why scans do not belong together; empty if all had the same settings."""
    names = list(settings)
    others = (name for name in names[1:] if settings[name] != settings[names[0]])
    for name in others:
        return [message("performance-scans-set-otherwise", scan=name, other=names[0])]
    return []


def filter_note(settings: Mapping[str, Settings]) -> Text:
    """What the scans were filtered by before they were recorded; empty if by nothing."""
    first = next(iter(settings.values()), {})
    smoothing_px = first.get(SMOOTHING)
    named = [
        name if isinstance(value, dict) else f"{name} = {value}"
        for name, value in first.items()
        if name != SMOOTHING
    ]
    if isinstance(smoothing_px, float | int) and smoothing_px > 0:
        return message(
            "performance-smoothed",
            smoothing=rounded(smoothing_px, "px"),
            others=", ".join(named) or "none",
        )
    return message("performance-extracted-by", names=", ".join(named)) if named else ""
