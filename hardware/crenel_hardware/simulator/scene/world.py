"""What stands on the simulated table: shapes, where they are, and how bright they look.

Shapes are data for the ray caster: a kind and a row of numbers, in the shape's own
frame, and a pose in the arm's.
"""

import math
import time
from dataclasses import dataclass, field, replace
from enum import IntEnum

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel_hardware.simulator.devices.kinematics import Floats

ROW = 64
"""Numbers a shape has for the ray caster; see ``tracing``."""
MAX_EDGES = 32
MARKER_NUMBERS, MARKER_BITS = 24, 25
"""Numbers of a row for markers, two of which share one; and the cells of the largest marker."""
FINISH = 48
"""Where in a row the numbers of a thing's finish begin."""


class ShapeKind(IntEnum):
    BLOCK = 0
    BOX = 1
    SPHERE = 2
    FREEFORM = 3
    BOARD = 4


@dataclass(frozen=True)
class CrenellatedBlock:
    """The crenellated block as truly made. X across the merlons, Y along the grooves, Z up."""

    edges_x_mm: tuple[float, ...] = (-22.0, -14.0, -7.0, -2.0, 5.0, 10.0, 17.0, 22.0)
    front_y_mm: float = -12.0
    back_y_mm: float = 12.0
    crest_z_mm: float = 15.0
    floor_z_mm: float = 0.0
    base_z_mm: float = -12.0


@dataclass(frozen=True)
class Box:
    """A cuboid between two corners; the gauge plate is one, its top the gauge."""

    low_mm: tuple[float, float, float]
    high_mm: tuple[float, float, float]


@dataclass(frozen=True)
class GaugeSphere:
    """A gauge sphere about its frame's origin."""

    radius_mm: float = 12.7


@dataclass(frozen=True)
class FreeformPart:
    """A scallop-like relief: ``z = height(x, y)`` over an ellipse, smooth everywhere."""

    half_width_mm: float = 30.0
    half_depth_mm: float = 25.0
    height_mm: float = 12.0
    rib_mm: float = 0.7
    ribs: float = 26.0


@dataclass(frozen=True)
class BoardMarkers:
    """The markers of a ChArUco board, as OpenCV prints it: the first one is at the upper left."""

    dictionary: str = "DICT_4X4_50"
    side: float = 0.75
    """The share of a square's width."""


@dataclass(frozen=True)
class Board:
    """A flat plate with a chessboard on its top, as truly made.

    The frame lies at the first inner corner, X along the rows of corners, Z out of the
    printed side, which is at z = 0. The outermost square at the first corner is black; with
    ``markers``, the square at the upper left is.
    """

    inner_corners: tuple[int, int] = (7, 6)
    """Columns, rows."""
    square_x_mm: float = 4.5
    square_y_mm: float = 4.5
    rim_mm: float = 4.5
    """The width of the white rim all around the pattern."""
    thickness_mm: float = 4.0
    ink: float = 0.12
    """Brightness of a black square over a white one's."""
    markers: BoardMarkers | None = None

    @property
    def middle_mm(self) -> Floats:
        """(3,) the pattern's middle."""
        columns, rows = self.inner_corners
        x, y = (columns - 1) * self.square_x_mm / 2, (rows - 1) * self.square_y_mm / 2
        return np.array([x, y, 0.0])

    @property
    def half_pattern_mm(self) -> Floats:
        """(2,) from the pattern's middle to its border, along X and Y."""
        columns, rows = self.inner_corners
        return np.array([(columns + 1) * self.square_x_mm, (rows + 1) * self.square_y_mm]) / 2


ObjectShape = CrenellatedBlock | Box | GaugeSphere | FreeformPart | Board


