"""``end_temperatures.json``: temperatures at the end of a performance test.

Those at its beginning are in the plan, which is frozen by then. The file is optional.
"""

from pathlib import Path
from typing import ClassVar

from crenel.formats.json_document import Document, Number

END_TEMPERATURES = "end_temperatures.json"


class EndTemperatures(Document):
    """The file."""

    FORMAT: ClassVar[str] = "crenel/performance-end-temperatures"

    artefact_c: Number | None = None
    """None: not measured."""
    arm_c: Number | None = None


def read_end_temperatures(folder: Path) -> EndTemperatures:
    """Reads the temperatures in the folder of a test; none measured where it has no such file.

    Raises:
        OperationError: the file is damaged.
    """
    path = folder / END_TEMPERATURES
    return EndTemperatures.read(path) if path.is_file() else EndTemperatures()
