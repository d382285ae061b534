"""The pixel loops of the laser's light: where its sheet falls, and what of it is seen.

All work in the camera's frame, in which a pixel's ray is ``(x, y, 1)``.
"""

import numpy as np

from hardware.compiled import kernel
from hardware.twin.casting import Codes, Image, Lines
from hardware.twin.kinematics import Floats
from hardware.twin.tracing import Ints, albedo, trace

NOTHING = -4
"""Code of a pixel that sees no thing; even, as all that the laser does not reach."""
REACH = 4.0
"""Half thicknesses of the sheet beyond which its light is nothing."""


@kernel
def _see(x: float, y: float, z: float, lens: Floats) -> tuple[float, float]:
    """Pixel of a point in the camera frame; ``lens`` is fx, fy, cx, cy, k1, k2, p1, p2, k3."""
    a, b = x / z, y / z
    r2 = a * a + b * b
    radial = 1.0 + r2 * (lens[4] + r2 * (lens[5] + r2 * lens[8]))
    ad = a * radial + 2.0 * lens[6] * a * b + lens[7] * (r2 + 2.0 * a * a)
    bd = b * radial + lens[6] * (r2 + 2.0 * b * b) + 2.0 * lens[7] * a * b
    return lens[0] * ad + lens[2], lens[1] * bd + lens[3]


@kernel
def _land(
    angle: float,
    fan: Floats,
    emitter: Floats,
    sheet: Floats,
    lens: Floats,
    kinds: Ints,
    rows: Floats,
    lamps: Floats,
    ray: Floats,
) -> None:
    """Fills ``ray``: angle, pixel u, v where it lands, the stripe's half thickness there, a face.

    The thickness, in px, is -1 where the ray meets nothing that the camera could see.
    """
    ray[0], ray[1], ray[2], ray[3], ray[4] = angle, 0.0, 0.0, -1.0, -1.0
    c, s = np.cos(angle), np.sin(angle)
    dx = c * fan[0, 0] + s * fan[1, 0]
    dy = c * fan[0, 1] + s * fan[1, 1]
    dz = c * fan[0, 2] + s * fan[1, 2]
    t, k, face, nx, ny, nz, _, _, _ = trace(kinds, rows, lamps, dx, dy, dz)
    x, y, z = emitter[0] + t * dx, emitter[1] + t * dy, emitter[2] + t * dz
    if k < 0 or z <= 1.0:
        return
    across = 0.0
    for axis in range(3):
        along = lamps[k, axis] * nx + lamps[k, 3 + axis] * ny + lamps[k, 6 + axis] * nz
        across += sheet[axis] * along
    spread = 1.0 / np.sqrt(max(1.0 - across * across, 0.01))
    u, v = _see(x, y, z, lens)
    if abs(u) < 1e5 and abs(v) < 1e5:
        ray[1], ray[2], ray[3] = u, v, sheet[4] * spread * lens[0] / z
        ray[4] = k * 1024 + face


@kernel
def trace_fan(
    angles: Floats,
    fan: Floats,
    emitter: Floats,
    sheet: Floats,
    lens: Floats,
    kinds: Ints,
    rows: Floats,
    lamps: Floats,
) -> Floats:
    """Where the laser's light lands, in order along the fan: (M, 5) rays as ``_land`` fills them.

    ``fan`` (2, 3): the sheet's middle and sideways directions, in the camera's frame.
    Where two rays at ``angles`` land apart, more are traced between them, so that
    no lit part of a face is missed.
    """
    landed = np.empty((8 * angles.shape[0], 5))
    _land(angles[0], fan, emitter, sheet, lens, kinds, rows, lamps, landed[0])
    count = 1
    waiting = np.empty((12, 5))
    for i in range(1, angles.shape[0]):
        _land(angles[i], fan, emitter, sheet, lens, kinds, rows, lamps, waiting[0])
        height = 1
        while height > 0 and count < landed.shape[0]:
            last, ray = landed[count - 1], waiting[height - 1]
            apart = max(abs(ray[1] - last[1]), abs(ray[2] - last[2])) > 3.0 or ray[4] != last[4]
            if apart and height < 12 and (ray[3] > 0.0 or last[3] > 0.0):
                middle = 0.5 * (last[0] + ray[0])
                _land(middle, fan, emitter, sheet, lens, kinds, rows, lamps, waiting[height])
                height += 1
            else:
                landed[count] = ray
                count += 1
                height -= 1
    return landed[:count]


@kernel
def band_around(landed: Floats, codes: Codes, band: Ints) -> int:
    """Marks the pixels around the landed rays; lists them in ``band``.

    ``codes`` is -2 where unmarked and becomes -1; pixel = row * width + column.
    """
    height, width = codes.shape
    count = 0
    u0, v0 = -1e9, -1e9
    flat = True
    for i in range(landed.shape[0]):
        u, v, w = landed[i, 1], landed[i, 2], landed[i, 3]
        if w < 0.0 or (max(abs(u - u0), abs(v - v0)) < 0.5 and i % 8 > 0):
            continue
        near = max(abs(u - u0), abs(v - v0)) < 8.0
        flat = abs(u - u0) >= abs(v - v0) if near else True
        u0, v0 = u, v
        reach = int(min(REACH * w + 1.0, 60.0))
        if flat:
            tall, wide = reach, (2 if near else 6)
        else:
            tall, wide = 2, reach
        if not near:
            tall = max(tall, 6)
        c0, r0 = int(np.floor(u + 0.5)), int(np.floor(v + 0.5))
        for r in range(max(r0 - tall, 0), min(r0 + tall + 1, height)):
            for c in range(max(c0 - wide, 0), min(c0 + wide + 1, width)):
                if codes[r, c] == -2:
                    codes[r, c] = -1
                    band[count] = r * width + c
                    count += 1
    return count


