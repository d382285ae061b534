"""What the documents of a record say, as entries of the catalogue."""

import logging
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from crenel.archive.manifest import Kind
from crenel.errors import OperationError
from crenel.fleet.catalogue.entry import CatalogueEntry, EntryFile
from crenel.fleet.collection.figures import (
    arm_check_figures,
    calibration_figures,
    performance_figures,
    tip_check_figures,
    verification_figures,
)
from crenel.formats.clouds.ply import find_vertices
from crenel.formats.json_document import Software
from crenel.formats.open_file import open_file
from crenel.formats.recording.reader import (
    ARM_SERIAL,
    LARGEST_PREAMBLE,
    SCAN_CALIBRATION,
    SCAN_NAME,
    SCAN_STARTED,
    SENSOR_SERIAL,
    Recording,
)
from crenel.formats.results.acceptance import ACCEPTANCE, Acceptance
from crenel.formats.results.arm_checks import ARM_CHECK, TIP_CHECK, ArmCheckFile, TipCheckFile
from crenel.formats.results.calibration import CALIBRATION, CalibrationFile
from crenel.formats.results.scan_record import CLOUD
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.plan.document import PLAN, RESULT, PerformancePlan
from crenel.gauges.quick.document import VERIFICATION, VerificationFile
from crenel.timestamps import is_moment, parse_moment

if TYPE_CHECKING:
    from crenel.fleet.collection.places import SourceRecord

log = logging.getLogger(__name__)
SCAN, ARM = "scan.mcap", "arm.json"
DOCUMENTS = (ACCEPTANCE, CALIBRATION, VERIFICATION, RESULT, PLAN, ARM_CHECK, TIP_CHECK)
"""Read whole; all others of a record stay where they are."""
HEADS = (SCAN, CLOUD)
HEAD_BYTES = LARGEST_PREAMBLE
"""The bytes of a head that are read, enough for what it says of itself."""


@dataclass(frozen=True, slots=True)
class RecordFolder:
    """A record with the folder of its documents, and the entry that all of them share."""

    record: "SourceRecord"
    folder: Path
    plain: CatalogueEntry


Reader = Callable[[RecordFolder], CatalogueEntry]


def read_entries(
    station: str, record: "SourceRecord", folder: Path, place: str
) -> list[CatalogueEntry]:
    """The entries of a record: one, or one of each check of an arm session.

    A document that cannot be read is logged; the record is then listed without its content.
    """
    shas = {file.path: file.sha256 for file in record.files}
    plain = CatalogueEntry(
        station=station,
        kind="session",
        id=record.id,
        content=record.content,
        at=record.changed_at,
        label=record.label or "",
        calibration_sha256=shas.get(CALIBRATION, ""),
        arm_sha256=shas.get(ARM, ""),
        current_at=record.current_at,
        archived_at=record.archived_at,
        place=place,
        files=tuple(EntryFile(file.path, file.bytes, file.sha256) for file in record.files),
    )
    found = []
    for name, read in READERS[record.kind]:
        if name in shas:
            try:
                found.append(read(RecordFolder(record, folder, plain)))
            except (OperationError, ValueError) as error:
                why = str(error).replace(f"{folder}/", "")  # it may be temporary
                log.warning("%s %s: %s cannot be read: %s", station, record.id, name, why)
    if record.kind == "performance":
        found = found[:1]
    if record.kind == "scans" and not found:
        return [replace(plain, kind="scan")]
    return found or [plain]


def _read_calibration(of: RecordFolder) -> CatalogueEntry:
    document = CalibrationFile.read(of.folder / CALIBRATION)
    accepted = _read_acceptance(of)
    made_at = document.created_at if accepted is None else accepted.accepted_at
    verdict = document.verdict
    return replace(
        of.plain,
        kind="calibration",
        at=_moment(made_at, of.plain.at),
        label="" if accepted is None else accepted.name,
        operator=(accepted.operator if accepted else document.operator) or "",
        simulated=accepted is not None and accepted.simulated,
        arm_serial=document.serial_numbers.arm,
        sensor_serial=document.serial_numbers.sensor,
        object_serial=document.serial_numbers.object,
        calibration_id=of.plain.id,
        software=_name_software(document.software),
        verdict="" if verdict is None else verdict.quality,
        temperature_c=None if accepted is None else accepted.temperature_c,
        figures=calibration_figures(document, None if accepted is None else accepted.usable_um),
    )


def _read_acceptance(of: RecordFolder) -> Acceptance | None:
    path = of.folder / ACCEPTANCE
    return Acceptance.read(path) if path.exists() else None


