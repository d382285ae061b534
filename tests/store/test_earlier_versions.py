"""Databases of every earlier version open with all that is in them; copies of data folders."""

import hashlib
import json
import sqlite3
import threading
from contextlib import closing
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.store.accounts import Role
from crenel.store.backup import LAST, NOTE, backup, last_backup
from crenel.store.database import Database
from crenel.store.schemas import RECORDINGS, SCHEMA_VERSION, SCHEMAS, SENSORS
from crenel.store.store import Store
from tests.store.conftest import FIGURES, open_database

AT = "2026-01-01T10:00:00Z"
FIGURES_TEXT = json.dumps(FIGURES)
SECRET_HASH = hashlib.sha256(b"secret").hexdigest()
ROWS = {
    "session": ("s1", "calibration", AT, AT),
    "journal": (1, "s1", AT, "point_taken", '{"face": "crest"}', "key"),
    "calibration": ("s1", "s1", "First", "sessions/s1/calibration.json", AT, FIGURES_TEXT, 1),
    "scan": ("c1", "Housing", "scans/c1", AT, 5, 6, 1.5, "s1"),
    "account": ("Ada", "admin", "hash", AT),
    "sign_in": ("token", "Ada", "tablet", AT, AT),
    "wall_link": ("w1", SECRET_HASH, "Hall", "Ada", AT),
    "audit": (1, AT, "Ada", "127.0.0.1", "signed in", "done"),
    "scraper": ("t1", SECRET_HASH, "Prometheus", "Ada", AT),
    "verification": ("s1", "s1", "verifications/s1", AT, "{}"),
    "temperature": (1, AT, 20.5, "typed"),
    "known_browser": ("token", "Ada", AT),
    "performance": ("s1", "s1", "performance/s1", AT, "{}"),
    "inspection": ("s1", "s1", "inspections/s1", AT, "{}"),
}
"""A row of each table, as the version that added the table wrote it."""
PRESENT = {"wall_link": "kiosk_link", "scraper": "api_token"}
"""Tables that have another name since."""
WRITTEN = (
    "43664ad9 56a866f7 afb7cf46 45fbed46 400fd397 39fed654 "
    "caac4511 4050eee5 aab19ca7 b3e8974b 507cb5f0 97a2d17d "
    "9994d6cf 49326725 6f0d232c 41dafb29"
)
"""Beginnings of the SHA-256 of each version's additions."""


def write_version(path: Path, version: int) -> set[str]:
    """Makes the database of a version with a row in each of its tables; returns their present
    names."""
    written = set()
    with closing(sqlite3.connect(path)) as made:
        for number, additions in enumerate(SCHEMAS[:version]):
            made.executescript(additions)
            for table, row in ROWS.items():
                if f"CREATE TABLE {table} (" in additions:
                    columns = ", ".join("?" * len(row))
                    made.execute(f"INSERT INTO {table} VALUES ({columns})", row)
                    written.add(PRESENT.get(table, table))
            if "ADD COLUMN interrupted TEXT" in additions:
                made.execute("UPDATE scan SET interrupted = 'The disk.'")
            made.commit()
            made.execute(f"PRAGMA user_version = {number + 1}")
    return written