@kernel
def _laser_at(
    dx: float,
    dy: float,
    emitter: Floats,
    sheet: Floats,
    kinds: Ints,
    rows: Floats,
    eyes: Floats,
    lamps: Floats,
) -> tuple[float, int, float]:
    """Laser light seen along (dx, dy, 1): brightness, code of what was met, distance to the sheet.

    ``sheet``: normal, offset, half thickness. The code is odd where the laser reaches.
    """
    t, k, face, nx, ny, nz, lx, ly, lz = trace(kinds, rows, eyes, dx, dy, 1.0)
    if k < 0:
        return 0.0, NOTHING, 1e9
    x, y, z = t * dx, t * dy, t
    off = sheet[0] * x + sheet[1] * y + sheet[2] * z - sheet[3]
    code = (k * 1024 + face) * 2
    if abs(off) > REACH * sheet[4]:
        return 0.0, code, off
    ex, ey, ez = lamps[k, 9] - lx, lamps[k, 10] - ly, lamps[k, 11] - lz
    length = np.sqrt(ex * ex + ey * ey + ez * ez)
    slope = (nx * ex + ny * ey + nz * ez) / length
    if slope <= 0.0:
        return 0.0, code, off
    reached, _, _, _, _, _, _, _, _ = trace(
        kinds, rows, lamps, x - emitter[0], y - emitter[1], z - emitter[2]
    )
    if reached < 1.0 - 2e-6:
        return 0.0, code, off
    bell = np.exp(-0.5 * (off / sheet[4]) ** 2)
    return albedo(kinds[k], rows, k, face) * slope * bell, code + 1, off


@kernel
def _rays_needed(codes: Codes, offs: Image, r: int, c: int, sigma: float) -> int:
    """Whether one ray will do for a pixel (0), or it needs a few (1), or many (2).

    Many where a lit face ends, few where the stripe is so foreshortened that its
    profile is narrow for the pixels.
    """
    own, off, needed = codes[r, c], offs[r, c], 0
    reach, thin = REACH * sigma, 1.4 * sigma
    for k in range(4):
        rr, cc = r + int(k == 0) - int(k == 1), c + int(k == 2) - int(k == 3)
        if rr < 0 or cc < 0 or rr >= codes.shape[0] or cc >= codes.shape[1]:
            continue
        other, other_off = codes[rr, cc], offs[rr, cc]
        if other == -2 or (own & 1 == 0 and other & 1 == 0):
            continue
        near = max(abs(off), abs(other_off)) <= reach
        if own >> 1 != other >> 1 or (near and own != other):
            return 2
        if abs(other_off - off) > thin:
            needed = 1
    return needed


@kernel
def _averaged(
    lines: Lines,
    spots: Floats,
    r: int,
    c: int,
    emitter: Floats,
    sheet: Floats,
    kinds: Ints,
    rows: Floats,
    eyes: Floats,
    lamps: Floats,
) -> float:
    """Laser light over a whole pixel, from a ray through each of its ``spots``."""
    x0, y0 = lines[r + 1, c + 1, 0], lines[r + 1, c + 1, 1]
    xu, yu = lines[r + 1, c + 2, 0] - x0, lines[r + 1, c + 2, 1] - y0
    xv, yv = lines[r + 2, c + 1, 0] - x0, lines[r + 2, c + 1, 1] - y0
    total = 0.0
    for s in range(spots.shape[0]):
        a, b = spots[s, 0], spots[s, 1]
        dx, dy = x0 + a * xu + b * xv, y0 + a * yu + b * yv
        value, _, _ = _laser_at(dx, dy, emitter, sheet, kinds, rows, eyes, lamps)
        total += value
    return float(total / spots.shape[0])


@kernel
def cast_laser(
    lines: Lines,
    band: Ints,
    count: int,
    many: Floats,
    few: Floats,
    emitter: Floats,
    sheet: Floats,
    kinds: Ints,
    rows: Floats,
    eyes: Floats,
    lamps: Floats,
    codes: Codes,
    offs: Image,
    out: Image,
) -> None:
    """Laser light in every pixel of the band, averaged over the pixel where it may be broken.

    ``lines`` has one pixel of margin that ``out`` has not; ``many`` and ``few`` are
    lattices of rays over a pixel.
    """
    width = out.shape[1]
    for i in range(count):
        r, c = band[i] // width, band[i] % width
        x0, y0 = lines[r + 1, c + 1, 0], lines[r + 1, c + 1, 1]
        value, code, off = _laser_at(x0, y0, emitter, sheet, kinds, rows, eyes, lamps)
        out[r, c], codes[r, c], offs[r, c] = value, code, off
    for i in range(count):
        r, c = band[i] // width, band[i] % width
        needed = _rays_needed(codes, offs, r, c, sheet[4])
        if needed > 0:
            spots = many if needed > 1 else few
            out[r, c] = _averaged(lines, spots, r, c, emitter, sheet, kinds, rows, eyes, lamps)
