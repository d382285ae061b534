"""The C libraries: their sources and results, and the supported processors."""

import hashlib
import importlib.util
import platform
import sys
from dataclasses import dataclass
from pathlib import Path

NATIVE = Path(__file__).resolve().parent
SHARED = NATIVE / "c"
"""Contains what is compiled into every library: ``export.h`` and ``about.c``."""
FLAGS = (
    "-std=c11",
    "-O3",
    "-fPIC",
    "-fvisibility=hidden",
    "-ffp-contract=off",  # every variant rounds alike, and gives the same points
    "-fno-math-errno",
    "-fno-trapping-math",
    "-fno-sanitize=undefined",  # which zig enables by default
    "-Wall",
    "-Wextra",
    "-Wno-unknown-pragmas",
    "-Wno-psabi",
)
VARIANTS: dict[str, dict[str, tuple[str, ...]]] = {
    "x86_64": {
        "v1": (),
        "v3": ("-march=x86_64_v3",),
        "v4": ("-march=x86_64_v4", "-mprefer-vector-width=512"),
    },
    "aarch64": {"v1": ()},
}
"""Flags of each variant by machine, the least demanding first."""
SUFFIXES = {"linux": ".so", "darwin": ".dylib", "win32": ".dll"}


class LibraryError(ImportError):
    """A compiled library is missing, older than its sources, or not for this processor."""


@dataclass(frozen=True)
class LibrarySource:
    """Name of a library and its folder, which has the sources in ``c``."""

    name: str
    folder: Path

    @property
    def files(self) -> list[Path]:
        """All sources and headers, in a fixed order."""
        return sorted(
            path for path in (self.folder / "c").rglob("*") if path.suffix in (".c", ".h")
        )

    def library_path(self, system: str = sys.platform) -> Path:
        """Path of the compiled library."""
        return self.folder / f"{self.name}{SUFFIXES.get(system, '.so')}"


def folder_of_hardware() -> Path:
    """The folder of the package ``crenel_hardware``, which is not imported.

    Raises:
        LibraryError: it is not installed beside this one.
    """
    spec = importlib.util.find_spec("crenel_hardware")
    if spec is None or spec.origin is None:
        raise LibraryError("the package crenel_hardware is missing: install Crenel again")
    return Path(spec.origin).resolve().parent


LIBRARIES = (
    LibrarySource("crenel", NATIVE),
    LibrarySource("simulator", folder_of_hardware() / "simulator" / "native"),
)


@dataclass(frozen=True)
class BuildTarget:
    """The target system and machine of a library."""

    system: str
    machine: str

    @classmethod
    def here(cls) -> "BuildTarget":
        names = {"amd64": "x86_64", "arm64": "aarch64"}
        machine = platform.machine().lower()
        return cls(sys.platform, names.get(machine, machine))


def variant_flags(target: BuildTarget) -> dict[str, tuple[str, ...]]:
    """The variants of a target's library, each with its flags, the least demanding first."""
    return VARIANTS.get(target.machine, {"v1": ()})


def source_hash(source: LibrarySource) -> str:
    """Identifies the input of a build: the sources, the flags and the variants."""
    digest = hashlib.sha256(repr((FLAGS, VARIANTS)).encode())
    for path in (SHARED / "export.h", SHARED / "about.c", SHARED / "exported.map", *source.files):
        digest.update(path.name.encode() + b"\0")
        digest.update(path.read_bytes() + b"\0")
    return digest.hexdigest()
