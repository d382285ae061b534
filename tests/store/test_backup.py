"""Copies of data folders, also while they are written; and API tokens."""

import json
import threading
from contextlib import closing
from pathlib import Path

import pytest

from app.errors import OperationError
from app.store.accounts import Role
from app.store.backup import LAST, NOTE, backup, last_backup
from app.store.store import Store
from tests.store.conftest import open_database


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


def test_what_cannot_be_backed_up_is_refused_and_leaves_nothing(
    store: Store, tmp_path: Path
) -> None:
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
def test_a_database_without_one_of_its_columns_is_refused(
    store: Store, change: str, reported: str
) -> None:
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
