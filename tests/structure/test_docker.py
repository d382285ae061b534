"""The container's files: linted, and true to the tree they build from."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

STARTED_MODULES = ()  # a linter
ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("file", ["Dockerfile", "broker.Dockerfile"])
def test_the_dockerfiles_pass_the_linter(file: str) -> None:
    beside_python = Path(sys.executable).parent / "hadolint"
    hadolint = str(beside_python) if beside_python.is_file() else shutil.which("hadolint")
    if hadolint is None:
        pytest.skip("hadolint has no build for this platform")
    done = subprocess.run(
        [hadolint, "--strict-labels", f"docker/{file}"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_copied_path_exists() -> None:
    for line in (ROOT / "docker/Dockerfile").read_text().splitlines():
        words = line.split()
        if words[:1] == ["COPY"] and not words[1].startswith("--from"):
            for source in words[1:-1]:
                assert (ROOT / source).exists(), source


def test_compose_builds_this_tree_and_keeps_to_loopback() -> None:
    compose = yaml.safe_load((ROOT / "docker/compose.yaml").read_text())
    station = compose["services"]["station"]
    build = station["build"]
    context = (ROOT / "docker" / build["context"]).resolve()
    assert context == ROOT
    assert (context / build["dockerfile"]).is_file()
    services = compose["services"].values()
    assert all(port.startswith("127.0.0.1:") for one in services for port in one["ports"])


def test_the_broker_is_there_for_those_who_ask_and_lets_nobody_in_unasked() -> None:
    compose = yaml.safe_load((ROOT / "docker/compose.yaml").read_text())
    broker = compose["services"]["broker"]
    assert broker["profiles"] == ["broker"]
    sources = [volume.partition(":")[0] for volume in broker["volumes"]]
    (config,) = [source for source in sources if source.endswith(".conf")]
    assert "allow_anonymous false" in (ROOT / "docker" / config).read_text().splitlines()


def test_three_workers_reach_their_scheduler_and_nobody_else_does() -> None:
    compose = yaml.safe_load((ROOT / "docker/workers.compose.yaml").read_text())
    services = compose["services"]
    assert services["worker"]["deploy"]["replicas"] == 3
    command = services["scheduler"]["command"]
    port = command[command.index("--port") + 1]
    assert services["worker"]["command"][:2] == ["worker", f"tcp://scheduler:{port}"]
    assert all(one.startswith("127.0.0.1:") for one in services["scheduler"]["ports"])
    extras = services["worker"]["build"]["args"]["EXTRAS"].split(",")
    assert set(extras) <= project_extras()


def project_extras() -> set[str]:
    import tomllib

    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    return set(project["optional-dependencies"])
