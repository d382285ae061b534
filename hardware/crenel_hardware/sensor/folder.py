"""The ``folder`` driver: a folder of pictures as a sensor.

Pictures (png, tif, bmp, jpg; 8 or 16 bits; of colour ones the laser's channel, or their
luma) are shown in the order of their names, numbers counted as numbers, so that 10 comes
after 9, and the pages of a TIFF one after the other. In station.toml::

    [sensor]
    driver = "folder"
    path = "recordings/block"
    rate_hz = 20.0       # optional
    loop = true          # optional: begin again after the last one
    exposure_us = 2000   # optional: what the pictures were taken with
    laser_colour = "red" # optional, of colour pictures: red, green or blue
    bayer = "RGGB"       # optional, of raw pictures: the colours of 2 × 2 pixels, of which only
                         # those of the laser's colour are shown, as a picture of half the size
"""

import re
import threading
from collections import deque
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import cv2
import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from crenel.messages.message import message
from crenel_hardware.errors import DeviceError
from crenel_hardware.options import Options, Shown, read_options
from crenel_hardware.sensor.grabbing import GrabbingSensor
from crenel_hardware.sensor.grey import (
    colour_taken,
    require_colour,
    to_grey,
)
from crenel_hardware.sensor.image_source import (
    EndOfRecordingError,
    GrabbedImage,
    ImageSource,
    PlaybackTimer,
)
from crenel_hardware.shared_options import EXPOSURE, RATE, Bayer, ChosenLaserColour, Loop

_WITH_PAGES = {".tif", ".tiff"}
_SUFFIXES = {".png", ".bmp", ".jpg", ".jpeg", *_WITH_PAGES}


class FolderOptions(Options):
    """Options of the driver in station.toml."""

    title = message("driver-folder")
    path: Annotated[str, Field(min_length=1), Shown(message("option-path"))]
    rate_hz: Annotated[float, Field(gt=0, le=1000), RATE] = 20.0
    loop: Loop = True
    exposure_us: Annotated[float, Field(ge=0), EXPOSURE] = 0.0
    laser_colour: ChosenLaserColour = None
    bayer: Bayer = None


def from_options(options: Mapping[str, object]) -> GrabbingSensor:
    """The driver for one ``[sensor]`` table of station.toml; raises ``DeviceError``."""
    read = read_options(FolderOptions, options, "sensor")
    require_colour(read.bayer, read.laser_colour)
    return GrabbingSensor(
        message("folder-named", folder=read.path),
        lambda stop: _Folder(read, stop),
        first_within_s=10.0,
    )


class _Folder(ImageSource):
    waits = True

    def __init__(self, options: FolderOptions, stop: threading.Event) -> None:
        folder = Path(options.path)
        if not folder.is_dir():
            raise DeviceError(
                message("no-such-folder-named", folder=folder), message("check-sensor-path")
            )
        self._files = sorted(
            (path for path in folder.iterdir() if path.suffix.lower() in _SUFFIXES),
            key=_natural_order,
        )
        if not self._files:
            raise DeviceError(
                message("no-picture-in-folder", folder=folder),
                message("files-searched", suffixes=", ".join(sorted(_SUFFIXES))),
            )
        self.name = folder.name
        self.exposure_range_us = (options.exposure_us, options.exposure_us)
        self._options = options
        self._pace = PlaybackTimer(options.rate_hz, stop)
        self._next = 0
        self._pages: deque[int] = deque()
        """The pages of the current file that were not shown yet."""
        self._shape: tuple[int, ...] = ()
        """The shape of its first page."""

    def grab(self) -> GrabbedImage:
        path, raw = self._read_next()
        image = None
        if raw.dtype in (np.uint8, np.uint16):
            colour, bayer = self._options.laser_colour, self._options.bayer
            image = to_grey(raw, raw.shape[0], colour, bayer)
            self.selected = self.selected or colour_taken(raw, colour, bayer)
        if image is None:
            raise DeviceError(
                message("picture-of-numbers", path=path, kind=str(raw.dtype)),
                message("save-8-16-bits"),
            )
        return GrabbedImage(image, self._pace.wait(), self._options.exposure_us)

    def release(self) -> None:
        """Holds nothing open."""

    def _read_next(self) -> tuple[Path, NDArray[Any]]:
        """The next file, and its next page that is no thumbnail of the first."""
        while True:
            path, page = self._choose()
            raw = _read(path, page)
            if raw is None:
                raise DeviceError(
                    message("picture-cannot-read", path=path), message("is-it-there-and-complete")
                )
            if page == 0:
                self._shape = raw.shape[:2]
            if raw.shape[:2] == self._shape:
                return path, raw

    def _choose(self) -> tuple[Path, int]:
        """The file and page to show next."""
        if not self._pages:
            if self._next == len(self._files):
                if not self._options.loop:
                    raise EndOfRecordingError
                self._next = 0
            self._next += 1
            self._pages.extend(range(_page_count(self._files[self._next - 1])))
        return self._files[self._next - 1], self._pages.popleft()


def _page_count(path: Path) -> int:
    """At least 1, also for a file that cannot be read."""
    if path.suffix.lower() not in _WITH_PAGES or not path.is_file():
        return 1
    return max(1, cv2.imcount(str(path)))


def _read(path: Path, page: int) -> NDArray[Any] | None:
    """The picture as it is stored; None if it cannot be read."""
    if not path.is_file():  # a pipe or a device would be read for ever
        return None
    if page == 0:
        return cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    _, pages = cv2.imreadmulti(str(path), page, 1, flags=cv2.IMREAD_UNCHANGED)
    return pages[0] if pages else None


def _natural_order(path: Path) -> list[tuple[int, str]]:
    parts = re.split(r"(\d+)", path.name)
    return [(int(part), "") if part.isdecimal() else (-1, part) for part in parts]
