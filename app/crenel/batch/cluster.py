"""The workers: processes of this machine, or any cluster of Dask."""

import logging
import os
import socket
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, Protocol

from crenel.batch.patience import GIVE_UP_S
from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity

if TYPE_CHECKING:
    from distributed import Client, LocalCluster

CONNECT_S = 5.0
CLOSE_S = 30.0
"""Dask may take so long to end on a busy machine; what is cut short leaves its loop and sockets."""
PAUSE_S = 1.0
SCRATCH = "temporary-directory"
"""The setting of Dask that says where its scheduler puts a folder that it leaves behind."""
NO_PAGES = "127.0.0.1:0"
SECURE_SCHEMES = ("tls", "wss")
SCHEMES = ("tcp", "ws", *SECURE_SCHEMES)
"""Schemes of the addresses of schedulers."""


class Cluster(Protocol):
    """Workers that are asked through a client of Dask."""

    threads: int
    """The threads that one task uses."""

    @property
    def client(self) -> "Client":
        """Connected, as far as is known."""

    def reconnect(self, say: Callable[[Text], None]) -> None:
        """Waits until the scheduler is there again; raises ``OperationError`` after too long."""

    def close(self) -> None:
        """Ends what was started here; idempotent."""


class LocalWorkers:
    """Worker processes of this machine; Dask replaces one that ends.

    Args:
        count: of processes; each does one task at a time.

    Raises:
        OperationError: Dask is not installed.
    """

    def __init__(self, count: int) -> None:
        dask = _load_dask()
        from dask import config

        self.threads = max((os.cpu_count() or 1) // count, 1)
        self._folder = TemporaryDirectory(prefix="crenel-workers-")
        with config.set({SCRATCH: self._folder.name}):
            self._cluster: LocalCluster = dask.LocalCluster(
                n_workers=count,
                threads_per_worker=1,
                processes=True,
                host="127.0.0.1",
                dashboard_address="127.0.0.1:0",
                local_directory=self._folder.name,
                silence_logs=logging.CRITICAL,
            )
        self.client: Client = dask.Client(self._cluster, set_as_default=False)

    def reconnect(self, say: Callable[[Text], None]) -> None:
        raise _scheduler_error(str(self._cluster.scheduler_address))

    def close(self) -> None:
        with suppress(Exception):  # whatever Dask says about processes that have ended
            self.client.close(CLOSE_S)
        with suppress(Exception):
            self._cluster.close(CLOSE_S)
        self._folder.cleanup()


class OwnWorker:
    """One worker, a thread of this process; no other process can reach it or its scheduler.

    Args:
        scratch: a folder for temporary files.

    Raises:
        OperationError: Dask is not installed.
    """

    def __init__(self, scratch: Path) -> None:
        dask = _load_dask()
        from dask import config

        self.threads = os.cpu_count() or 1
        routes = [f"distributed.{one}.http.routes" for one in ("scheduler", "worker")]
        with config.set({**dict.fromkeys(routes, ()), SCRATCH: str(scratch)}):
            self._cluster: LocalCluster = dask.LocalCluster(
                n_workers=1,
                threads_per_worker=1,
                processes=False,
                dashboard_address=NO_PAGES,
                worker_dashboard_address=NO_PAGES,
                scheduler_kwargs={"dashboard": False},
                local_directory=str(scratch),
                silence_logs=logging.CRITICAL,
            )
        self.client: Client = dask.Client(self._cluster, set_as_default=False)

    def reconnect(self, say: Callable[[Text], None]) -> None:
        raise _scheduler_error(str(self._cluster.scheduler_address))

    def close(self) -> None:
        with suppress(Exception):
            self.client.close(CLOSE_S)
        with suppress(Exception):
            self._cluster.close(CLOSE_S)


class RemoteScheduler:
    """The workers of a scheduler that runs somewhere.

    Args:
        address: as ``tcp://host:8786``.
        threads: of one task.
        give_up_s: a scheduler that is lost is waited for so long.

    Raises:
        OperationError: Dask is not installed, the address is none, or the scheduler does not
            answer.
    """

    def __init__(self, address: str, threads: int = 1, give_up_s: float = GIVE_UP_S) -> None:
        self._dask, self._address, self.threads = _load_dask(), address, threads
        self._give_up_s = give_up_s
        _check_address(address)
        try:
            self.client: Client = self._connect()
        except (OSError, ValueError) as error:
            raise OperationError(
                "no-scheduler",
                message("batch-no-scheduler", address=address),
                str(error),
                message("batch-start-scheduler"),
            ) from error

    def reconnect(self, say: Callable[[Text], None]) -> None:
        with suppress(Exception):
            self.client.close(CLOSE_S)
        say(message("batch-scheduler-away", address=self._address))
        deadline_s = time.monotonic() + self._give_up_s
        while time.monotonic() < deadline_s:
            try:
                self.client = self._connect()
            except (OSError, ValueError):
                time.sleep(PAUSE_S)
            else:
                say(message("batch-scheduler-back"))
                return
        raise _scheduler_error(self._address, self._give_up_s)

    def close(self) -> None:
        with suppress(Exception):
            self.client.close(CLOSE_S)

    def _connect(self) -> "Client":
        from distributed.comm.addressing import get_address_host_port

        # a client that finds no scheduler leaves its thread and sockets behind
        socket.create_connection(get_address_host_port(self._address), CONNECT_S).close()
        client: Client = self._dask.Client(
            self._address, timeout=CONNECT_S, set_as_default=False, name="crenel"
        )
        return client


def _load_dask() -> Any:
    try:
        import distributed
    except ImportError as error:
        raise OperationError(
            "no-dask",
            message("batch-no-dask"),
            str(error),
            message("batch-install-dask"),
        ) from error
    # what it logs of workers and schedulers that are lost is its own matter
    for name in ("distributed", "distributed.client", "tornado", "tornado.application", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    return distributed


def _check_address(address: str) -> None:
    """Raises ``OperationError`` for an address with which a client of Dask cannot be made: what is
    left of such a client ends with a traceback."""
    from distributed.comm.addressing import parse_address, parse_host_port
    from distributed.security import Security

    why: Text = ""
    try:
        scheme, place = parse_address(address)
        parse_host_port(place)
    except ValueError as error:
        scheme, why = "", str(error)
    security = Security().get_connection_args("client")
    if scheme in SECURE_SCHEMES and security.get("ssl_context") is None:
        why = message("batch-no-certificates")
    if why or scheme not in SCHEMES:
        raise OperationError(
            "no-scheduler",
            message("batch-no-address", address=repr(address)),
            why,
            message("batch-give-address"),
        )


def _scheduler_error(address: str, waited_s: float = GIVE_UP_S) -> OperationError:
    return OperationError(
        "no-scheduler",
        message("batch-no-scheduler", address=address),
        message("batch-waited", time=quantity(waited_s / 60, "min")),
        message("batch-run-again-nothing-done-twice"),
    )
