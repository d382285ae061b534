"""Addresses of schedulers that cannot work end the command with one line."""

import subprocess
import threading
from pathlib import Path

import pytest

pytest.importorskip("distributed")

from crenel.batch.cluster import RemoteScheduler
from crenel.errors import OperationError
from tests.batch.filled import fill_station
from tests.batch.test_rebuild import CRENEL
from tests.running.usual import usual

pytestmark = pytest.mark.device

STARTED_MODULES = ("crenel.cli.main",)


@pytest.mark.parametrize(
    ("address", "said"),
    [
        ("", "'' is no address of a scheduler"),
        ("tcp://host", "missing port number"),
        ("tcp://host:port", "is no address"),
        ("http://host:80", "'http://host:80' is no address of a scheduler"),
        ("inproc://a", "is no address"),
        ("tls://127.0.0.1:9", "TLS needs certificates"),
    ],
)
def test_what_is_no_address_is_refused_before_a_client_is_made(address: str, said: str) -> None:
    with pytest.raises(OperationError, match=said):
        RemoteScheduler(address)


@pytest.mark.parametrize("address", usual(["tcp://127.0.0.1:9", "nonsense"], 1, pytest.mark.soak))
def test_a_scheduler_that_is_not_there_is_one_line(address: str, tmp_path: Path) -> None:
    fill_station(tmp_path / "data", ("one",)).close()
    command = (CRENEL, "rebuild", "data", "--scheduler", address)
    ran = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=100)
    assert ran.returncode == 1
    (line,) = ran.stderr.splitlines()
    assert address in line


def test_a_scheduler_that_is_waited_for_costs_no_threads() -> None:
    before = set(threading.enumerate())
    with pytest.raises(OperationError, match=r"127\.0\.0\.1:9"):
        RemoteScheduler("tcp://127.0.0.1:9")
    assert set(threading.enumerate()) <= before
