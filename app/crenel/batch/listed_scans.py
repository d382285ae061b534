"""The list of scans in a station's database, read beside a running station and of any version."""

import sqlite3
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path

READ_ONLY = ("mode=ro", "mode=ro&immutable=1")
"""The second for folders in which nothing may be created: no station works there."""
QUERY = "SELECT id, name, started_at, calibration_id FROM scan"
"""Columns that every version has."""


@dataclass(frozen=True)
class ListedScan:
    """What the station's list says of a scan; recordings of earlier versions do not state it."""

    name: str
    """As the operator last named it."""
    started_at: str = ""
    calibration_id: str = ""


def read_listed_scans(database: Path) -> dict[str, ListedScan]:
    """All scans in the list, by id; empty if it cannot be read: recordings speak for themselves."""
    for options in READ_ONLY:
        with (
            suppress(sqlite3.Error),
            closing(sqlite3.connect(f"{database.as_uri()}?{options}", uri=True)) as opened,
        ):
            return {row[0]: ListedScan(*row[1:]) for row in opened.execute(QUERY)}
    return {}