def relief_height_mm(shell: FreeformPart, x: Floats, y: Floats) -> Floats:
    """Height in mm of the relief over points of its base; below zero outside of it."""
    w = 1 - (x / shell.half_width_mm) ** 2 - (y / shell.half_depth_mm) ** 2
    fan = x / (y + 1.3 * shell.half_depth_mm)
    inside = np.maximum(w, 0.0)
    return np.asarray(shell.height_mm * w + shell.rib_mm * inside**2 * np.cos(shell.ribs * fan))


@dataclass(frozen=True)
class SurfaceFinish:
    """How a surface was worked. The default is matt and without marks."""

    gloss: float = 0.0
    """Brightness of a highlight's middle over that of a white face."""
    sharpness: float = 40.0
    """Blinn's exponent of the highlight: the larger, the smaller it is."""
    marks: float = 0.0
    """Standard deviation of the brightness over the tool's marks, which run along X (or Y)."""
    mark_mm: float = 0.2
    """Width of a tool mark."""


@dataclass(frozen=True)
class SceneObject:
    """A shape at a place in the arm frame. ``albedo`` 1 is the block's brightness."""

    name: str
    shape: ObjectShape
    T_arm_obj: Floats
    albedo: float = 1.0
    finish: SurfaceFinish = field(default_factory=SurfaceFinish)

    def at(self, T_arm_obj: Floats) -> "SceneObject":
        """The same thing elsewhere."""
        return replace(self, T_arm_obj=T_arm_obj)


@dataclass(frozen=True)
class Light:
    """The room's (or the sensor's own) light: diffuse from a direction, and from everywhere."""

    direction: tuple[float, float, float] = (0.12, -0.55, 1.0)
    """Towards the light, in the frame that rays are traced in: the sensor's."""
    directed: float = 0.75
    ambient: float = 0.35
    groove_shade: float = 0.0
    """0: a floor is as bright as a crest; 1: it sees only the sky between its walls."""
    texture: float = 0.012
    lamp_mm: tuple[float, float, float] | None = None
    """Where the directed light comes from, in the sensor's frame, if not from afar: it then
    fades with the distance (``directed`` is its strength at the frame's origin), casts
    shadows, and is mirrored by glossy faces. ``direction`` then counts for nothing."""
    lamp_radius_mm: float = 0.0
    """Half the lamp's width, which softens its shadows."""


@dataclass(frozen=True)
class SimulatedScene:
    objects: tuple[SceneObject, ...]
    light: Light = field(default_factory=Light)

    def find_object(self, name: str) -> SceneObject:
        """The thing of that name; raises KeyError."""
        for thing in self.objects:
            if thing.name == name:
                return thing
        raise KeyError(name)


def _block_row(shape: CrenellatedBlock, row: Floats) -> None:
    x = shape.edges_x_mm
    if len(x) > MAX_EDGES:
        raise ValueError(f"a block may have {MAX_EDGES} edges at most, not {len(x)}")
    low = np.array([x[0], shape.front_y_mm, shape.base_z_mm])
    high = np.array([x[-1], shape.back_y_mm, shape.crest_z_mm])
    row[0:3], row[3] = (low + high) / 2, np.linalg.norm(high - low) / 2
    row[8:11], row[11:14], row[14], row[15] = low, high, shape.floor_z_mm, len(x)
    row[16 : 16 + len(x)] = x


def _box_row(low: Floats, high: Floats, row: Floats) -> None:
    row[0:3], row[3] = (low + high) / 2, np.linalg.norm(high - low) / 2
    row[8:11], row[11:14] = low, high


def _board_row(shape: Board, row: Floats) -> None:
    across = np.array([*(shape.half_pattern_mm + shape.rim_mm), 0.0])
    low, high = shape.middle_mm - across, shape.middle_mm + across
    low[2] = -shape.thickness_mm
    _box_row(low, high, row)
    row[16:21] = *shape.inner_corners, shape.square_x_mm, shape.square_y_mm, shape.ink
    if shape.markers is not None:
        _marker_row(shape, shape.markers, row)


