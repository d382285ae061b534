"""The clouds that are wanted and not made yet, in a file: a server that starts again makes them."""

import logging
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, ClassVar

from pydantic import Field

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import Document, DocumentPart
from crenel.wire.fleet import CloudFormat

log = logging.getLogger(__name__)
ORDERS_FILE = "orders.json"
"""Beside the clouds, while there are orders."""
Name = Annotated[str, Field(max_length=200)]


class KeptOrder(DocumentPart):
    """A cloud that is wanted; of sensors without a calibration here, with that of the scan."""

    station: Name
    scan_id: Name
    calibration_ids: tuple[Name, ...] = ()
    format: CloudFormat


class CloudOrdersFile(Document):
    """``orders.json``"""

    FORMAT: ClassVar[str] = "crenel/cloud-orders"

    orders: tuple[KeptOrder, ...]
    """The first one is made first."""


class KeptOrders:
    """The file of the orders. Where it cannot be read or written, the log says so, and the server
    goes on: all that is lost is what waits, at a restart.

    Args:
        path: of the file, whose folder is created when it is needed.
    """

    def __init__(self, path: Path) -> None:
        self._path = path

    def read(self) -> Sequence[KeptOrder]:
        """What waited when the server ended."""
        if not self._path.exists():
            return ()
        try:
            return CloudOrdersFile.read(self._path).orders
        except OperationError as error:
            log.warning("clouds that waited are not made: %s", error.line)
            return ()

    def write(self, orders: Sequence[KeptOrder]) -> None:
        """Replaces what is kept; without orders, there is no file."""
        try:
            with convert_io_errors(self._path):
                if not orders:
                    self._path.unlink(missing_ok=True)
                    return
                ensure_folder(self._path.parent)
            CloudOrdersFile(orders=tuple(orders)).write(self._path)
        except OperationError as error:
            log.warning("clouds that wait would be forgotten at a restart: %s", error.line)
