"""What the things with datasheets were last used for, as far as the station's records name them."""

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.findings import Quality
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.formats.session.calibration_session import ARM, OBJECT, SENSOR
from crenel.gauges.quick.document import GAUGE
from crenel.messages.message import Text, message
from crenel.messages.uncertainty import point_quantity
from crenel.operations.datasheets.documents import DatasheetIdentity, DatasheetKind
from crenel.operations.datasheets.view import LastUse
from crenel.store.calibrations import CalibrationRecord
from crenel.store.session_records import PerformanceSummaryFigures, VerificationFigures
from crenel.store.store import Store

Thing = tuple[DatasheetKind, str]
"""An arm, a sensor or an object by its serial number, a gauge by its name."""
COPIES: Mapping[DatasheetKind, str] = {"arm": ARM, "object": OBJECT, "sensor": SENSOR}
"""The copies of datasheets in the folder of a calibration."""
SELECTED = "selected"
"""What a calibration adds to the copy of a colour camera's datasheet."""
RESULTS: Mapping[str, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "cancelled": "neutral",
}


def content_version(content: bytes, kind: DatasheetKind) -> str:
    """Tells the contents of a datasheet apart; a calibration's copy has that of its datasheet."""
    if kind == "sensor":
        try:
            document = json.loads(content)
        except ValueError:
            document = None
        if isinstance(document, dict):
            document.pop(SELECTED, None)
            content = json.dumps(document, sort_keys=True).encode()
    return hashlib.sha256(content).hexdigest()


@dataclass(frozen=True)
class CalibrationInUse:
    """A calibration by which the station scans."""

    name: str
    things: frozenset[Thing]
    versions: Mapping[DatasheetKind, str]


@dataclass(frozen=True)
class Uses:
    """The newest record of each thing, and the calibrations in use."""

    newest: Mapping[Thing, LastUse]
    in_use: tuple[CalibrationInUse, ...]
    tests: Mapping[Thing, Path]
    """The folder of the newest result with each thing."""

    def last(self, found: DatasheetIdentity | None) -> LastUse | None:
        """The newest use of this thing; None where no record names it."""
        thing = _thing(found)
        return self.newest.get(thing) if thing else None

    def calibrations(self, found: DatasheetIdentity | None, version: str) -> list[str]:
        """Names of the calibrations in use that rest on this thing."""
        return [one.name for one in self._of(found, version)]

    def note(self, found: DatasheetIdentity | None, version: str) -> Text:
        """That a calibration in use, or the last result with a gauge, rests on another version;
        empty if none does."""
        thing = _thing(found)
        if found and thing and found.kind == "gauge" and thing in self.tests:
            copy = _version_of(self.tests[thing] / GAUGE, "gauge")
            return message("last-result-has-other-version") if copy not in ("", version) else ""
        for one in self._of(found, version):
            if found and one.versions.get(found.kind, version) != version:
                return message("calibration-has-other-version", name=one.name)
        return ""

    def _of(self, found: DatasheetIdentity | None, version: str) -> Iterator[CalibrationInUse]:
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
    tests: dict[Thing, Path] = {}
    for use, things, folder in _uses(store, calibrations):
        for thing in things:
            if thing not in newest or use.at > newest[thing].at:
                newest[thing] = use
                tests[thing] = folder
    active = (one for one in calibrations if one.active)
    in_use = tuple(CalibrationInUse(one.name, _things(one), _versions(one)) for one in active)
    return Uses(newest, in_use, tests)


def _uses(
    store: Store, calibrations: Iterable[CalibrationRecord]
) -> Iterator[tuple[LastUse, Iterable[Thing], Path]]:
    known = {record.id: record for record in calibrations}
    for record in known.values():
        total = point_quantity(record.figures.total_um)
        text = message("calibration-with-total", name=record.name, total=total)
        yield (
            LastUse(record.accepted_at, record.figures.verdict, text),
            _things(record),
            record.file.parent,
        )
    sessions: list[tuple[str, str, str, VerificationFigures | PerformanceSummaryFigures, Path]] = [
        *(
            (one.accepted_at, one.calibration_id, one.figures.gauge, one.figures, one.folder)
            for one in store.verifications.all()
        ),
        *(
            (one.ended_at, one.calibration_id, one.figures.artefact, one.figures, one.folder)
            for one in store.performances.all()
        ),
    ]
    for at, calibration_id, gauges, figures, folder in sessions:
        # several spheres are joined
        things: set[Thing] = {("gauge", one) for one in (gauges, *gauges.split(", "))}
        if calibration_id in known:
            things |= {one for one in _things(known[calibration_id]) if one[0] != "object"}
        yield LastUse(at, RESULTS[figures.result], figures.text), things, folder


def _things(record: CalibrationRecord) -> frozenset[Thing]:
    figures = record.figures
    found: tuple[Thing, ...] = (
        ("arm", figures.arm_serial),
        ("object", figures.object_serial),
        ("sensor", figures.sensor_serial),
    )
    return frozenset(one for one in found if one[1])


def _versions(record: CalibrationRecord) -> dict[DatasheetKind, str]:
    """The versions of the copies that can be read; the result keeps its figures without them all
    the same."""
    versions = {kind: _version_of(record.file.parent / name, kind) for kind, name in COPIES.items()}
    return {kind: version for kind, version in versions.items() if version}


def _version_of(path: Path, kind: DatasheetKind) -> str:
    """The version of the copy of a datasheet; empty where it cannot be read."""
    try:
        with convert_io_errors(path):
            return content_version(read_bounded(path), kind)
    except OperationError:
        return ""
