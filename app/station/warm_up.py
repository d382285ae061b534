"""Compiling the station's inner loops before anyone waits for them.

A loop is compiled where it is first called, one at a time in the whole process, and
kept on disk for later starts. In the middle of a calibration that would hold the
pictures up for longer than a device may be silent.
"""

import multiprocessing
import signal
from contextlib import suppress

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.adjustment.weighing import judged
from app.metrology.camera import Camera, project
from app.metrology.compiled import compiled_here
from app.metrology.crenellated import Crenellated, corners
from app.metrology.detection.corners import detect_object
from app.metrology.laser_plane import LaserPlane
from app.metrology.line_scatter import neighbours_alike
from app.metrology.refusal import Refusal
from app.metrology.scene import Scene, edge_rows

WIDTH_PX, HEIGHT_PX, FOCAL_PX = 320, 256, 625.0
FINER = 4
"""The drawing is made so many times larger, and its edges are soft once it is reduced."""
EYE_MM = np.array([1.0, -70.0, 95.0])
"""The drawing shows the block from here: from its front and above."""
# Grey levels of what is drawn.
TABLE, FLOOR, WALL, CREST, FRONT = 30, 80, 55, 150, 110

BLOCK = Crenellated(
    name="Drawn",
    serial_number="",
    edges_x_mm=(-22.0, -10.0, 2.0, 22.0),
    front_y_mm=-12.0,
    back_y_mm=12.0,
    crest_z_mm=15.0,
    floor_z_mm=0.0,
    base_z_mm=-12.0,
    standard_uncertainty_mm=0.002,
)


LEVEL = LaserPlane(np.array([0.0, 0.0, 1.0]), BLOCK.crest_z_mm)


def warm_up() -> None:
    """Runs every compiled loop of the live station once.

    The first time on a machine they are compiled, in a process of their own; later they are
    read from disk in about a second.
    """
    neighbours_alike(np.zeros((1, 2)), np.zeros(1))
    # a process that ends with its parent may have no children itself
    if compiled_here(neighbours_alike) and not multiprocessing.current_process().daemon:
        worker = multiprocessing.get_context("spawn").Process(target=_deaf, daemon=True)
        worker.start()
        worker.join()
    warm_up_block()


def _deaf() -> None:
    """Ctrl-C is for the station, which ends its workers itself."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    warm_up_block()


def warm_up_block() -> None:
    """Runs the loops that find the block, on drawings with and without it, and solve for it."""
    drawn = drawn_block()
    bare = np.full_like(drawn, TABLE)
    bare[: HEIGHT_PX // 2] = FLOOR
    found = detect_object(drawn, BLOCK)
    with suppress(Refusal):  # that there is no object in a picture is an answer, too
        detect_object(bare, BLOCK)
    rows = edge_rows(Scene(found.camera, LEVEL, BLOCK), found.edges)
    judged(rows)
    neighbours_alike(rows.places, rows.residuals)


def drawn_block() -> NDArray[np.uint8]:
    """(256, 320) the faces of ``BLOCK``, each of an even grey, what is hidden drawn over."""
    camera, at = _camera(), corners(BLOCK)
    large = np.full((FINER * HEIGHT_PX, FINER * WIDTH_PX), TABLE, np.uint8)
    for grey, names in _faces():
        outline = FINER * project(camera, np.array([at[name] for name in names]))
        cv2.fillPoly(large, [np.rint(outline).astype(np.int32)], (grey,))
    reduced = cv2.resize(large, (WIDTH_PX, HEIGHT_PX), interpolation=cv2.INTER_AREA)
    return np.asarray(cv2.GaussianBlur(reduced, (0, 0), 0.7), dtype=np.uint8)


def _faces() -> list[tuple[int, list[str]]]:
    """Grey level and corners of each face, those behind first."""
    merlons, grooves = range(BLOCK.merlon_count), range(BLOCK.merlon_count - 1)
    ends = ("L:front", "L:back", "R:back", "R:front")
    faces = [(FLOOR, [f"floor:{j}:{end}" for end in ends]) for j in grooves]
    for j in grooves:
        for foot, top in ((f"floor:{j}:L", f"crest:{j}:R"), (f"floor:{j}:R", f"crest:{j + 1}:L")):
            wall = [f"{foot}:front", f"{foot}:back", f"{top}:back", f"{top}:front"]
            faces.append((WALL, wall))
    faces += [(CREST, [f"crest:{i}:{end}" for end in ends]) for i in merlons]
    comb = ["base:L:front"]
    for i in merlons:
        comb += [f"crest:{i}:L:front", f"crest:{i}:R:front"]
        comb += [f"floor:{i}:L:front", f"floor:{i}:R:front"] if i in grooves else []
    return [*faces, (FRONT, [*comb, "base:R:front"])]


def _camera() -> Camera:
    """Looks from ``EYE_MM`` at the object frame's origin, its X to the right."""
    ahead = -EYE_MM / np.linalg.norm(EYE_MM)
    right = np.cross(ahead, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    rotation = np.stack([right, np.cross(ahead, right), ahead])
    matrix = np.array([[FOCAL_PX, 0, WIDTH_PX / 2], [0, FOCAL_PX, HEIGHT_PX / 2], [0, 0, 1]])
    return Camera(matrix, rotation, -rotation @ EYE_MM, WIDTH_PX, HEIGHT_PX)
