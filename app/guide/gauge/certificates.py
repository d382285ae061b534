"""Digital certificates that an operator adds to the gauges of a station."""

import re
from itertools import count
from pathlib import Path

from app.formats.atomic_write import ensure_folder, write_atomically
from app.formats.exchange.read_certificate import parse_sphere_certificate
from app.formats.io_errors import convert_io_errors
from app.formats.open_file import read_bounded
from app.guide.common.datasheet_library import CERTIFICATE_ENDING, GAUGE_ENDINGS

NOT_IN_NAMES = re.compile(r"[^\w-]+")
LONGEST_NAME = 40


def store_certificate(data_folder: Path, name: str, text: str) -> str:
    """Writes the DCC of a sphere into the folder of gauges; no file there is replaced.

    Args:
        name: of its file, as the operator has it.

    Returns:
        The id of the gauge. A certificate that is there already keeps its own.

    Raises:
        OperationError: it is no DCC 3.x of a sphere, or it cannot be written.
    """
    parse_sphere_certificate(text, Path(name))  # nothing is kept that cannot be evaluated
    folder, content = data_folder / "gauges", text.encode()
    stem = NOT_IN_NAMES.sub("-", name.removesuffix(CERTIFICATE_ENDING)).strip("-")
    stem = stem[:LONGEST_NAME] or "certificate"
    with convert_io_errors(folder):
        ensure_folder(folder)
        for number in count(1):
            gauge = stem if number == 1 else f"{stem}-{number}"
            if any((folder / f"{gauge}{ending}").exists() for ending in GAUGE_ENDINGS):
                continue  # the datasheet would count
            path = folder / f"{gauge}{CERTIFICATE_ENDING}"
            if not path.exists():
                break
            if path.is_file() and read_bounded(path) == content:
                return gauge
        write_atomically(path, content)
    return gauge
