"""Hostile files, places and cells: clouds, archives and exported tables."""

import csv
import io
import os
import random
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.place import check_apart
from crenel.formats.clouds.files import SUFFIXES, cloud_writer, read_cloud
from crenel.formats.csv_table import table_text
from tests.bench.hostile.falling import WORDS, FallenError, vary

POINTS = 400
LAZ_SHARE = 0.05
"""Each is read in a process of its own, which takes long to begin."""
NUMBER = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*")
RUN = re.compile(r"'*\s*[=+\-@]")
Try = Callable[[random.Random], str]


@contextmanager
def clouds(folder: Path) -> Iterator[Try]:
    """Clouds of every format, varied; a cloud that is read has finite points."""
    rng = np.random.default_rng(0)
    whole = {}
    for suffix in SUFFIXES:
        path = folder / f"whole{suffix}"
        with cloud_writer(path) as cloud:
            points_mm = rng.uniform(-500, 500, (POINTS, 3))
            cloud.write(points_mm, rng.uniform(0, 255, POINTS), rng.uniform(1, 9, POINTS), 0)
        whole[suffix] = path.read_bytes()
    plain = [suffix for suffix in whole if suffix != ".laz"]

    def attempt(rng: random.Random) -> str:
        suffix = ".laz" if rng.random() < LAZ_SHARE else rng.choice(plain)
        path = folder / f"varied{suffix}"
        content = vary(rng, whole[suffix])
        if rng.random() < 0.2:  # a text that begins with other columns
            head = b",".join(rng.choices((b"X [mm]", b"y_mm", b"Points:2", b"i", b""), k=4))
            path, content = folder / "varied.xyz", head + b"\n" + vary(rng, whole[".xyz"])
        path.write_bytes(content)
        read_cloud(path)
        return "taken"

    yield attempt


@contextmanager
def archive_places(folder: Path) -> Iterator[Try]:
    """Places of an archive; one in the data folder, or around it, must be refused."""
    data = folder / "data"
    for kind in ("scans", "archive", "gauges/copies"):
        (data / kind).mkdir(parents=True)
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()
    tops = [data, data / "scans", data / "archive", elsewhere, folder / "data2", folder]
    count = iter(range(1 << 30))

    def attempt(rng: random.Random) -> str:
        target = rng.choice(tops)
        place = str(target)
        for _ in range(rng.randint(0, 3)):
            match rng.randrange(6):
                case 0:
                    link = elsewhere / f"link{next(count)}"
                    link.symlink_to(place)
                    place = str(link)
                case 1:
                    place += f"/../{os.path.basename(os.path.realpath(place))}"
                case 2:
                    place += "/" + rng.choice(("new", ".", "a b", "ü", "new/er"))
                case 3:
                    place = place.replace("/", "//", 1)
                case 4:
                    place += "/"
                case _:
                    place = os.path.relpath(place) if rng.random() < 0.3 else place
        url = rng.choice(("", "", "file://", "local://")) + os.path.join(folder, place)
        settings = ArchiveSettings.model_construct(url=url)
        check_apart(settings, data)
        real, own = os.path.realpath(place) + os.sep, os.path.realpath(data) + os.sep
        if real.startswith(own) or own.startswith(real):
            raise FallenError("taken inside", url)
        return "taken"

    yield attempt


@contextmanager
def table_cells(folder: Path) -> Iterator[Try]:
    """Cells of a table; none of a text is run by a spreadsheet program."""

    def attempt(rng: random.Random) -> str:
        starts = ("=", "+", "-", "@", "\t", "\r", " ", "'", '"', "\u00a0", "\n", ",", ";", "\ufeff")
        ends = ("cmd|' /C calc'!A0", "1+1", "SUM(A1)", "-1.5e3", "", *map(_text, WORDS))
        cells = [
            "".join(rng.choices(starts, k=rng.randint(0, 4))) + rng.choice(ends) for _ in range(3)
        ]
        text = table_text(("a", "b", "c"), [cells])
        for row in csv.reader(io.StringIO(text, newline=""), delimiter=","):
            for cell in row:
                if RUN.match(cell) and not cell.startswith("'") and not NUMBER.fullmatch(cell):
                    raise FallenError("run as a formula", repr(cell))
        return "taken"

    yield attempt


def _text(word: bytes) -> str:
    return word.decode("utf-8", "replace")
