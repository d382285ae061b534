"""When the things with datasheets were last used, as far as the station's records name them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from app.operations.datasheets.documents import DatasheetIdentity, DatasheetKind
from app.store.store import Store

Use = tuple[DatasheetKind, str]
"""An arm, a sensor or an object by its serial number, a gauge by its name."""


@dataclass(frozen=True)
class LastUses:
    """The newest record of each thing, ISO 8601."""

    known: Mapping[Use, str]

    def of(self, found: DatasheetIdentity | None) -> str | None:
        """When this thing was last used; None where no record names it."""
        if found is None:
            return None
        called = found.name if found.kind == "gauge" else found.serial_number
        return self.known.get((found.kind, called)) if called else None


def read_last_uses(store: Store) -> LastUses:
    """From the accepted calibrations and verifications, and the performance tests."""
    known: dict[Use, str] = {}
    for at, use in _uses(store):
        if at > known.get(use, ""):
            known[use] = at
    return LastUses(known)


def _uses(store: Store) -> Iterator[tuple[str, Use]]:
    calibrations = {record.id: record for record in store.calibrations.all()}
    for calibration in calibrations.values():
        figures, at = calibration.figures, calibration.accepted_at
        yield at, ("arm", figures.arm_serial)
        yield at, ("object", figures.object_serial)
        yield at, ("sensor", figures.sensor_serial)
    sessions = [
        *(
            (one.accepted_at, one.calibration_id, one.figures.gauge)
            for one in store.verifications.all()
        ),
        *(
            (one.ended_at, one.calibration_id, one.figures.artefact)
            for one in store.performances.all()
        ),
    ]
    for at, calibration_id, gauges in sessions:
        for gauge in {gauges, *gauges.split(", ")}:  # several spheres are joined
            yield at, ("gauge", gauge)
        if calibration_id in calibrations:
            figures = calibrations[calibration_id].figures
            yield at, ("arm", figures.arm_serial)
            yield at, ("sensor", figures.sensor_serial)