def _read_verification(of: RecordFolder) -> CatalogueEntry:
    document = VerificationFile.read(of.folder / VERIFICATION)
    return replace(
        of.plain,
        kind="verification",
        at=_moment(document.accepted_at, of.plain.at),
        label=document.gauge.name,
        operator=document.operator,
        simulated=document.simulated,
        arm_serial=document.serial_numbers.arm,
        sensor_serial=document.serial_numbers.sensor,
        object_serial=document.gauge.serial_number,
        calibration_id=document.calibration.id,
        software=_name_software(document.software),
        verdict=document.verdict.result,
        temperature_c=document.temperature.end_c,
        points=sum(cloud.points for cloud in document.clouds),
        figures=verification_figures(document),
    )


def _read_performance(of: RecordFolder) -> CatalogueEntry:
    document = PerformanceFile.read(of.folder / RESULT)
    artefact = document.sphere or document.length or document.plate
    return replace(
        of.plain,
        kind="performance",
        at=_moment(document.ended_at, of.plain.at),
        label="" if artefact is None else artefact.name,
        operator=document.operator,
        simulated=document.simulated,
        arm_serial=document.serial_numbers.arm,
        sensor_serial=document.serial_numbers.sensor,
        object_serial="" if artefact is None else artefact.serial_number,
        software=_name_software(document.software),
        verdict=document.verdict.result,
        temperature_c=document.temperature_c[1],
        figures=performance_figures(document),
    )


def _read_plan(of: RecordFolder) -> CatalogueEntry:
    """Reads the plan of a performance test without a result: it was cancelled."""
    plan = PerformancePlan.read(of.folder / PLAN)
    return replace(
        of.plain,
        kind="performance",
        at=_moment(plan.started_at, of.plain.at),
        operator=plan.operator,
        simulated=plan.simulated,
    )


def _read_arm_check(of: RecordFolder) -> CatalogueEntry:
    document = ArmCheckFile.read(of.folder / ARM_CHECK)
    return replace(
        _add_check(of, document),
        kind="arm_check",
        verdict=document.verdict,
        figures=arm_check_figures(document),
    )


def _read_tip_check(of: RecordFolder) -> CatalogueEntry:
    document = TipCheckFile.read(of.folder / TIP_CHECK)
    return replace(
        _add_check(of, document),
        kind="tip_check",
        verdict="" if document.decision == "none" else document.decision,
        figures=tip_check_figures(document),
    )


def _add_check(of: RecordFolder, document: ArmCheckFile | TipCheckFile) -> CatalogueEntry:
    return replace(
        of.plain,
        at=_moment(document.checked_at, of.plain.at),
        label=document.arm_name,
        operator=document.operator,
        simulated=document.simulated,
        arm_serial=document.arm_serial,
        software=_name_software(document.software),
        temperature_c=document.temperature_c,
    )


def _read_scan(of: RecordFolder) -> CatalogueEntry:
    """By the beginnings of its recording and its cloud."""
    about = Recording(of.folder / SCAN, 0).station_metadata()
    return replace(
        of.plain,
        kind="scan",
        at=_moment(about.get(SCAN_STARTED), of.plain.at),
        label=of.plain.label or about.get(SCAN_NAME, ""),
        arm_serial=about.get(ARM_SERIAL, ""),
        sensor_serial=about.get(SENSOR_SERIAL, ""),
        calibration_id=about.get(SCAN_CALIBRATION) or of.record.calibration_id,
        points=_count_points(of.folder / CLOUD, of.record.points),
    )


def _count_points(path: Path, known: int | None) -> int | None:
    """By the header of a cloud; without one, as the station counted them."""
    with suppress(OperationError, OSError), open_file(path) as file:
        return find_vertices(path, file).count
    return known


def _moment(text: str | None, otherwise: datetime) -> datetime:
    return parse_moment(text) if text is not None and is_moment(text) else otherwise


def _name_software(software: Software | None) -> str:
    return "" if software is None else f"{software.name} {software.version}"


READERS: dict[Kind, tuple[tuple[str, Reader], ...]] = {
    "sessions": (
        (CALIBRATION, _read_calibration),
        (ARM_CHECK, _read_arm_check),
        (TIP_CHECK, _read_tip_check),
    ),
    "scans": ((SCAN, _read_scan),),
    "verifications": ((VERIFICATION, _read_verification),),
    "performance": ((RESULT, _read_performance), (PLAN, _read_plan)),
}
"""By the folder of a record: what is read, in this order."""
