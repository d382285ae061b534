"""The arms, objects and sensors that the station knows, from files in its data folder."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from app.errors import OperationError
from app.findings import Finding
from app.formats.datasheets.arm import read_arm
from app.formats.datasheets.sensor import SensorDatasheet, read_sensor
from app.formats.datasheets.target import read_object
from app.formats.file_names import check_name
from app.messages.message import message
from app.metrology.arm.kinematics import Arm
from app.metrology.targets.target import CalibrationTarget

Datasheet = TypeVar("Datasheet")


@dataclass(frozen=True)
class DatasheetEntry(Generic[Datasheet]):
    """One readable file; its id is the file's name without ``.json``."""

    id: str
    path: Path
    datasheet: Datasheet


@dataclass(frozen=True)
class DatasheetLibrary:
    """What can be chosen; files that cannot be read are findings."""

    arms: Mapping[str, DatasheetEntry[Arm]]
    objects: Mapping[str, DatasheetEntry[CalibrationTarget]]
    sensors: Mapping[str, DatasheetEntry[SensorDatasheet]]
    findings: tuple[Finding, ...]

    def has(self, field: str, entry_id: str) -> bool:
        """Whether ``arm``, ``object`` or ``sensor`` has an entry of this id."""
        known: Mapping[str, Mapping[str, object]] = {
            "arm": self.arms,
            "object": self.objects,
            "sensor": self.sensors,
        }
        return entry_id in known.get(field, {})


def read_library(data_folder: Path) -> DatasheetLibrary:
    """Reads ``arms/*.json``, ``objects/*.json`` and ``sensors/*.json``."""
    findings: list[Finding] = []
    return DatasheetLibrary(
        arms=_entries(data_folder / "arms", read_arm, findings),
        objects=_entries(data_folder / "objects", read_object, findings),
        sensors=_entries(data_folder / "sensors", read_sensor, findings),
        findings=tuple(findings),
    )


def _entries(
    folder: Path, read: Callable[[Path], Datasheet], findings: list[Finding]
) -> dict[str, DatasheetEntry[Datasheet]]:
    entries: dict[str, DatasheetEntry[Datasheet]] = {}
    for path in sorted(folder.glob("*.json")):
        try:
            check_name(path)
            entries[path.stem] = DatasheetEntry(path.stem, path, read(path))
        except OperationError as error:
            findings.append(Finding("attention", error.text, message("correct-remove-file")))
    return entries
