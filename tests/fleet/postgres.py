"""Debian's PostgreSQL as a real server of an unprivileged user."""

import os
import pwd
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psycopg

from tests.bench.station.subprocess_station import free_port

STARTED_MODULES = ()  # PostgreSQL
PROGRAMS = sorted(Path("/usr/lib/postgresql").glob("*/bin"), reverse=True)
START_S = 60


def has_postgres() -> bool:
    return bool(PROGRAMS) and (os.getuid() != 0 or _unprivileged() is not None)


def _unprivileged() -> pwd.struct_passwd | None:
    """Who runs the server where the tests run as root, which PostgreSQL refuses."""
    for name in ("postgres", "nobody"):
        try:
            return pwd.getpwnam(name)
        except KeyError:
            continue
    return None


class PostgresServer:
    """A cluster in a folder of its own, on a free port of this machine."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._user = _unprivileged() if os.getuid() == 0 else None
        if self._user is not None:
            os.chown(folder, self._user.pw_uid, self._user.pw_gid)
        self._run("initdb", "-D", "data", "-U", "crenel", "-A", "trust", "-E", "UTF8", "-N")
        access = folder / "data/pg_hba.conf"
        access.write_text(f"host all reader 127.0.0.1/32 scram-sha-256\n{access.read_text()}")
        self.port = free_port()
        self._schemas = 0

    def start(self) -> None:
        options = f"-p {self.port} -c listen_addresses=127.0.0.1 -k {self._folder} -c fsync=off"
        self._run(
            "pg_ctl", "start", "-w", "-t", str(START_S), "-D", "data", "-l", "log", "-o", options
        )

    def stop(self) -> None:
        """At once, as after a power failure."""
        self._run("pg_ctl", "stop", "-w", "-D", "data", "-m", "immediate")

    def add_reader(self) -> None:
        """Adds the user ``reader``, who has the password ``secret`` and no rights of his own."""
        with psycopg.connect(self.address, autocommit=True) as connection:
            connection.execute("CREATE ROLE reader LOGIN PASSWORD 'secret'")

    @property
    def address(self) -> str:
        """Of the database of its own user, who may do everything."""
        return f"postgresql://crenel@127.0.0.1:{self.port}/postgres"

    def new_database(self) -> str:
        """The address of an empty schema: it takes far less time than a whole database."""
        self._schemas += 1
        name = f"test_{self._schemas}"
        with psycopg.connect(self.address, autocommit=True) as connection:
            connection.execute(f"CREATE SCHEMA {name}".encode())
        return f"{self.address}?options=-csearch_path%3D{name}"

    def _run(self, program: str, *arguments: str) -> None:
        user: dict[str, Any] = {}
        if self._user is not None:
            user = {"user": self._user.pw_name, "group": self._user.pw_gid, "extra_groups": []}
        with (self._folder.parent / f"{self._folder.name}.out").open("ab") as output:
            subprocess.run(
                [PROGRAMS[0] / program, *arguments],
                cwd=self._folder,
                env={"PATH": os.defpath, "LC_ALL": "C.UTF-8"},
                stdout=output,
                stderr=output,
                check=True,
                timeout=2 * START_S,
                **user,
            )


@contextmanager
def running_postgres() -> Iterator[PostgresServer]:
    # outside of the folders of pytest and of these tests, which only root may enter
    folder = Path(tempfile.mkdtemp(prefix="crenel-postgres-", dir="/tmp"))
    server = None
    try:
        server = PostgresServer(folder)
        server.start()
        yield server
    finally:
        if server is not None:
            server.stop()
        shutil.rmtree(folder)
        Path(f"{folder}.out").unlink(missing_ok=True)
