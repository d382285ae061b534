"""The arms, objects, sensors and gauges that the station knows, from files in its data folder."""

import os
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.formats.datasheets.target import read_object
from crenel.formats.file_names import check_name, display_path, escape_unprintable
from crenel.formats.io_errors import convert_all_errors
from crenel.formats.json_document import parse_format, read_text
from crenel.gauges.exchange.read_certificate import read_sphere_certificate
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.targets.target import CalibrationTarget

AnyGauge = GaugeFile | LengthStandardFile
Datasheet = TypeVar("Datasheet")
Content = TypeVar("Content")
GAUGE_ENDINGS = (".nominal.json", ".json")
CERTIFICATE_ENDING = ".xml"
FRESH_S = 2.0
"""While the operator chooses, files that were added are seen after this time."""


@dataclass(frozen=True)
class DatasheetEntry(Generic[Datasheet]):
    """One readable file; its id is the file's name without its ending."""

    id: str
    path: Path
    datasheet: Datasheet


@dataclass(frozen=True)
class DatasheetLibrary:
    """What can be chosen; files that cannot be read are findings."""

    arms: Mapping[str, DatasheetEntry[AnyArm]]
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


@dataclass(frozen=True)
class RefusedCertificate:
    """A digital certificate that does not describe a gauge."""

    id: str
    reason: Text


@dataclass(frozen=True)
class Gauges(Generic[Datasheet]):
    """The data folder's gauges by id; datasheets that cannot be read are findings."""

    known: Mapping[str, DatasheetEntry[Datasheet]]
    findings: tuple[Finding, ...]
    refused: tuple[RefusedCertificate, ...] = ()


class FolderContent(Generic[Content]):
    """What a data folder has, read again only while the operator chooses from it."""

    def __init__(self, read: Callable[[Path], Content], data_folder: Path) -> None:
        self._read, self._data_folder = read, data_folder
        self._latest: tuple[float, Content] | None = None

    def forget(self) -> None:
        """Has it read again at the next look."""
        self._latest = None

    def latest(self, choosing: bool) -> Content:
        """As it was read last, or is now."""
        latest = self._latest
        if latest is None or (choosing and time.monotonic() - latest[0] > FRESH_S):
            latest = self._latest = (time.monotonic(), self._read(self._data_folder))
        return latest[1]


def guess_entry(serial_numbers: Mapping[str, str], connected: str, last: str) -> str:
    """Which datasheet of a kind is meant: that of the connected device's serial number, else the
    last choice, else the only one there is; empty if it is not clear.

    Args:
        serial_numbers: of the datasheets, by their ids.
        connected: serial number of the connected device; empty if it states none.
    """
    same = [name for name, number in serial_numbers.items() if connected and number == connected]
    if len(same) == 1:
        return same[0]
    if last in serial_numbers:
        return last
    return next(iter(serial_numbers)) if len(serial_numbers) == 1 else ""


def guess_arm(arms: Mapping[str, DatasheetEntry[AnyArm]], connected: str, last: str) -> str:
    """The same of the datasheets of arms."""
    numbers = {name: entry.datasheet.serial_number for name, entry in arms.items()}
    return guess_entry(numbers, connected, last)


def read_library(data_folder: Path) -> DatasheetLibrary:
    """Reads ``arms/*.json``, ``objects/*.json`` and ``sensors/*.json``."""
    findings: list[Finding] = []
    return DatasheetLibrary(
        arms=_entries(data_folder / "arms", read_any_arm, findings),
        objects=_entries(data_folder / "objects", read_object, findings),
        sensors=_entries(data_folder / "sensors", _read_station_sensor, findings),
        findings=tuple(findings),
    )


def read_arms(data_folder: Path) -> Mapping[str, DatasheetEntry[AnyArm]]:
    """Those of ``arms/*.json`` alone that can be read."""
    return _entries(data_folder / "arms", read_any_arm, [])


def _read_station_sensor(path: Path) -> SensorDatasheet:
    return parse_station_sensor(read_text(path), path)


