"""Entries of the catalogue for tests."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta

from crenel.fleet.catalogue.entry import CatalogueEntry, EntryFigure, EntryFile, EntryKind

START = datetime(2026, 3, 2, 8, 0, tzinfo=UTC)


def entry_of(
    number: int = 0,
    station: str = "room-1",
    kind: EntryKind = "scan",
    label: str = "Housing 4711",
    **fields: object,
) -> CatalogueEntry:
    """A record, an hour after the one of the number before."""
    made = CatalogueEntry(
        station=station,
        kind=kind,
        id=f"{kind}-{number}",
        content=f"{number:016x}",
        at=START + timedelta(hours=number),
        label=label,
        operator="Ada",
        arm_serial="A-17",
        sensor_serial="L-3",
        calibration_id="cal-1",
        calibration_sha256="c" * 64,
        software="crenel 0.1.0",
        points=12_345,
        current_at=START + timedelta(hours=number),
        place="/data",
        files=(
            EntryFile("cloud.ply", 9, "b" * 64),
            EntryFile("scan.mcap", 1000 + number, "a" * 64),
        ),
    )
    return replace(made, **fields)  # type: ignore[arg-type]


def figure_of(value: float, quantity: str = "location-scan", **fields: object) -> EntryFigure:
    made = EntryFigure("L_Dia.2x1:Ps", quantity, value, "µm", 2.5, 40.0, "pass")
    return replace(made, **fields)  # type: ignore[arg-type]