@pytest.mark.parametrize("version", range(1, SCHEMA_VERSION + 1))
def test_a_database_of_each_version_opens_with_all_its_rows(tmp_path: Path, version: int) -> None:
    path = tmp_path / "station.db"
    written = write_version(path, version)
    path.chmod(0o644)
    with closing(Store(tmp_path)) as store:
        assert path.stat().st_mode & 0o777 == 0o600
        assert store.journal.latest_session("calibration") is not None
        (calibration,) = store.calibrations.all()
        assert (calibration.id, calibration.active, calibration.sensor) == ("s1", True, "")
        assert calibration.figures.total_um == FIGURES["total_um"]
        (scan,) = store.scans.all()
        assert (scan.id, scan.name, scan.points, scan.calibration_id) == ("c1", "Housing", 5, "s1")
        assert scan.interrupted == ("The disk." if version > SCHEMAS.index(RECORDINGS) else "")
        (row,) = store.journal.rows("s1")
        assert (row.kind, row.payload) == ("point_taken", {"face": "crest"})
        if "account" in written:
            (account,) = store.accounts.all()
            assert (account.name, account.role) == ("Ada", Role.admin)
            (entry,) = store.audit.newest(10)
            assert entry.act == "signed in"
            assert [link.name for link in store.kiosk_links.all()] == ["Hall"]
        if "api_token" in written:
            assert [token.name for token in store.api_tokens.all()] == ["Prometheus"]
            assert store.api_tokens.find("secret") is not None
        if "temperature" in written:
            assert store.temperatures.celsius_near(AT) == 20.5
    with closing(Database(path)) as again:
        tables = {PRESENT.get(table, table) for table in ROWS}
        counts = {name: again.read(f"SELECT count(*) FROM {name}")[0][0] for name in tables}
        assert counts == {name: int(name in written) for name in tables}
        assert again.read("PRAGMA user_version")[0][0] == SCHEMA_VERSION


def test_calibrations_of_an_earlier_version_are_those_of_the_only_sensor(tmp_path: Path) -> None:
    path = tmp_path / "station.db"
    write_version(path, SCHEMAS.index(SENSORS))
    later = ("s2", "s2", "Second", "c.json", AT, FIGURES_TEXT, 1)
    with closing(sqlite3.connect(path)) as old, old:
        old.execute("UPDATE calibration SET active = 0")
        old.execute("INSERT INTO session VALUES ('s2', 'calibration', ?, NULL)", (AT,))
        old.execute("INSERT INTO calibration VALUES (?, ?, ?, ?, ?, ?, ?)", later)
    with closing(Store(tmp_path)) as store:
        now = store.calibrations.active()
        assert now is not None
        assert (now.id, now.sensor) == ("s2", "")
        assert [one.active for one in store.calibrations.all()].count(True) == 1


def test_every_table_has_a_row_here() -> None:
    lines = "\n".join(SCHEMAS).splitlines()
    added = {line.split()[2] for line in lines if line.startswith("CREATE TABLE")}
    assert added - {"performance_by_touch"} == set(ROWS)


def test_the_additions_of_a_version_stay_as_they_were() -> None:
    """Databases have them already: a change is a new version."""
    found = [hashlib.sha256(additions.encode()).hexdigest()[:8] for additions in SCHEMAS]
    written = WRITTEN.split()
    assert found[: len(written)] == written
    assert len(found) == len(written), "add the digest of the new version"


def test_a_backup_of_a_folder_that_is_written_is_of_one_moment(store: Store) -> None:
    store.accounts.add("Ada", Role.admin, "three unrelated words")
    (store.folder / "arms/arm.json").write_text("{}")
    (store.folder / "logs").mkdir()
    (store.folder / "logs/station.jsonl").write_text("{}")
    store.journal.begin_session("s", "calibration")
    stopping, written = threading.Event(), 0

    def write() -> None:
        nonlocal written
        while not stopping.is_set():
            store.journal.append("s", "point_taken", {"n": written})
            (store.folder / "sessions" / f"{written}.csv").write_text("x")
            written += 1

    writer = threading.Thread(target=write)
    writer.start()
    try:
        while written < 20:
            continue
        made = backup(store.folder, store.folder.parent / "copies/one")
        before = written
    finally:
        stopping.set()
        writer.join()
    copy = Path(made.folder)
    assert last_backup(store.folder) == made
    assert json.loads((copy / NOTE).read_text())["of"] == str(store.folder)
    assert not (copy / "station.lock").exists()
    assert not (copy / "logs").exists()
    assert copy.stat().st_mode & 0o077 == 0
    with closing(Store(copy)) as again:
        rows = again.journal.rows("s")
        assert again.accounts.authenticate("Ada", "three unrelated words")
        assert again.check() == ""
    assert 20 <= len(rows) <= before
    assert [row.payload["n"] for row in rows] == list(range(len(rows)))
    for number in range(len(rows) - 1):
        assert (copy / f"sessions/{number}.csv").is_file()


