"""Libraries for some cloud formats, which come with the extras ``clouds`` and ``copc``."""

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import TypeVar

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.optional_library import import_library
from crenel.messages.message import message

T = TypeVar("T")


def load_library(path: Path, name: str, extra: str = "clouds") -> ModuleType:
    """The library that a format needs; raises ``OperationError`` where it is not installed.

    Args:
        extra: of this package, with which it comes.
    """
    suffix = path.suffix.upper().lstrip(".")
    return import_library(
        path,
        name,
        message("cloud-format-package-missing", format=suffix, package=name),
        message("cloud-install-package", command=f"pip install 'crenel[{extra}]'"),
    )


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
            message("cloud-disk-accepts-no-more", reason=first_line(error)),
            message("cloud-choose-another-location"),
        ) from error


def first_line(error: BaseException) -> str:
    """What a library says, without its own whereabouts."""
    return str(error).split("\n")[0]
