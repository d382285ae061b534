"""The report of a scan, from its folder alone: its part, its figures, and what it lacks."""

from pathlib import Path

from crenel.errors import OperationError, sentence
from crenel.formats.recording.completeness import MissingFrames
from crenel.formats.results.scan_record import CLOUD, SCAN, ScanFile
from crenel.messages.message import Text, message, quantity
from crenel.messages.uncertainty import point_quantity
from crenel.report.content import (
    Facts,
    Findings,
    Pictures,
    Report,
    ReportFinding,
    ReportTable,
    Section,
    TextBlock,
    Verdict,
    signatures,
)
from crenel.report.figure import Figure, Photo
from crenel.report.formatting import UNKNOWN, format_moment, simulation_notes, software_name
from crenel.workflows.clouds.cloud_picture import cloud_photo


def scan_report(folder: Path) -> Report[Text]:
    """The report of the ``scan.json`` in the folder of a scan.

    Raises:
        OperationError: there is none, or it is damaged.
    """
    scan = ScanFile.read(folder / SCAN)
    findings = _findings(scan)
    sections: list[Section[Text]] = [
        Section(message("report-part"), [Facts(_part(scan))]),
        Section(message("report-scan"), [Facts(_facts(scan))]),
        *_picture(folder, scan),
        *([Section(message("findings"), [Findings(findings)])] if findings else []),
        signatures(scan.operator),
        *_sources(scan),
    ]
    return Report(
        title=message("scan-report"),
        number=folder.resolve().name,
        station=scan.station or message("measuring-arm"),
        date=format_moment(scan.started_at),
        verdict=_verdict(scan),
        sections=sections,
        notes=simulation_notes(scan.simulated),
    )


def _missing(scan: ScanFile) -> MissingFrames:
    return MissingFrames(scan.frames_without_points, scan.frames_with_line)


def _verdict(scan: ScanFile) -> Verdict[Text]:
    """A scan is no measurement against limits: only whether all of it is there."""
    missing = _missing(scan)
    if missing.is_too_much:
        return Verdict("bad", message("scan-incomplete"), sentence(missing.text))
    points = message("scan-has-points", count=scan.points)
    if scan.note:
        return Verdict("attention", message("scan-ended-early"), points)
    return Verdict("neutral", message("scan-complete"), points)


def _part(scan: ScanFile) -> list[tuple[Text, Text]]:
    part = scan.part
    return [
        (message("report-part"), part.part or UNKNOWN),
        (message("report-serial-number"), part.serial_number or UNKNOWN),
        (message("report-order"), part.order or UNKNOWN),
        (message("report-customer"), part.customer or UNKNOWN),
    ]


def _facts(scan: ScanFile) -> list[tuple[Text, Text]]:
    rows: list[tuple[Text, Text]] = [
        (message("report-name"), scan.name),
        (message("begun"), format_moment(scan.started_at)),
        (message("operator"), scan.operator or UNKNOWN),
        (message("points"), str(scan.points)),
        (message("report-pictures"), str(scan.frames)),
        (message("report-duration"), quantity(scan.seconds, "s")),
        (message("calibration"), scan.calibration or UNKNOWN),
        (message("arm"), scan.arm_serial or UNKNOWN),
        (message("sensor-heading"), scan.sensor_serial or UNKNOWN),
        (message("software"), software_name(scan.software.version)),
    ]
    if scan.calibration_um is not None:
        point = message("total-k-1", total=point_quantity(scan.calibration_um))
        rows.insert(7, (message("report-point-uncertainty"), point))
    return rows


def _findings(scan: ScanFile) -> list[ReportFinding[Text]]:
    found: list[ReportFinding[Text]] = []
    if scan.note:
        found.append(ReportFinding("attention", scan.note, ""))
    for count, text in (
        (scan.frames_too_fast, message("scan-frames-too-fast", count=scan.frames_too_fast or 0)),
        (scan.frames_lost, message("scan-frames-lost", count=scan.frames_lost or 0)),
        (
            scan.frames_without_points,
            message("scan-frames-without-points", count=scan.frames_without_points),
        ),
    ):
        if count:
            found.append(ReportFinding("attention", text, ""))
    if len({one.calibration_id for one in scan.sources}) > 1:
        text = message("merged-with-own-calibrations")
        found.append(ReportFinding("neutral", text, ""))
    return found


def _sources(scan: ScanFile) -> list[Section[Text]]:
    """The scans that a merged cloud is made of."""
    if not scan.sources:
        return []
    table = ReportTable[Text](
        (
            message("report-scan"),
            message("report-number"),
            message("calibration"),
            message("points"),
        ),
        [(one.name, one.id, one.calibration_id, str(one.points)) for one in scan.sources],
        (40, 26, 26, 16),
        3,
    )
    note = TextBlock[Text](message("merged-in-frame-of-arm-not-moved"), True)
    return [Section(message("merged-of"), [table, note], together=False)]


def _picture(folder: Path, scan: ScanFile) -> list[Section[Text]]:
    try:
        jpeg, width, height = cloud_photo(folder / CLOUD)
    except OperationError:  # the archive keeps no clouds that can be made again
        return []
    figure = Figure[Text](480, 480 * height / width, message("picture-of-cloud"))
    figure.items.append(Photo((0, 0), figure.width, figure.height, jpeg))
    caption = message("picture-of-cloud-seen-from", name=scan.name)
    return [Section(message("cloud"), [Pictures([(figure, caption)], 2)])]
