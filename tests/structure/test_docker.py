"""The container's files: linted, and true to the tree they build from."""

import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

from tests.sources import ROOT

STARTED_MODULES = ()  # a linter
DOCKER = ROOT / "docker"


@pytest.mark.parametrize("file", ["Dockerfile", "broker.Dockerfile"])
def test_the_dockerfiles_pass_the_linter(file: str) -> None:
    beside_python = Path(sys.executable).parent / "hadolint"
    hadolint = str(beside_python) if beside_python.is_file() else shutil.which("hadolint")
    if hadolint is None:
        pytest.skip("hadolint has no build for this platform")
    command = [hadolint, "--strict-labels", f"docker/{file}"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_copied_path_exists() -> None:
    for line in (DOCKER / "Dockerfile").read_text().splitlines():
        words = line.split()
        if words[:1] == ["COPY"] and not words[1].startswith("--from"):
            for source in words[1:-1]:
                assert (ROOT / source).exists(), source


def services(file: str) -> dict[str, dict[str, Any]]:
    found: dict[str, dict[str, Any]] = yaml.safe_load((DOCKER / file).read_text())["services"]
    return found


def test_compose_builds_this_tree_and_keeps_to_loopback() -> None:
    build = services("compose.yaml")["station"]["build"]
    context = (DOCKER / build["context"]).resolve()
    assert context == ROOT
    assert (context / build["dockerfile"]).is_file()
    ports = [port for one in services("compose.yaml").values() for port in one["ports"]]
    assert all(port.startswith("127.0.0.1:") for port in ports)


def test_the_broker_is_there_for_those_who_ask_and_lets_nobody_in_unasked() -> None:
    broker = services("compose.yaml")["broker"]
    assert broker["profiles"] == ["broker"]
    sources = [volume.partition(":")[0] for volume in broker["volumes"]]
    (config,) = [source for source in sources if source.endswith(".conf")]
    assert "allow_anonymous false" in (DOCKER / config).read_text().splitlines()


def test_three_workers_reach_their_scheduler_and_nobody_else_does() -> None:
    worker, scheduler = (services("workers.compose.yaml")[name] for name in ("worker", "scheduler"))
    assert worker["deploy"]["replicas"] == 3
    port = scheduler["command"][scheduler["command"].index("--port") + 1]
    assert worker["command"][:2] == ["worker", f"tcp://scheduler:{port}"]
    assert all(one.startswith("127.0.0.1:") for one in scheduler["ports"])
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = worker["build"]["args"]["EXTRAS"].split(",")
    assert set(extras) <= set(project["optional-dependencies"])