def parse_station_sensor(text: str, path: Path) -> SensorDatasheet:
    """A sensor whose pictures are grey: a station's driver selects the pixels of raw ones."""
    sensor = SensorDatasheet.parse_text(text, path)
    if sensor.bayer is None:
        return sensor
    raise OperationError(
        "sensor-raw",
        message("datasheet-says-raw", path=display_path(path)),
        message("driver-selects-raw-pixels"),
        message("move-bayer-to-station-toml"),
    )


def read_gauges(data_folder: Path) -> Gauges[GaugeFile]:
    """Reads the plates and spheres, as ``read_any_gauges``."""
    found = read_any_gauges(data_folder)
    known = {
        name: DatasheetEntry(name, entry.path, entry.datasheet)
        for name, entry in found.known.items()
        if isinstance(entry.datasheet, GaugeFile)
    }
    return Gauges(known, found.findings, found.refused)


def read_any_gauges(data_folder: Path) -> Gauges[AnyGauge]:
    """Reads ``gauges/*.json``, ``*.nominal.json``, and ``*.xml``: plates, spheres, length
    standards, and digital certificates of spheres.

    Of a certificate and a datasheet of the same name, the datasheet counts.
    """
    folder, findings = data_folder / "gauges", list[Finding]()
    known = _entries(folder, read_any_gauge, findings, GAUGE_ENDINGS)
    refused = []
    for path in list_files(folder, CERTIFICATE_ENDING, findings):
        if path.stem in known:
            continue
        try:
            gauge = _evaluate(path, lambda path: read_sphere_certificate(path).gauge)
            known[path.stem] = DatasheetEntry(path.stem, path, gauge)
        except OperationError as error:
            name = escape_unprintable(path.stem)
            refused.append(RefusedCertificate(name, sentence(error.why or error.what)))
    return Gauges(known, tuple(findings), tuple(refused))


def list_set_aside(data_folder: Path) -> list[Text]:
    """Which files of arms, objects, sensors and gauges cannot be read: one sentence for each."""
    library, gauges = read_library(data_folder), read_any_gauges(data_folder)
    refused = {f"gauges/{one.id}{CERTIFICATE_ENDING}": one.reason for one in gauges.refused}
    return [
        *(one.text for one in (*library.findings, *gauges.findings)),
        *(message("certificate-set-aside", file=file, why=why) for file, why in refused.items()),
    ]


def read_any_gauge(path: Path) -> AnyGauge:
    """A gauge or a length standard; raises ``OperationError`` naming file and field."""
    return parse_any_gauge(read_text(path), path)


def parse_any_gauge(text: str, path: Path) -> AnyGauge:
    """Reads the text of a file of this name; as ``read_any_gauge``."""
    if parse_format(text, path) == LengthStandardFile.FORMAT:
        return LengthStandardFile.parse_text(text, path)
    return GaugeFile.parse_text(text, path)


def _entries(
    folder: Path,
    read: Callable[[Path], Datasheet],
    findings: list[Finding],
    endings: tuple[str, ...] = (".json",),
) -> dict[str, DatasheetEntry[Datasheet]]:
    entries: dict[str, DatasheetEntry[Datasheet]] = {}
    for path in list_files(folder, ".json", findings):
        entry_id = next(path.name.removesuffix(e) for e in endings if path.name.endswith(e))
        try:
            entries.setdefault(entry_id, DatasheetEntry(entry_id, path, _evaluate(path, read)))
        except OperationError as error:
            findings.append(Finding("attention", error.text, message("correct-remove-file")))
    return entries


def _evaluate(path: Path, read: Callable[[Path], Datasheet]) -> Datasheet:
    """What a file says; whatever goes wrong there is an ``OperationError`` that names it."""
    with convert_all_errors(path):
        check_name(path)
        return read(path)


def list_files(folder: Path, ending: str, findings: list[Finding]) -> list[Path]:
    """The files of a folder by their ending, without hidden ones; a folder that cannot be listed is
    a finding."""
    try:
        with convert_all_errors(folder):
            names = sorted(os.listdir(folder)) if os.path.lexists(folder) else []
    except OperationError as error:
        findings.append(Finding("attention", error.text))
        names = []
    return [folder / one for one in names if one.endswith(ending) and not one.startswith(".")]
