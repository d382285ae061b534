"""Libraries that come with an extra of this package, and may be absent."""

import importlib
from pathlib import Path
from types import ModuleType

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.messages.message import Text


def import_library(path: Path, name: str, needed: Text, remedy: Text) -> ModuleType:
    """The library that a file needs.

    Args:
        path: the file.
        name: of the module.
        needed: that the file needs it.
        remedy: how it is installed, and what else serves.

    Raises:
        OperationError: ``extra-missing``, where it is not installed.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise OperationError("extra-missing", display_path(path), needed, remedy) from error
