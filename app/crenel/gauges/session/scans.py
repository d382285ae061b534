"""Scans of a performance test: how a kind of test begins one, and what it measures in it."""

import shutil
from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Generic, TypeVar

from crenel.formats.io_errors import convert_io_errors
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.judgement.evaluate_measured_data import ASIDE
from crenel.gauges.session.entries import AnyScan
from crenel.guide.common.arguments import Args
from crenel.messages.message import Text
from crenel.station.scan.points import Show

Scan = TypeVar("Scan", bound=AnyScan)


class KindScans(ABC, Generic[Scan]):
    """The scans of a kind of test."""

    @abstractmethod
    def begin(self, guide: PerformanceGuide, args: Args, key: str | None) -> None:
        """Starts the scan that a command is about; an earlier one of the same is kept aside.

        Raises:
            OperationError: it cannot start.
        """

    @abstractmethod
    def text(self, guide: PerformanceGuide, scan: Scan) -> Text:
        """Said while a scan is measured."""

    @abstractmethod
    def measure(self, guide: PerformanceGuide, scan: Scan) -> Mapping[str, object]:
        """What a scan shows, as its row has it.

        Raises:
            OperationError: it cannot be rebuilt, or is of no use.
        """


def record_scan(guide: PerformanceGuide, name: str, title: Text, watch: Show | None = None) -> None:
    """Starts the scanner; a folder of this name is kept aside.

    Raises:
        OperationError: it cannot start.
    """
    folder = guide.folder / name
    if folder.exists():
        number = 1 + sum(1 for _ in guide.folder.glob(f"{name}{ASIDE}*"))
        with convert_io_errors(folder):
            shutil.move(folder, guide.folder / f"{name}{ASIDE}{number}")
    guide.station.scanner.start(str(title), folder, watch)
