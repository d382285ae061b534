"""A block as a closed surface of triangles: STL, binary."""

from pathlib import Path

import numpy as np

from crenel.formats.atomic_write import write_atomically
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

HEADER = b"Crenel block, mm".ljust(80)
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])


def write_stl(path: Path, block: Crenellated) -> None:
    """Writes the block in mm, in the object frame.

    Raises:
        OperationError: the file cannot be written.
    """
    triangles = block_triangles(block)
    rows = np.zeros(len(triangles), dtype=TRIANGLE)
    across = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    rows["normal"] = across / np.linalg.norm(across, axis=1)[:, None]
    rows["corners"] = triangles
    write_atomically(path, HEADER + np.uint32(len(rows)).tobytes() + rows.tobytes())


def block_triangles(block: Crenellated) -> Floats:
    """The block's surface, closed: every edge of a triangle is one of exactly one other.

    Returns:
        (T, 3, 3) corners in mm, anticlockwise as seen from outside.
    """
    x, low, mid, high = block.edges_x_mm, block.base_z_mm, block.floor_z_mm, block.crest_z_mm
    front, back = block.front_y_mm, block.back_y_mm
    cells = {(i, 0): (x[i], x[i + 1], low, mid) for i in range(len(x) - 1)}
    cells |= {(i, 1): (x[i], x[i + 1], mid, high) for i in range(0, len(x) - 1, 2)}
    faces: list[list[tuple[float, float, float]]] = []
    for (i, level), (left, right, bottom, top) in cells.items():
        outline = [(left, bottom), (right, bottom), (right, top), (left, top)]
        faces.append([(at_x, front, z) for at_x, z in outline])
        faces.append([(at_x, back, z) for at_x, z in reversed(outline)])
        neighbours = [(i, level - 1), (i + 1, level), (i, level + 1), (i - 1, level)]
        for side, neighbour in enumerate(neighbours):
            if neighbour not in cells:
                (ax, az), (bx, bz) = outline[side], outline[(side + 1) % 4]
                faces.append([(ax, front, az), (ax, back, az), (bx, back, bz), (bx, front, bz)])
    quads = np.array(faces)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