def test_what_cannot_be_copied_is_refused_and_leaves_nothing(store: Store, tmp_path: Path) -> None:
    taken = tmp_path / "taken"
    taken.mkdir()
    (taken / "file").write_text("x")
    for data, output, code in (
        (tmp_path, tmp_path / "out", "no-data-folder"),
        (store.folder, taken, "output-taken"),
        (store.folder, store.folder / "sessions/copy", "output-inside"),
        (store.folder, taken / "file/copy", "file-is-no-folder"),
    ):
        with pytest.raises(OperationError) as refused:
            backup(data, output)
        assert refused.value.code in (code, "file-error"), refused.value
    assert sorted(path.name for path in tmp_path.iterdir()) == ["data", "taken"]
    assert not (store.folder / LAST).exists()
    assert last_backup(store.folder) is None


def test_backups_beside_the_data_do_not_hold_one_another(store: Store) -> None:
    first = backup(store.folder, store.folder / "backups/first")
    second = backup(store.folder, store.folder / "backups/second")
    assert first.files == second.files
    assert not (Path(second.folder) / "backups").exists()


def test_what_lies_elsewhere_by_a_link_is_copied_too(store: Store, tmp_path: Path) -> None:
    elsewhere = tmp_path / "larger disk"
    (elsewhere / "one").mkdir(parents=True)
    (elsewhere / "one/scan.mcap").write_text("x")
    (elsewhere / "again").symlink_to(elsewhere)
    (store.folder / "scans").rmdir()
    (store.folder / "scans").symlink_to(elsewhere)
    (store.folder / "arms/arm.json").symlink_to(elsewhere / "one/scan.mcap")
    with pytest.raises(OperationError, match="inside the data folder"):
        backup(store.folder, elsewhere / "copy")
    copy = Path(backup(store.folder, tmp_path / "copy").folder)
    assert [path.relative_to(copy).as_posix() for path in copy.rglob("*.mcap")] == [
        "scans/one/scan.mcap"
    ]
    assert (copy / "arms/arm.json").read_text() == "x"
    assert not (copy / "scans").is_symlink()


def test_a_damaged_database_is_reported(store: Store, tmp_path: Path) -> None:
    assert store.check() == ""
    store.close()
    file = store.folder / "station.db"
    raw = bytearray(file.read_bytes())
    raw[4096:12288] = b"\xff" * 8192
    file.write_bytes(raw)
    with pytest.raises(OperationError, match="cannot be copied"):
        backup(store.folder, tmp_path / "out")


@pytest.mark.parametrize(
    ("change", "reported"),
    [
        ("DROP TABLE verification", "table verification has no"),
        ("ALTER TABLE scan RENAME COLUMN frames TO other", "table scan has no frames"),
    ],
)
def test_a_database_without_a_column_is_refused(store: Store, change: str, reported: str) -> None:
    store.close()
    with open_database(store) as database, database:
        database.execute(change)
    with pytest.raises(OperationError, match=reported):
        Store(store.folder)


def test_an_api_token_is_shown_once_and_can_be_ended(store: Store) -> None:
    api_token, token = store.api_tokens.add("Prometheus", "Ada")
    assert store.api_tokens.all() == [api_token]
    assert store.api_tokens.find(token) == api_token
    assert not store.api_tokens.find("")
    assert not store.api_tokens.find(f"{token}x")
    assert store.login_sessions.principal(token) is None, "it opens nothing else"
    store.api_tokens.remove(api_token.id)
    assert not store.api_tokens.find(token)
