"""The commands of the compose file for three workers, as processes: containers are not needed."""

import json
import os
import shlex
import socket
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import pytest
import yaml

pytest.importorskip("distributed")

from tests.batch.filled import fill_archive
from tests.bench.fleet.dask_processes import DEADLINE_S
from tests.bench.station.subprocess_station import free_port

pytestmark = pytest.mark.device
COMPOSE = Path(__file__).resolve().parents[2] / "docker/workers.compose.yaml"
USE = "run --rm crenel "
"""Before the command that the file names as an example."""
PROGRAMS = {
    "dask": [sys.executable, "-m", "dask"],
    "crenel": [str(Path(sys.executable).with_name("crenel"))],
}


def command_of(service: Mapping[str, Any], here: Mapping[str, str]) -> list[str]:
    """What a service runs, with the places and addresses of this machine."""
    (program,) = service["entrypoint"]
    return PROGRAMS[program] + [here.get(word, word) for word in service["command"]]


@contextmanager
def running(command: Sequence[str], log: Path) -> Iterator[None]:
    with log.open("ab") as output:
        process = subprocess.Popen(command, stdout=output, stderr=output, env=os.environ)
    try:
        yield
    finally:
        process.terminate()
        try:
            process.wait(DEADLINE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait(DEADLINE_S)


def test_three_workers_rebuild_an_archive(tmp_path: Path) -> None:
    scans = [f"scan-{number}" for number in range(6)]
    fill_archive(tmp_path / "archive", tmp_path / "data", scans)
    text = COMPOSE.read_text()
    services = yaml.safe_load(text)["services"]
    port, address = free_port(), "tcp://scheduler:8786"
    here = {
        "0.0.0.0": "127.0.0.1",
        "8786": str(port),
        ":8787": "127.0.0.1:0",
        address: f"tcp://127.0.0.1:{port}",
        "/tmp": str(tmp_path),
        "/archive": str(tmp_path / "archive"),
        "/results": str(tmp_path / "results"),
    }
    (example,) = (line.partition(USE)[2] for line in text.splitlines() if USE in line)
    command = {"command": shlex.split(example), "entrypoint": services["crenel"]["entrypoint"]}
    with ExitStack() as started:
        scheduler, worker = services["scheduler"], services["worker"]
        started.enter_context(running(command_of(scheduler, here), tmp_path / "scheduler.log"))
        for number in range(worker["deploy"]["replicas"]):
            log = tmp_path / f"worker-{number}.log"
            started.enter_context(running(command_of(worker, here), log))
        words = [*until_it_answers(command_of(command, here)), "--json"]
        made = subprocess.run(words, capture_output=True, text=True, timeout=2 * DEADLINE_S)
    logs = "".join(path.read_text() for path in tmp_path.glob("*.log"))
    assert made.returncode == 0, made.stderr + logs
    assert json.loads(made.stdout)["made"] == len(scans)
    assert len(list((tmp_path / "results").glob("*.ply"))) == len(scans)
    assert sum("Registered to" in path.read_text() for path in tmp_path.glob("worker-*.log")) == 3


def until_it_answers(command: list[str]) -> list[str]:
    """The command, which waits for no scheduler, after the scheduler answers."""
    from distributed import Client
    from distributed.comm.addressing import get_address_host_port

    deadline_s = time.monotonic() + DEADLINE_S
    while True:
        try:
            # a client that finds no scheduler leaves its thread and sockets behind
            socket.create_connection(get_address_host_port(command[-1]), 5).close()
            with Client(command[-1], timeout=DEADLINE_S, set_as_default=False) as client:
                client.wait_for_workers(3, timeout=DEADLINE_S)
                return command
        except OSError:
            assert time.monotonic() < deadline_s, "the scheduler does not answer"
            time.sleep(0.1)