def _marker_row(shape: Board, markers: BoardMarkers, row: Floats) -> None:
    """The markers' inner cells, each marker as a number, two of them to each number of the row."""
    columns, rows = (count + 1 for count in shape.inner_corners)
    dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, markers.dictionary))
    bits = dictionary.markerSize
    if columns * rows // 2 > 2 * MARKER_NUMBERS or bits**2 > MARKER_BITS:
        raise ValueError(f"no room for {columns * rows // 2} markers of {markers.dictionary}")
    row[21:24] = markers.side, bits, float(rows % 2 == 0)
    number = 0
    for down in range(rows):
        for column in range(columns):
            if (down + column) % 2 == 0:
                continue
            image = cv2.aruco.generateImageMarker(dictionary, number, bits + 2)[1:-1, 1:-1]
            cells = sum(1 << k for k, level in enumerate(image.ravel().tolist()) if level)
            nth = ((rows - 1 - down) * columns + column) // 2
            row[24 + nth // 2] += cells * 2.0 ** (MARKER_BITS * (nth % 2))
            number += 1


def _max_slope(shell: FreeformPart) -> float:
    """A slope that the relief reaches nowhere on its base."""
    x, y = np.meshgrid(
        np.linspace(-shell.half_width_mm, shell.half_width_mm, 241),
        np.linspace(-shell.half_depth_mm, shell.half_depth_mm, 241),
    )
    height = relief_height_mm(shell, x, y)
    down, across = np.gradient(height, y[:, 0], x[0])
    return 1.15 * float(np.max(np.hypot(down, across)))


def shape_rows(scene: SimulatedScene) -> tuple[NDArray[np.int64], Floats]:
    """Kinds (K,) and rows (K, 64) for the ray caster.

    A row holds the bounding sphere (0-3), albedo (4), bounds (8-13), what the kind
    needs besides (from 14), and the finish (48-51).
    """
    kinds = np.zeros(len(scene.objects), dtype=np.int64)
    rows = np.zeros((len(scene.objects), ROW))
    for k, thing in enumerate(scene.objects):
        row = rows[k]
        row[4] = thing.albedo
        finish = thing.finish
        row[FINISH : FINISH + 4] = finish.gloss, finish.sharpness, finish.marks, finish.mark_mm
        shape = thing.shape
        if isinstance(shape, CrenellatedBlock):
            kinds[k] = ShapeKind.BLOCK
            _block_row(shape, row)
        elif isinstance(shape, Box):
            kinds[k] = ShapeKind.BOX
            _box_row(np.array(shape.low_mm), np.array(shape.high_mm), row)
        elif isinstance(shape, GaugeSphere):
            kinds[k] = ShapeKind.SPHERE
            row[3] = shape.radius_mm
        elif isinstance(shape, Board):
            kinds[k] = ShapeKind.BOARD
            _board_row(shape, row)
        else:
            kinds[k] = ShapeKind.FREEFORM
            top = shape.height_mm + shape.rib_mm
            reach = np.array([shape.half_width_mm, shape.half_depth_mm, top])
            _box_row(reach * [-1, -1, 0], reach, row)
            row[16:22] = (
                shape.half_width_mm,
                shape.half_depth_mm,
                shape.height_mm,
                shape.rib_mm,
                shape.ribs,
                _max_slope(shape),
            )
    return kinds, rows


def make_table() -> SceneObject:
    """A dark table top, level with the arm's base."""
    return SceneObject(
        "table", Box((-1500.0, -1500.0, -30.0), (1500.0, 1500.0, 0.0)), np.eye(4), 0.15
    )


MEAN_C, SWING_C, PERIOD_S = 21.4, 0.4, 1500.0


class RoomThermometer:
    """Reads to a hundredth of a degree."""

    def read_c(self) -> float:
        return round(MEAN_C + SWING_C * math.sin(2 * math.pi * time.time() / PERIOD_S), 2)
