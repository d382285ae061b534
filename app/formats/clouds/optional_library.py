"""Libraries for some cloud formats, which come with the extras ``clouds`` and ``copc``."""

import importlib
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import TypeVar

from app.errors import OperationError
from app.formats.file_names import display_path

T = TypeVar("T")


def load_library(path: Path, name: str, extra: str = "clouds") -> ModuleType:
    """The library that a format needs; raises ``OperationError`` where it is not installed.

    Args:
        extra: of this package, with which it comes.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise OperationError(
            "extra-missing",
            display_path(path),
            f"{path.suffix.upper().lstrip('.')} files require the package {name}, "
            "which is not installed",
            f"Install it with: pip install 'crenel[{extra}]'; or use PLY, PCD or XYZ",
        ) from error


def call_library(path: Path, failure: str, work: Callable[[], T]) -> T:
    """What a library does to the file; its own kind of failure, by name, as a refusal."""
    try:
        return work()
    except Exception as error:
        if type(error).__name__ != failure:
            raise
        raise OperationError(
            "cloud-not-written",
            display_path(path),
            f"the disk accepts no more data ({first_line(error)})",
            "Free some space, or choose another location",
        ) from error


def first_line(error: Exception) -> str:
    """What a library says, without its own whereabouts."""
    return str(error).split("\n")[0]
