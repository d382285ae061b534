"""The pixel loops of the room's light: what the camera gets of it from every face.

All work in the camera's frame, in which a pixel's ray is ``(x, y, 1)``.
"""

import numpy as np
from numpy.typing import NDArray

from hardware.compiled import kernel
from hardware.twin.kinematics import Floats
from hardware.twin.shading import radiance
from hardware.twin.tracing import Ints, trace

Image = NDArray[np.float32]
Lines = NDArray[np.float32]
Codes = NDArray[np.int32]


def lattice(count: int) -> Floats:
    """(count, 2) places in a pixel, -0.5 to 0.5, evenly spread in every direction.

    A rank-1 lattice of Fibonacci's kind (``count`` 5, 13, 21, 34, 55, 89 ...): projected on
    either axis its points are equidistant, so that a straight edge through the pixel
    is placed to about half of 1/count.
    """
    before = {5: 3, 13: 8, 21: 13, 34: 21, 55: 34, 89: 55, 144: 89}[count]
    i = np.arange(count)
    return np.column_stack([(i + 0.5) / count, ((i * before) % count + 0.5) / count]) - 0.5


@kernel
def cast_room(
    lines: Lines,
    kinds: Ints,
    rows: Floats,
    eyes: Floats,
    lights: Floats,
    lamps: Floats,
    look: Floats,
    grain: Image,
    codes: Codes,
    out: Image,
) -> None:
    """One ray through each pixel's centre: brightness, and a code of the face that it meets.

    The code also tells how much of the lamp reaches the place.
    """
    for r in range(out.shape[0]):
        line, code_row, out_row = lines[r], codes[r], out[r]
        for c in range(out.shape[1]):
            hit = trace(kinds, rows, eyes, line[c, 0], line[c, 1], 1.0)
            lit = 0
            if hit[1] < 0:
                out_row[c] = 0.0
            else:
                out_row[c], lit = radiance(hit, kinds, rows, eyes, lights, lamps, look, grain)
            code_row[c] = (hit[1] * 1024 + hit[2]) * 16 + lit


@kernel
def _at_edge(codes: Codes, r: int, c: int, places: int) -> bool:
    """Whether any of the eight neighbours shows another face, or one plainly otherwise lit.

    In half shadow the light falls off place by place of the lamp, of which there are
    ``places``; a ray a pixel draws that as well.
    """
    own = codes[r, c]
    for dr in range(-1, 2):
        for dc in range(-1, 2):
            other = codes[r + dr, c + dc]
            if other // 16 != own // 16 or 8 * abs(other % 16 - own % 16) > places:
                return True
    return False


@kernel
def refine_room(
    lines: Lines,
    spots: Floats,
    kinds: Ints,
    rows: Floats,
    eyes: Floats,
    lights: Floats,
    lamps: Floats,
    look: Floats,
    grain: Image,
    codes: Codes,
    out: Image,
) -> None:
    """Averages many rays over each pixel that an edge may cross."""
    for r in range(1, out.shape[0] - 1):
        for c in range(1, out.shape[1] - 1):
            if not _at_edge(codes, r, c, lamps.shape[0]):
                continue
            x0, y0 = lines[r, c, 0], lines[r, c, 1]
            xu, yu = lines[r, c + 1, 0] - x0, lines[r, c + 1, 1] - y0
            xv, yv = lines[r + 1, c, 0] - x0, lines[r + 1, c, 1] - y0
            total = 0.0
            for s in range(spots.shape[0]):
                a, b = spots[s, 0], spots[s, 1]
                dx, dy = x0 + a * xu + b * xv, y0 + a * yu + b * yv
                hit = trace(kinds, rows, eyes, dx, dy, 1.0)
                if hit[1] >= 0:
                    total += radiance(hit, kinds, rows, eyes, lights, lamps, look, grain)[0]
            out[r, c] = total / spots.shape[0]
