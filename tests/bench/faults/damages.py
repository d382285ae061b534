"""What may become of the files in a data folder."""

import os
import random
import re
import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from tests.bench.faults.furnished import FOLDERS, FolderRecords

PAGE_BYTES = 4096
RANDOM_BYTES = 5000
HUGE_BYTES = 1 << 42
"""Of a sparse file, which takes no disk space."""
FOREIGN = b'{"format": "another/program", "version": 1, "url": 7, "figures": [null, {}]}'
DamageMethod = Callable[[Path, random.Random], None]


@dataclass(frozen=True)
class Damage:
    """One thing that somebody or something did to a data folder."""

    name: str
    do: Callable[[Path, random.Random], None]
    """To the data folder."""
    expected_message: str = ""
    """What must be reported of it, a regular expression; empty where it harms nothing."""
    affected_ids: tuple[str, ...] = ()
    """The ids of the records that it takes."""
    by_others: bool = False
    """Files are not the station's: it must run as another user than their owner."""


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _empty(path: Path, rng: random.Random) -> None:
    path.write_bytes(b"")


def _truncate(path: Path, rng: random.Random) -> None:
    os.truncate(path, path.stat().st_size // 2)


def _scramble(path: Path, rng: random.Random) -> None:
    path.write_bytes(rng.randbytes(RANDOM_BYTES))


def _turn(path: Path, rng: random.Random) -> None:
    """Some bytes in the middle are others: the length is right."""
    content = bytearray(path.read_bytes())
    for _ in range(40):
        content[rng.randrange(len(content))] = rng.randrange(256)
    path.write_bytes(content)


def _overwrite_with(content: bytes) -> DamageMethod:
    def put(path: Path, rng: random.Random) -> None:
        path.write_bytes(content)

    return put


def _folder(path: Path, rng: random.Random) -> None:
    _remove(path)
    path.mkdir()
    (path / "within").write_text("something")


def _pipe(path: Path, rng: random.Random) -> None:
    _remove(path)
    os.mkfifo(path)


def _link(target: str) -> DamageMethod:
    def link(path: Path, rng: random.Random) -> None:
        _remove(path)
        path.symlink_to(target)

    return link


def _loop(path: Path, rng: random.Random) -> None:
    _remove(path)
    path.symlink_to(path.name)


def _huge(path: Path, rng: random.Random) -> None:
    os.truncate(path, HUGE_BYTES)


def _take(path: Path, rng: random.Random) -> None:
    _remove(path)


def _forbid(path: Path, rng: random.Random) -> None:
    path.chmod(0)


DAMAGE_METHODS: dict[str, DamageMethod] = {
    "emptied": _empty,
    "cut in half": _truncate,
    "random bytes": _scramble,
    "some bytes turned": _turn,
    "foreign JSON": _overwrite_with(FOREIGN),
    "JSON without end": _overwrite_with(b"[" * 200_000),
    "a number of 5000 digits": _overwrite_with(b'{"format": ' + b"7" * 5000 + b"}"),
    "half a character": _overwrite_with(
        b'{"format": "\\ud800", "url": "\\ud800", "folder": "\\ud800"}'
    ),
    "a folder in its place": _folder,
    "a pipe in its place": _pipe,
    "a loop of links": _loop,
    "a link to nothing": _link("nothing-there"),
    "a link to /dev/zero": _link("/dev/zero"),
    "4 TB": _huge,
    "gone": _take,
    "forbidden": _forbid,
}


@dataclass(frozen=True)
class DataFile:
    """A file of a data folder."""

    path: str
    expected_message: str = ""
    """As of ``Damage``."""
    affected_ids: tuple[str, ...] = ()


def list_data_files(kept: FolderRecords) -> list[DataFile]:
    """A file of every kind."""
    scan, flow = f"scans/{kept.scans[0]}", f"sessions/{kept.flow}"
    calibration = f"sessions/{kept.calibration}"
    return [
        DataFile("station.db", r"station\.db", kept.records),
        DataFile("station.lock"),
        DataFile("notifications.json", "notifications"),
        DataFile("scan_settings.json", "settings"),
        DataFile("last_backup.json"),
        *(DataFile(f"{folder}/spare.json", r"spare") for folder in ("arms", "objects", "sensors")),
        DataFile("gauges/spare.nominal.json", "spare"),
        DataFile(f"{calibration}/calibration.json", r"calibration", (kept.calibration,)),
        DataFile(f"{calibration}/arm.json", r"arm\.json|calibration", (kept.calibration,)),
        DataFile(f"{flow}/probing.csv"),
        *(
            DataFile(f"performance/{kept.performance}/{name}")
            for name in ("plan.json", "touches.csv")
        ),
        DataFile(f"{scan}/scan.mcap", "recording"),
        DataFile(f"{scan}/cloud.ply"),
        DataFile("logs/station.jsonl"),
    ]


def file_damages(kept: FolderRecords) -> list[Damage]:
    """Every way in every place."""

    def damage(place: DataFile, way: str) -> Damage:
        def do(data: Path, rng: random.Random) -> None:
            DAMAGE_METHODS[way](data / place.path, rng)

        kind = re.sub("|".join((kept.scans[0], kept.flow, kept.performance)), "…", place.path)
        harmless = (
            way == "some bytes turned"
            or (way == "gone" and "spare" in place.path)
            # SQLite reads no further than the header says
            or (way == "4 TB" and place.path == "station.db")
        )
        return Damage(
            f"{kind}: {way}",
            do,
            "" if harmless else place.expected_message,
            place.affected_ids,
            way == "forbidden",
        )

    return [damage(place, way) for place in list_data_files(kept) for way in DAMAGE_METHODS]


def _statement(*statements: str) -> Callable[[Path, random.Random], None]:
    def do(data: Path, rng: random.Random) -> None:
        with closing(sqlite3.connect(data / "station.db")) as database:
            for trigger in ("journal_rows_keep", "journal_rows_stay"):
                database.execute(f"DROP TRIGGER {trigger}")
            for statement in statements:
                database.execute(statement)
            database.commit()

    return do


def _scramble_page(data: Path, rng: random.Random) -> None:
    """One page of the database, not the first, is of random bytes."""
    path = data / "station.db"
    with path.open("r+b") as file:
        page = rng.randrange(1, path.stat().st_size // PAGE_BYTES)
        file.seek(page * PAGE_BYTES)
        file.write(rng.randbytes(PAGE_BYTES))


def _break_texts(data: Path, rng: random.Random) -> None:
    """Texts in the database are not UTF-8."""
    path = data / "station.db"
    path.write_bytes(path.read_bytes().replace(b"Scan 1", b"Sc\xe4n 1"))


def _no_database(data: Path, rng: random.Random) -> None:
    (data / "station.db").unlink()


def _file_for_folder(name: str) -> Callable[[Path, random.Random], None]:
    def do(data: Path, rng: random.Random) -> None:
        _remove(data / name)
        (data / name).write_text("no folder")

    return do


def _latin(data: Path, rng: random.Random) -> None:
    for folder in FOLDERS:
        name = os.fsencode(data / folder) + b"/Pr\xfcfk\xf6rper.json"
        with open(name, "wb") as file:
            file.write(b"{}")


def _leftovers(data: Path, rng: random.Random) -> None:
    for scan in (data / "scans").iterdir():
        (scan / ".cloud.ply.deadbeef.part").write_bytes(rng.randbytes(RANDOM_BYTES))
    (data / "scans" / "a file").write_text("x")
    (data / "scans" / "empty").mkdir()
    for name, content in (("foreign", rng.randbytes(RANDOM_BYTES)), ("nothing", b"")):
        (data / "scans" / name).mkdir()
        (data / "scans" / name / "scan.mcap").write_bytes(content)
    os.mkfifo(data / "scans" / "empty" / "scan.mcap")


ROW = "INSERT INTO journal (session_id, at, kind, payload) VALUES ('{}', '2026-01-01', '{}', '{}')"


def database_damages(kept: FolderRecords) -> list[Damage]:
    """What stands in the database is of a newer version, of another program, or damaged."""
    session = rf"{kept.flow}|journal"

    def row(name: str, kind: str, payload: str) -> Damage:
        opened = (kept.flow, kept.verification, kept.open_performance)
        rows = [ROW.format(one, kind, payload) for one in opened]
        return Damage(f"journal: {name}", _statement(*rows), session)

    every = kept.records
    return [
        row("a row that is no JSON", "point_taken", "no JSON"),
        row("a row that is a list", "point_taken", "[1, 2]"),
        row("a row of an unknown kind", "of_a_newer_version", "{}"),
        row("a row without its fields", "point_taken", "{}"),
        row("a row nested without end", "point_taken", '{"a":' * 5000),
        Damage("database: a newer schema", _statement("PRAGMA user_version = 99"), "later", every),
        Damage(
            "database: of another program",
            _statement("PRAGMA user_version = 0"),
            "another program",
            every,
        ),
        Damage("database: a table gone", _statement("DROP TABLE scan"), "database", every),
        Damage(
            "database: a column gone",
            _statement("ALTER TABLE scan RENAME COLUMN frames TO other"),
            "database",
            every,
        ),
        Damage("database: a damaged page", _scramble_page, "database|damaged|not-readable", every),
        Damage("database: texts that are not UTF-8", _break_texts),
        Damage("database: not there beside folders", _no_database, r"station\.db", every),
        Damage(
            "calibration: figures that cannot be read",
            _statement("UPDATE calibration SET figures = 'none'"),
            "cannot be read",
            (kept.calibration,),
        ),
        Damage(
            "calibration: figures of another kind",
            _statement("UPDATE calibration SET figures = '[1e999]'"),
            "cannot be read",
            (kept.calibration,),
        ),
        Damage(
            "calibration: a date that is none",
            _statement("UPDATE calibration SET accepted_at = 'yesterday'"),
            "cannot be read",
            (kept.calibration,),
        ),
        *(
            Damage(
                f"performance test: {name}",
                _statement(f"UPDATE performance SET figures = '{figures}'"),
                "performance-cannot-read",
                (kept.performance,),
            )
            for name, figures in (
                ("figures that cannot be read", "none"),
                ("figures of another kind", "[1e999]"),
            )
        ),
        Damage("scan: a date that is none", _statement("UPDATE scan SET started_at = 'yesterday'")),
        Damage(
            "scan: a folder outside",
            _statement("UPDATE scan SET folder = '../../../etc'"),
            "recording",
        ),
        Damage("account: of no role", _statement("UPDATE account SET password = 'x'")),
    ]


def folder_damages() -> list[Damage]:
    """Foreign and missing things beside the files."""
    found = [
        Damage(f"a file in the place of {name}", _file_for_folder(name), name)
        for name in (*FOLDERS, "logs", "backups")
    ]
    return [
        *found,
        Damage("names in Latin-1", _latin, "file-name-is-not-utf-8"),
        Damage("leftovers among the scans", _leftovers),
    ]
