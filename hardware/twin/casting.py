"""The pixel loops of the room's light: what the camera gets of it from every face.

All work in the camera's frame, in which a pixel's ray is ``(x, y, 1)``.
"""

import numpy as np
from numpy.typing import NDArray

from hardware.compiled import kernel
from hardware.twin.kinematics import Floats
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
def _room_radiance(
    kind: int,
    rows: Floats,
    k: int,
    face: int,
    nx: float,
    ny: float,
    nz: float,
    x: float,
    y: float,
    z: float,
    lights: Floats,
    look: Floats,
    grain: Image,
) -> float:
    """Brightness of a point under the room's light; ``look``: directed, ambient, shade, texture."""
    directed, sky = max(0.0, nx * lights[k, 0] + ny * lights[k, 1] + nz * lights[k, 2]), 1.0
    f = face % 8
    if kind == 0 and look[2] > 0.0 and face != 0:
        groove, high, floor = face // 8, rows[k, 13], rows[k, 14]
        if f == 1:
            left, right = rows[k, 16 + 2 * groove + 1], rows[k, 16 + 2 * groove + 2]
            a, b, h = x - left, right - x, high - floor
            sky = 0.5 * (a / np.sqrt(a * a + h * h) + b / np.sqrt(b * b + h * h))
        elif f == 4 or f == 5:
            sky = 0.5 + 0.5 * (z - floor) / (high - floor)
        sky = 1.0 - look[2] * (1.0 - min(max(sky, 0.0), 1.0))
    a, b = x, y
    if f == 2 or f == 3:
        b = z + 31.0
    elif f == 4 or f == 5:
        a = z + 17.0
    ga, gb = (a + 1000.0) * 5.0, (b + 1000.0) * 5.0
    i, j = int(ga), int(gb)
    wa, wb = ga - i, gb - j
    i0, i1, j0, j1 = i & 255, (i + 1) & 255, j & 255, (j + 1) & 255
    g = (1.0 - wb) * ((1.0 - wa) * grain[j0, i0] + wa * grain[j0, i1])
    g += wb * ((1.0 - wa) * grain[j1, i0] + wa * grain[j1, i1])
    return float(rows[k, 4] * (look[0] * directed + look[1]) * sky * (1.0 + look[3] * g))


@kernel
def cast_room(
    lines: Lines,
    kinds: Ints,
    rows: Floats,
    eyes: Floats,
    lights: Floats,
    look: Floats,
    grain: Image,
    codes: Codes,
    out: Image,
) -> None:
    """One ray through each pixel's centre: brightness, and a code of the face that it meets."""
    for r in range(out.shape[0]):
        line, code_row, out_row = lines[r], codes[r], out[r]
        for c in range(out.shape[1]):
            _, k, face, nx, ny, nz, x, y, z = trace(kinds, rows, eyes, line[c, 0], line[c, 1], 1.0)
            code_row[c] = k * 1024 + face
            if k < 0:
                out_row[c] = 0.0
            else:
                out_row[c] = _room_radiance(
                    kinds[k], rows, k, face, nx, ny, nz, x, y, z, lights, look, grain
                )


@kernel
def _at_edge(codes: Codes, r: int, c: int) -> bool:
    """Whether any of the eight neighbours shows another face."""
    own = codes[r, c]
    for dr in range(-1, 2):
        for dc in range(-1, 2):
            if codes[r + dr, c + dc] != own:
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
    look: Floats,
    grain: Image,
    codes: Codes,
    out: Image,
) -> None:
    """Averages many rays over each pixel that an edge may cross."""
    for r in range(1, out.shape[0] - 1):
        for c in range(1, out.shape[1] - 1):
            if not _at_edge(codes, r, c):
                continue
            x0, y0 = lines[r, c, 0], lines[r, c, 1]
            xu, yu = lines[r, c + 1, 0] - x0, lines[r, c + 1, 1] - y0
            xv, yv = lines[r + 1, c, 0] - x0, lines[r + 1, c, 1] - y0
            total = 0.0
            for s in range(spots.shape[0]):
                a, b = spots[s, 0], spots[s, 1]
                dx, dy = x0 + a * xu + b * xv, y0 + a * yu + b * yv
                _, k, face, nx, ny, nz, x, y, z = trace(kinds, rows, eyes, dx, dy, 1.0)
                if k >= 0:
                    total += _room_radiance(
                        kinds[k], rows, k, face, nx, ny, nz, x, y, z, lights, look, grain
                    )
            out[r, c] = total / spots.shape[0]
