"""What a bench says where its station does not go on."""

import math
import os
from multiprocessing.connection import Connection

import pytest

from app.bench.station import subprocess_station as apart
from app.errors import OperationError

pytestmark = [pytest.mark.device, pytest.mark.soak]


def _gone(pipe: Connection) -> None:
    pipe.send("ready")


def _silent(pipe: Connection) -> None:
    pipe.recv()


def test_a_station_that_ends_is_reported() -> None:
    with (
        pytest.raises(OperationError, match="the station under test does not respond"),
        apart.run_in_process(_gone) as (pipe, _),
    ):
        list(iter(pipe.recv, None))


def test_a_station_that_does_not_start_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(apart, "PATIENCE_S", 0.1)
    with (
        pytest.raises(OperationError, match=r"does not start.*nothing came of it in") as reported,
        apart.run_in_process(_silent),
    ):
        pass
    assert "a file" not in reported.value.line


def test_the_memory_of_a_process_is_reported() -> None:
    assert apart.memory_mb(os.getpid()) > 10
    assert math.isnan(apart.memory_mb(1 << 30))
