"""Coloured laser lines painted on pictures of lit rooms, with the places where they can be seen."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.colour import PLANES, LaserColour
from crenel.metrology.transforms import Floats

Picture = NDArray[np.uint8]
"""(H, W, 3), blue first."""
COLOURS: tuple[LaserColour, ...] = ("red", "green", "blue")
WIDTHS_PX = (3.0, 5.0, 8.0, 12.0, 20.0, 30.0)
LEAKS = (0.02, 0.3)
"""The least and the most that other channels see of the laser, as a share of its own."""
HEIGHTS = (60.0, 900.0)
"""Grey levels of the laser on white, before they are clipped."""
DARKEST = 0.15
"""What a black surface reflects of the laser, against a white one."""
SEEN_LEVELS = 18.0
"""A column shows the line if it rises by so much there; where less is left, people guess."""
LONGEST_PX = 1400


@dataclass(frozen=True)
class PaintedLine:
    """A picture with a line, and where the line is.

    ``rows``: (W,) of the line, NaN in columns that it does not cross. ``visible``: (W,) columns
    in which anyone sees it.
    """

    picture: Picture
    rows: Floats
    visible: NDArray[np.bool_]
    width_px: float
    colour: LaserColour


def read_rooms(folder: Path) -> Iterator[tuple[Path, Picture]]:
    """The pictures of a folder and of those in it, larger ones halved."""
    for path in sorted(_files(folder)):
        picture = cv2.imread(str(path), cv2.IMREAD_COLOR)
        if picture is None:
            continue
        while max(picture.shape) > LONGEST_PX:
            picture = cv2.resize(picture, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
        yield path, np.asarray(picture, np.uint8)


def furnish(room: Picture, rng: np.random.Generator, cables: bool = True) -> Picture:
    """The room with coloured things in it and another white balance.

    Paper of any colour, a wooden board, skin and thin cables are what else has a hue in a room.
    """
    height, width = room.shape[:2]
    scene = room.astype(np.float32)
    for _ in range(int(rng.integers(0, 5))):
        albedo = _paper_colour(rng)
        inside = np.zeros((height, width), np.float32)
        centre = rng.uniform((0, 0), (width, height))
        corners = centre + rng.normal(0, 0.25 * width, (4, 2))
        cv2.fillConvexPoly(inside, cv2.convexHull(corners.astype(np.int32)), 1.0)
        inside = _soft(inside)[..., None]
        painted = (40 + 0.75 * scene.mean(axis=2, keepdims=True)) * albedo
        if rng.random() < 0.4:
            painted = painted * _grain(height, width, rng)[..., None]
        scene = np.asarray(scene * (1 - inside) + painted * inside, np.float32)
    for _ in range(int(rng.integers(0, 3)) // 2 if cables else 0):
        scene = _with_cable(scene, rng)
    scene *= rng.uniform(0.85, 1.15, 3).astype(np.float32)
    return np.clip(scene, 0, 255).astype(np.uint8)


def paint_line(room: Picture, rng: np.random.Generator) -> PaintedLine:
    """A line of random colour, width, strength and shape on a room, as a camera stores it."""
    height, width = room.shape[:2]
    colour = COLOURS[int(rng.integers(3))]
    width_px = float(rng.choice(WIDTHS_PX))
    strength = float(np.exp(rng.uniform(*np.log(HEIGHTS))))
    rows, shown = _shape(height, width, width_px, rng)
    away = np.arange(height)[:, None] - rows
    beam = np.exp(-4 * np.log(2) * (away / width_px) ** 2) * shown
    beam *= 1 + 0.15 * cv2.GaussianBlur(rng.normal(0, 1, beam.shape), (0, 0), 1.2)
    surface = cv2.GaussianBlur(room.astype(np.float32), (0, 0), 0.8) / 255
    sees = rng.uniform(*LEAKS, 3)
    sees[PLANES[colour]] = 1.0
    light = strength * beam[..., None] * sees * (DARKEST + (1 - DARKEST) * surface)
    seen = np.clip(room + light, 0, 255)
    noise_sd = rng.uniform(0.5, 3.0)
    stored = np.clip(np.rint(seen + rng.normal(0, noise_sd, seen.shape)), 0, 255).astype(np.uint8)
    if rng.random() < 0.7:
        quality = [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(70, 97))]
        _, raw = cv2.imencode(".jpg", stored, quality)
        stored = np.asarray(cv2.imdecode(raw, cv2.IMREAD_COLOR), np.uint8)
    middle = np.clip(np.rint(rows).astype(int), 0, height - 1)
    rise = (seen - room).max(axis=2)[middle, np.arange(width)]
    rise = cv2.blur(rise.astype(np.float32)[None], (5, 1))[0]
    inside = (rows > width_px) & (rows < height - width_px)
    visible = (rise >= SEEN_LEVELS + 3 * noise_sd) & shown & inside
    return PaintedLine(stored, np.where(shown, rows, np.nan), visible, width_px, colour)


def _files(folder: Path) -> Iterator[Path]:
    for path in folder.iterdir():
        if path.is_dir():
            yield from _files(path)
        else:
            yield path


def _shape(
    height: int, width: int, width_px: float, rng: np.random.Generator
) -> tuple[Floats, NDArray[np.bool_]]:
    """The row of the line in each column, with steps and gaps as objects make them."""
    along = np.arange(width)
    rows = height * rng.uniform(0.3, 0.7) + rng.uniform(-0.2, 0.2) * (along - width / 2)
    rows = rows + rng.uniform(0, 0.05) * height * np.sin(6 * along / width + 6 * rng.random())
    shown = np.ones(width, np.bool_)
    for _ in range(int(rng.integers(0, 4))):
        begin, length = int(rng.integers(width)), int(rng.uniform(0.06, 0.3) * width)
        rows[begin : begin + length] += rng.uniform(-0.12, 0.12) * height
    for _ in range(int(rng.integers(0, 3))):
        begin, length = int(rng.integers(width)), int(rng.uniform(0.01, 0.08) * width)
        shown[begin : begin + length] = False
    jumps = np.abs(np.diff(rows, append=rows[-1])) > 3
    for at in np.flatnonzero(jumps):
        half = 2 + round(width_px / 4)
        shown[max(0, at - half) : at + half] = False
    return rows, shown


def _paper_colour(rng: np.random.Generator) -> NDArray[np.float32]:
    kinds = (
        (0.95, 0.95, 0.95),
        (0.40, 0.62, 0.85),  # wood
        (0.55, 0.65, 0.90),  # skin
        tuple(rng.uniform(0.1, 1.0, 3)),
    )
    return np.asarray(kinds[int(rng.integers(len(kinds)))], np.float32)


def _grain(height: int, width: int, rng: np.random.Generator) -> NDArray[np.float32]:
    """Stripes as of wood, lengthwise."""
    lines = rng.normal(0, 1, (height, 1)).astype(np.float32)
    soft = cv2.GaussianBlur(lines, (0, 0), 1.5) + np.zeros((height, width), np.float32)
    return np.asarray(1 + 0.12 * soft, np.float32)


def _soft(inside: NDArray[np.float32]) -> NDArray[np.float32]:
    """With the edges that a lens draws."""
    return np.asarray(cv2.GaussianBlur(inside, (0, 0), 0.8), np.float32)


def _with_cable(scene: NDArray[np.float32], rng: np.random.Generator) -> NDArray[np.float32]:
    """The scene with a thin bent thing of one colour across it."""
    height, width = scene.shape[:2]
    along = np.linspace(0, 1, 60)
    ends = rng.uniform((0, 0, 0, 0), (width, height, width, height))
    bend = rng.normal(0, 0.1 * height, 2)
    u = ends[0] + (ends[2] - ends[0]) * along + bend[0] * np.sin(3 * np.pi * along)
    v = ends[1] + (ends[3] - ends[1]) * along + bend[1] * np.sin(2 * np.pi * along)
    inside = np.zeros((height, width), np.float32)
    thick = int(rng.integers(2, 9))
    cv2.polylines(inside, [np.column_stack([u, v]).astype(np.int32)], False, 1.0, thick)
    inside = _soft(inside)[..., None]
    colour = rng.uniform(10, 230, 3).astype(np.float32)
    return np.asarray(scene * (1 - inside) + colour * inside, np.float32)
