"""The tables of the station's database, and the additions of each version."""

import sqlite3
from contextlib import closing
from functools import lru_cache

FIRST = """
CREATE TABLE session (
    id TEXT PRIMARY KEY,
    kind TEXT NOT NULL,
    started_at TEXT NOT NULL,
    ended_at TEXT
) STRICT;

CREATE TABLE journal (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    session_id TEXT NOT NULL REFERENCES session (id),
    at TEXT NOT NULL,
    kind TEXT NOT NULL,
    payload TEXT NOT NULL,
    command_key TEXT UNIQUE
) STRICT;
CREATE INDEX journal_of_a_session ON journal (session_id, number);
CREATE TRIGGER journal_rows_stay BEFORE DELETE ON journal
    BEGIN SELECT RAISE(ABORT, 'the journal is append-only'); END;
CREATE TRIGGER journal_rows_keep BEFORE UPDATE ON journal
    BEGIN SELECT RAISE(ABORT, 'the journal is append-only'); END;

CREATE TABLE calibration (
    id TEXT PRIMARY KEY,
    session_id TEXT NOT NULL REFERENCES session (id),
    name TEXT NOT NULL,
    file TEXT NOT NULL,
    accepted_at TEXT NOT NULL,
    figures TEXT NOT NULL,
    active INTEGER NOT NULL CHECK (active IN (0, 1))
) STRICT;
CREATE UNIQUE INDEX one_active_calibration ON calibration (active) WHERE active = 1;

CREATE TABLE scan (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    folder TEXT NOT NULL,
    started_at TEXT NOT NULL,
    points INTEGER NOT NULL,
    frames INTEGER NOT NULL,
    seconds REAL NOT NULL,
    calibration_id TEXT NOT NULL
) STRICT;
"""
ACCESS = """
CREATE TABLE account (
    name TEXT PRIMARY KEY COLLATE NOCASE,
    role TEXT NOT NULL CHECK (role IN ('viewer', 'operator', 'admin')),
    password TEXT NOT NULL,
    made_at TEXT NOT NULL
) STRICT;

CREATE TABLE sign_in (
    token TEXT PRIMARY KEY,
    account TEXT NOT NULL COLLATE NOCASE REFERENCES account (name) ON DELETE CASCADE,
    device TEXT NOT NULL,
    begun_at TEXT NOT NULL,
    seen_at TEXT NOT NULL
) STRICT;

CREATE TABLE wall_link (
    id TEXT PRIMARY KEY,
    token TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    made_by TEXT NOT NULL,
    made_at TEXT NOT NULL
) STRICT;

CREATE TABLE audit (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    at TEXT NOT NULL,
    who TEXT NOT NULL,
    address TEXT NOT NULL,
    act TEXT NOT NULL,
    outcome TEXT NOT NULL
) STRICT;
CREATE TRIGGER audit_rows_stay BEFORE DELETE ON audit
    BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_rows_keep BEFORE UPDATE ON audit
    BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
"""
SUPERVISION = """
CREATE TABLE scraper (
    id TEXT PRIMARY KEY,
    token TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    made_by TEXT NOT NULL,
    made_at TEXT NOT NULL
) STRICT;
"""
VERIFICATIONS = """
CREATE TABLE verification (
    id TEXT PRIMARY KEY REFERENCES session (id),
    calibration_id TEXT NOT NULL REFERENCES calibration (id),
    folder TEXT NOT NULL,
    accepted_at TEXT NOT NULL,
    figures TEXT NOT NULL
) STRICT;
CREATE INDEX verification_of_a_calibration ON verification (calibration_id, accepted_at);

CREATE TABLE temperature (
    number INTEGER PRIMARY KEY AUTOINCREMENT,
    at TEXT NOT NULL,
    celsius REAL NOT NULL,
    source TEXT NOT NULL
) STRICT;
CREATE INDEX temperature_in_time ON temperature (at);
"""
KNOWN_BROWSERS = """
CREATE TABLE known_browser (
    token TEXT NOT NULL,
    account TEXT NOT NULL COLLATE NOCASE REFERENCES account (name) ON DELETE CASCADE,
    made_at TEXT NOT NULL,
    PRIMARY KEY (token, account)
) STRICT;
"""
RECORDINGS = """
ALTER TABLE scan ADD COLUMN interrupted TEXT NOT NULL DEFAULT '';
ALTER TABLE scan ADD COLUMN recording_bytes INTEGER;
"""
MESSAGES = """
ALTER TABLE audit ADD COLUMN act_message TEXT;
ALTER TABLE audit ADD COLUMN outcome_message TEXT;
ALTER TABLE scan ADD COLUMN name_message TEXT;
ALTER TABLE scan ADD COLUMN interrupted_message TEXT;
"""
KIOSKS = """
ALTER TABLE wall_link RENAME TO kiosk_link;
ALTER TABLE scraper RENAME TO api_token;
"""
SENSORS = """
ALTER TABLE calibration ADD COLUMN sensor TEXT NOT NULL DEFAULT '';
DROP INDEX one_active_calibration;
CREATE UNIQUE INDEX one_active_calibration ON calibration (sensor) WHERE active = 1;
"""
PERFORMANCES = """
CREATE TABLE performance (
    id TEXT PRIMARY KEY REFERENCES session (id),
    calibration_id TEXT NOT NULL REFERENCES calibration (id),
    folder TEXT NOT NULL,
    ended_at TEXT NOT NULL,
    figures TEXT NOT NULL
) STRICT;
"""
PROVIDERS = """
ALTER TABLE account ADD COLUMN provider TEXT NOT NULL DEFAULT '';
ALTER TABLE account ADD COLUMN subject TEXT NOT NULL DEFAULT '';
CREATE UNIQUE INDEX one_account_of_a_subject ON account (provider, subject) WHERE provider <> '';
"""
TESTS_BY_TOUCH = """
CREATE TABLE performance_by_touch (
    id TEXT PRIMARY KEY REFERENCES session (id),
    calibration_id TEXT REFERENCES calibration (id),
    folder TEXT NOT NULL,
    ended_at TEXT NOT NULL,
    figures TEXT NOT NULL
) STRICT;
INSERT INTO performance_by_touch SELECT * FROM performance ORDER BY rowid;
DROP TABLE performance;
ALTER TABLE performance_by_touch RENAME TO performance;
"""
"""Tests by touch need no calibration."""
SUSPENSIONS = """
ALTER TABLE scan ADD COLUMN suspended_s REAL NOT NULL DEFAULT 0;
"""
COMPLETENESS = """
ALTER TABLE scan ADD COLUMN frames_left_out INTEGER NOT NULL DEFAULT 0;
ALTER TABLE scan ADD COLUMN frames_with_line INTEGER NOT NULL DEFAULT 0;
"""
PARTS = """
ALTER TABLE scan ADD COLUMN part TEXT NOT NULL DEFAULT '{}';
ALTER TABLE scan ADD COLUMN frames_too_fast INTEGER;
ALTER TABLE scan ADD COLUMN frames_lost INTEGER;
ALTER TABLE scan ADD COLUMN sources TEXT NOT NULL DEFAULT '[]';
"""
INSPECTIONS = """
CREATE TABLE inspection (
    id TEXT PRIMARY KEY REFERENCES session (id),
    calibration_id TEXT NOT NULL REFERENCES calibration (id),
    folder TEXT NOT NULL,
    ended_at TEXT NOT NULL,
    figures TEXT NOT NULL
) STRICT;
"""
SCHEMAS = (
    FIRST,
    ACCESS,
    SUPERVISION,
    VERIFICATIONS,
    KNOWN_BROWSERS,
    RECORDINGS,
    MESSAGES,
    KIOSKS,
    SENSORS,
    PERFORMANCES,
    PROVIDERS,
    TESTS_BY_TOUCH,
    SUSPENSIONS,
    COMPLETENESS,
    PARTS,
    INSPECTIONS,
)
"""The additions of each version of the database."""
SCHEMA_VERSION = len(SCHEMAS)


def read_columns(connection: sqlite3.Connection) -> set[tuple[str, str]]:
    """Every column, by table and name."""
    found = connection.execute(
        "SELECT one.name, its.name FROM sqlite_master AS one, pragma_table_info(one.name) AS its"
        " WHERE one.type = 'table'"
    )
    return {(row[0], row[1]) for row in found}


@lru_cache
def current_columns() -> set[tuple[str, str]]:
    """The columns of a new database."""
    with closing(sqlite3.connect(":memory:")) as made:
        made.executescript(" ".join(SCHEMAS))
        return read_columns(made)
