"""How bright a point of a thing looks under the room's light.

The light comes from afar, or from a lamp near by, whose shadows, fading and highlights
are then worked out ray by ray; the rest of it comes from everywhere alike.
"""

import numpy as np
from numpy.typing import NDArray

from hardware.compiled import kernel
from hardware.twin.kinematics import Floats
from hardware.twin.tracing import Hit, Ints, albedo, trace

GRAIN_PER_MM = 5.0
MARKS_LONGER = 40.0
"""Length of a tool mark over its width."""
MARK_TEXELS = 4.0
"""Texels of the grain that make one mark's width."""
ON_SURFACE = 1e-5
"""A shadow's cause lies nearer to the lamp by this share of the way at least."""


@kernel
def _grain_at(grain: NDArray[np.float32], a: float, b: float) -> float:
    """The texture between its texels; repeats for ever."""
    i, j = int(np.floor(a)), int(np.floor(b))
    wa, wb = a - i, b - j
    i0, i1, j0, j1 = i & 255, (i + 1) & 255, j & 255, (j + 1) & 255
    g = (1.0 - wb) * ((1.0 - wa) * grain[j0, i0] + wa * grain[j0, i1])
    g += wb * ((1.0 - wa) * grain[j1, i0] + wa * grain[j1, i1])
    return float(g)


@kernel
def _sky(hit: Hit, kind: int, rows: Floats, shade: float) -> float:
    """Share of the light that the block's own walls leave to a point; ``shade``: how strictly."""
    _, k, face, _, _, _, x, _, z = hit
    if kind != 0 or shade <= 0.0 or face == 0:
        return 1.0
    groove, high, floor, f, sky = face // 8, rows[k, 13], rows[k, 14], face % 8, 1.0
    if f == 1:
        left, right = rows[k, 16 + 2 * groove + 1], rows[k, 16 + 2 * groove + 2]
        a, b, h = x - left, right - x, high - floor
        sky = 0.5 * (a / np.sqrt(a * a + h * h) + b / np.sqrt(b * b + h * h))
    elif f == 4 or f == 5:
        sky = 0.5 + 0.5 * (z - floor) / (high - floor)
    return float(1.0 - shade * (1.0 - min(max(sky, 0.0), 1.0)))


@kernel
def _surface(hit: Hit, rows: Floats, texture: float, grain: NDArray[np.float32]) -> float:
    """What grain and tool marks make of a face's brightness."""
    _, k, face, _, _, _, x, y, z = hit
    f, a, b = face % 8, x, y
    if f == 2 or f == 3:
        b = z + 31.0
    elif f == 4 or f == 5:
        a = z + 17.0
    a, b = a + 1000.0, b + 1000.0
    found = 1.0 + texture * _grain_at(grain, a * GRAIN_PER_MM, b * GRAIN_PER_MM)
    if rows[k, 50] > 0.0:
        per_mm = MARK_TEXELS / rows[k, 51]
        found += rows[k, 50] * _grain_at(grain, a * per_mm / MARKS_LONGER, b * per_mm)
    return float(max(found, 0.0))


@kernel
def _in_shadow(hit: Hit, kinds: Ints, rows: Floats, lamp: Floats) -> bool:
    """Whether a place (K, 16) on the lamp does not reach a point, or only from behind."""
    _, k, _, nx, ny, nz, x, y, z = hit
    lx, ly, lz = lamp[k, 9] - x, lamp[k, 10] - y, lamp[k, 11] - z
    if nx * lx + ny * ly + nz * lz <= 0.0:
        return True
    # From the lamp to the point, turned into the frame that rays are traced in.
    dx = -(lamp[k, 0] * lx + lamp[k, 3] * ly + lamp[k, 6] * lz)
    dy = -(lamp[k, 1] * lx + lamp[k, 4] * ly + lamp[k, 7] * lz)
    dz = -(lamp[k, 2] * lx + lamp[k, 5] * ly + lamp[k, 8] * lz)
    return bool(trace(kinds, rows, lamp, dx, dy, dz)[0] < 1.0 - ON_SURFACE)


@kernel
def _from_lamp(
    hit: Hit, rows: Floats, eye: Floats, lamp: Floats, away_mm: float
) -> tuple[float, float]:
    """Diffuse and mirrored light of one place (K, 16) on the lamp that reaches a point."""
    _, k, _, nx, ny, nz, x, y, z = hit
    lx, ly, lz = lamp[k, 9] - x, lamp[k, 10] - y, lamp[k, 11] - z
    far = np.sqrt(lx * lx + ly * ly + lz * lz)
    cosine = max(nx * lx + ny * ly + nz * lz, 0.0) / far
    strength = (away_mm / far) ** 2
    if rows[k, 48] <= 0.0:
        return cosine * strength, 0.0
    vx, vy, vz = eye[k, 9] - x, eye[k, 10] - y, eye[k, 11] - z
    near = np.sqrt(vx * vx + vy * vy + vz * vz)
    hx, hy, hz = lx / far + vx / near, ly / far + vy / near, lz / far + vz / near
    half = (nx * hx + ny * hy + nz * hz) / np.sqrt(hx * hx + hy * hy + hz * hz)
    return cosine * strength, strength * rows[k, 48] * max(half, 0.0) ** rows[k, 49]


@kernel
def _from_lamps(
    hit: Hit, kinds: Ints, rows: Floats, eye: Floats, lamps: Floats, away_mm: float
) -> tuple[float, float, int]:
    """Diffuse and mirrored light of the whole lamp (M, K, 16), and how many places reach.

    The middle and three places at the rim are tried first; where they agree, so do the rest.
    """
    count = lamps.shape[0]
    tried = min(count, 4)
    dark = 0
    diffuse, mirrored, lit = 0.0, 0.0, 0
    for m in range(count):
        # 0, then from the rim inwards.
        place = 0 if m == 0 else count - m
        if m < tried or 0 < dark < tried:
            shadowed = _in_shadow(hit, kinds, rows, lamps[place])
            if m < tried and shadowed:
                dark += 1
        else:
            shadowed = dark == tried
        if shadowed:
            continue
        one, glint = _from_lamp(hit, rows, eye, lamps[place], away_mm)
        diffuse += one / count
        mirrored += glint / count
        lit += 1
    return diffuse, mirrored, lit


@kernel
def radiance(
    hit: Hit,
    kinds: Ints,
    rows: Floats,
    eyes: Floats,
    lights: Floats,
    lamps: Floats,
    look: Floats,
    grain: NDArray[np.float32],
) -> tuple[float, int]:
    """Brightness of a point, 1 for a bright face, and how many places of the lamp reach it.

    ``lights``: (K, 3) the way to light from afar, in each thing's frame; ``lamps``:
    (M, K, 16) bundles from places on the lamp, none for light from afar; ``look``: directed,
    ambient, shade, texture, and the lamp's distance from the sensor frame's origin.
    """
    _, k, face, nx, ny, nz, _, _, _ = hit
    directed, mirrored, lit = 0.0, 0.0, 0
    if lamps.shape[0] == 0:
        directed = max(0.0, nx * lights[k, 0] + ny * lights[k, 1] + nz * lights[k, 2])
    else:
        directed, mirrored, lit = _from_lamps(hit, kinds, rows, eyes, lamps, look[4])
    sky = _sky(hit, kinds[k], rows, look[2])
    matt = albedo(kinds[k], rows, k, face) * (look[0] * directed + look[1]) * sky
    matt *= _surface(hit, rows, look[3], grain)
    return float(matt + look[0] * mirrored), lit
