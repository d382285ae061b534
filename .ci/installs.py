"""Installs Crenel in every promised way, each from a clone of its own, and smoke tests it.

``python3 .ci/installs.py [WAY...]``; all of them by default. ``readme`` is the README's own
command, ``lowest`` takes the lowest version of each dependency, ``pythonX.Y`` is pip with that
interpreter, for all that are on the path.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PYTHONS = ("3.11", "3.12", "3.13", "3.14")
LOWEST_TESTS = (
    "tests/cli",
    "tests/formats",
    "tests/hardware",
    "tests/report",
    "tests/api",
    "tests/gauges",
)
Folder = Path


class InstallError(Exception):
    """A way of installing Crenel failed."""


def run(*command: object, cwd: Path = ROOT, **environment: object) -> None:
    """Runs a command, quietly.

    Raises:
        InstallError: it failed; the message holds the end of what it printed.
    """
    words = [str(word) for word in command]
    given = os.environ | {name: str(value) for name, value in environment.items()}
    done = subprocess.run(
        words, cwd=cwd, env=given, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    if done.returncode:
        raise InstallError(f"{' '.join(words)}\n{done.stdout[-4000:]}")


def smoke(crenel: Path) -> None:
    """The installed program does what a new user does first.

    Raises:
        InstallError: it does not.
    """
    if subprocess.run([sys.executable, str(ROOT / ".ci/smoke.py"), str(crenel)]).returncode:
        raise InstallError(f"{crenel} does not pass its smoke test")


@contextmanager
def measured(what: str, folder: Path) -> Iterator[None]:
    """Prints how long an installation took, and how large its folder is then."""
    began = time.monotonic()
    yield
    seconds = time.monotonic() - began
    files = (path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    size_mb = sum(path.stat().st_size for path in files) / 1e6
    print(f"  {seconds:5.1f} s  {what}, {size_mb:.0f} MB", flush=True)


def environment(folder: Path, python: str = sys.executable) -> Path:
    """A new virtual environment's folder of programs."""
    run(python, "-m", "venv", folder)
    return folder / "bin"


def helper(folder: Path, package: str) -> Path:
    """A program of PyPI, in an environment of its own."""
    programs = environment(folder / f"helper-{package}")
    run(programs / "pip", "install", package)
    return programs / package


def by_readme(folder: Folder) -> Path:
    """The README's command, with empty caches."""
    source = folder / "source"
    (line,) = (
        line
        for line in (ROOT / "README.md").read_text().splitlines()
        if "&& .venv/bin/crenel" in line
    )
    command = line.rpartition("&&")[0]
    with measured(command, source / ".venv"):
        caches = {"PIP_CACHE_DIR": folder / "pip", "npm_config_cache": folder / "npm"}
        run("bash", "-c", command, cwd=source, **caches)
    return source / ".venv/bin/crenel"


def by_wheel(folder: Folder) -> Path:
    """The wheel beside its dependencies, installed with no index."""
    wheels = folder / "wheels"
    programs = environment(folder / "venv")
    run(programs / "pip", "wheel", "--wheel-dir", wheels, folder / "source")
    with measured("wheel, offline", folder / "venv"):
        offline = {"PIP_NO_INDEX": 1, "PIP_FIND_LINKS": wheels}
        run(programs / "pip", "install", "crenel", cwd=folder, **offline)
    return programs / "crenel"


def by_sdist(folder: Folder) -> Path:
    """The source archive, which holds all that its own build needs."""
    programs = environment(folder / "venv")
    hatchling = helper(folder, "hatchling")
    run(hatchling, "build", "-t", "sdist", "-d", folder, cwd=folder / "source")
    (archive,) = folder.glob("crenel-*.tar.gz")
    with measured(f"{archive.name} of {archive.stat().st_size / 1e6:.1f} MB", folder / "venv"):
        run(programs / "pip", "install", archive, cwd=folder)
    return programs / "crenel"


def by_uv(folder: Folder) -> Path:
    """``uv tool install .``."""
    uv = helper(folder, "uv")
    places = {"UV_TOOL_DIR": folder / "tools", "UV_TOOL_BIN_DIR": folder / "bin"}
    with measured("uv tool install .", folder / "tools"):
        run(uv, "tool", "install", "--python", sys.executable, folder / "source", **places)
    return folder / "bin/crenel"


def by_pipx(folder: Folder) -> Path:
    """``pipx install .``."""
    pipx = helper(folder, "pipx")
    places = {"PIPX_HOME": folder / "home", "PIPX_BIN_DIR": folder / "bin"}
    with measured("pipx install .", folder / "home/venvs"):
        run(pipx, "install", "--python", sys.executable, folder / "source", **places)
    return folder / "bin/crenel"


def by_lowest(folder: Folder) -> Path:
    """The lowest version of each dependency that is asked for by name, and the tests on them."""
    uv = helper(folder, "uv")
    venv, source = folder / "venv", folder / "source"
    run(uv, "venv", "--python", sys.executable, venv)
    lowest = ("--resolution", "lowest-direct", "--compile-bytecode")
    here = {"VIRTUAL_ENV": venv, "PYTHONWARNINGS": "ignore"}
    with measured("the lowest versions, with those of the tests", venv):
        run(uv, "pip", "install", *lowest, "--editable", f"{source}[dev]", **here)
    # what a newer version of something else deprecates is no fault of the lower one
    quiet = ("-n", "2", "-W", "ignore::DeprecationWarning")
    run(venv / "bin/python", "-m", "pytest", *quiet, *LOWEST_TESTS, cwd=source)
    return venv / "bin/crenel"


def by_pip(python: str) -> Callable[[Folder], Path]:
    """pip, with one interpreter."""

    def install(folder: Folder) -> Path:
        programs = environment(folder / "venv", python)
        with measured(f"pip install . by {python}", folder / "venv"):
            run(programs / "pip", "install", folder / "source", cwd=folder)
        return programs / "crenel"

    return install


def ways() -> dict[str, Callable[[Folder], Path]]:
    """Every way of installing that this machine has."""
    named = {
        "readme": by_readme,
        "wheel": by_wheel,
        "sdist": by_sdist,
        "uv": by_uv,
        "pipx": by_pipx,
        "lowest": by_lowest,
    }
    pythons = {f"python{version}": interpreter(version) for version in PYTHONS}
    return named | {name: by_pip(path) for name, path in pythons.items() if path}


def interpreter(version: str) -> str:
    """An interpreter that runs; nothing where there is none."""
    path = shutil.which(f"python{version}") or ""
    works = path and subprocess.run([path, "-c", ""], capture_output=True).returncode == 0
    return path if works else ""


def main() -> None:
    known = ways()
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("way", nargs="*", help=f"of {', '.join(known)}; all by default")
    wanted = parser.parse_args().way or list(known)
    if unknown := set(wanted) - set(known):
        parser.error(f"this machine has no {', '.join(sorted(unknown))}")
    failed = []
    for way in wanted:
        print(way, flush=True)
        folder = Path(tempfile.mkdtemp(prefix=f"crenel-{way}-"))
        try:
            run("git", "clone", "--quiet", ROOT, folder / "source")
            smoke(known[way](folder))
        except InstallError as error:
            failed.append(way)
            print(f"  failed: {error}", flush=True)
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    if failed:
        sys.exit(f"installs: failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
