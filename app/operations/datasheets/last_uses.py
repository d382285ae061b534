"""What the things with datasheets were last used for, as far as the station's records name them."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from app.errors import OperationError
from app.findings import Quality
from app.formats.json_document import file_sha256
from app.formats.session.calibration_session import ARM, OBJECT
from app.messages.message import Text, message
from app.messages.uncertainty import point_quantity
from app.operations.datasheets.documents import DatasheetIdentity, DatasheetKind
from app.operations.datasheets.view import LastUse
from app.store.calibrations import CalibrationRecord
from app.store.session_records import PerformanceSummaryFigures, VerificationFigures
from app.store.store import Store

Thing = tuple[DatasheetKind, str]
"""An arm, a sensor or an object by its serial number, a gauge by its name."""
COPIES: Mapping[DatasheetKind, str] = {"arm": ARM, "object": OBJECT}
"""The unchanged copies of datasheets in the folder of a calibration."""
RESULTS: Mapping[str, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "cancelled": "neutral",
}


@dataclass(frozen=True)
class _CalibrationInUse:
    """A calibration by which the station scans."""

    name: str
    things: frozenset[Thing]
    versions: Mapping[DatasheetKind, str]


@dataclass(frozen=True)
class Uses:
    """The newest record of each thing, and the calibrations in use."""

    newest: Mapping[Thing, LastUse]
    in_use: tuple[_CalibrationInUse, ...]

    def last(self, found: DatasheetIdentity | None) -> LastUse | None:
        """The newest use of this thing; None where no record names it."""
        thing = _thing(found)
        return self.newest.get(thing) if thing else None

    def calibrations(self, found: DatasheetIdentity | None, version: str) -> list[str]:
        """Names of the calibrations in use that rest on this thing."""
        return [one.name for one in self._of(found, version)]

    def note(self, found: DatasheetIdentity | None, version: str) -> Text:
        """That a calibration in use rests on another version; empty if none does."""
        for one in self._of(found, version):
            if found and one.versions.get(found.kind, version) != version:
                return message("calibration-has-other-version", name=one.name)
        return ""

    def _of(self, found: DatasheetIdentity | None, version: str) -> Iterator[_CalibrationInUse]:
        thing = _thing(found)
        for one in self.in_use:
            if found and (thing in one.things or one.versions.get(found.kind) == version):
                yield one


def _thing(found: DatasheetIdentity | None) -> Thing | None:
    if found is None:
        return None
    called = found.name if found.kind == "gauge" else found.serial_number
    return (found.kind, called) if called else None


def read_uses(store: Store) -> Uses:
    """From the accepted calibrations and verifications, and the performance tests."""
    calibrations = store.calibrations.all()
    newest: dict[Thing, LastUse] = {}
    for use, things in _uses(store, calibrations):
        for thing in things:
            if thing not in newest or use.at > newest[thing].at:
                newest[thing] = use
    active = (one for one in calibrations if one.active)
    return Uses(
        newest, tuple(_CalibrationInUse(one.name, _things(one), _versions(one)) for one in active)
    )


def _uses(
    store: Store, calibrations: Iterable[CalibrationRecord]
) -> Iterator[tuple[LastUse, Iterable[Thing]]]:
    known = {record.id: record for record in calibrations}
    for record in known.values():
        total = point_quantity(record.figures.total_um)
        text = message("calibration-with-total", name=record.name, total=total)
        yield LastUse(record.accepted_at, record.figures.verdict, text), _things(record)
    sessions: list[tuple[str, str, str, VerificationFigures | PerformanceSummaryFigures]] = [
        *(
            (one.accepted_at, one.calibration_id, one.figures.gauge, one.figures)
            for one in store.verifications.all()
        ),
        *(
            (one.ended_at, one.calibration_id, one.figures.artefact, one.figures)
            for one in store.performances.all()
        ),
    ]
    for at, calibration_id, gauges, figures in sessions:
        # several spheres are joined
        things: set[Thing] = {("gauge", one) for one in (gauges, *gauges.split(", "))}
        if calibration_id in known:
            things |= {one for one in _things(known[calibration_id]) if one[0] != "object"}
        yield LastUse(at, RESULTS[figures.result], figures.text), things


def _things(record: CalibrationRecord) -> frozenset[Thing]:
    figures = record.figures
    found: tuple[Thing, ...] = (
        ("arm", figures.arm_serial),
        ("object", figures.object_serial),
        ("sensor", figures.sensor_serial),
    )
    return frozenset(one for one in found if one[1])


def _versions(record: CalibrationRecord) -> dict[DatasheetKind, str]:
    """Of the copies that can be read."""
    found: dict[DatasheetKind, str] = {}
    for kind, name in COPIES.items():
        path: Path = record.file.parent / name
        try:
            found[kind] = file_sha256(path)
        except OperationError:
            continue  # the result keeps its figures all the same
    return found
