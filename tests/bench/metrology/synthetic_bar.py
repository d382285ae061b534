"""A scanned ball bar: recordings of its spheres and its rod, as an arm would make them.

Everything is exact but for the noise and the faults that are planted.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from crenel.formats.recording.writer import RecordingWriter
from crenel.metrology.transforms import Floats, inverse, rigid
from tests.bench.metrology.synthetic_arm import PoseArm
from tests.bench.metrology.synthetic_sphere import (
    FRAME_NS,
    HEIGHT,
    T_FLANGE_SENSOR,
    WIDTH,
    Faults,
    cut_sphere,
    scan_orientation,
    stripe_of_points,
    true_camera,
)

ROD_SHARE = 0.4
"""Radius of the rod as a share of that of the spheres."""
BEYOND_MM = 6.0
"""The scan goes on over the rod so far."""
STEP_MM = 0.5
WAY_FRAMES = 50
"""So long the arm is on its way from one pass to the next; these frames are not recorded."""
NO_FAULTS = Faults()


def write_bar_scan(
    folder: Path,
    centres_mm: Sequence[Floats],
    diameter_mm: float,
    articulations: Sequence[int] = (1, 2),
    faults: Faults = NO_FAULTS,
    seed: int = 1,
) -> None:
    """Writes ``scan.mcap``: each sphere is passed over once in each articulation.

    Args:
        centres_mm: (3,) of each sphere, along a line, arm frame.
        articulations: of the one-sphere test, by their numbers.
    """
    folder.mkdir(parents=True)
    arm, random, number = PoseArm(), np.random.default_rng(seed), 0
    camera = true_camera()
    passes = [(centre, held) for centre in centres_mm for held in articulations]
    with RecordingWriter(folder / "scan.mcap", arm.joint_names) as writer:
        for centre, held in passes:
            R_arm_sensor = scan_orientation(held)
            reach_mm = diameter_mm / 2 + BEYOND_MM
            number += WAY_FRAMES
            for step_mm in np.arange(-reach_mm, reach_mm, STEP_MM):
                number += 1
                stamp_ns = 10**9 + number * FRAME_NS
                T_arm_sensor = rigid(R_arm_sensor, centre + R_arm_sensor[:, 2] * step_mm)
                reading = arm.reading(T_arm_sensor @ inverse(T_FLANGE_SENSOR))
                assert reading is not None, "such an arm is in every pose"
                for ms in (-4, 4):
                    writer.reading(stamp_ns + ms * 10**6, reading)
                lit = _lit_points(T_arm_sensor, centres_mm, diameter_mm / 2)
                stripe = None if lit is None else stripe_of_points(camera, *lit, faults, random)
                if stripe is not None:
                    writer.stripe(stamp_ns, stripe, WIDTH, HEIGHT)


def _lit_points(
    T_arm_sensor: Floats, centres_mm: Sequence[Floats], radius_mm: float
) -> tuple[Floats, Floats] | None:
    """Points (N, 3) in the laser plane and their normals, of spheres and rod; None of neither."""
    T = inverse(T_arm_sensor)
    centres = [(T @ np.append(centre, 1.0))[:3] for centre in centres_mm]
    cuts = [cut for one in centres if (cut := cut_sphere(one, radius_mm)) is not None]
    rod = _cut_rod(centres, radius_mm) if len(centres) > 1 else []
    near = [
        (points[close], outward[close])
        for points, outward in [*cuts, *rod]
        if (close := np.linalg.norm(points, axis=1) < 3 * radius_mm).any()
    ]
    if not near:
        return None
    return np.concatenate([one for one, _ in near]), np.concatenate([one for _, one in near])


def _cut_rod(centres_mm: Sequence[Floats], radius_mm: float) -> list[tuple[Floats, Floats]]:
    """The same of the rod, outside the spheres; empty where it lies in the laser plane."""
    first_mm, last_mm = centres_mm[0], centres_mm[-1]
    along = (last_mm - first_mm) / np.linalg.norm(last_mm - first_mm)
    if abs(along[2]) < 0.05:
        return []
    across = np.cross(along, [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    turn = np.linspace(0, 2 * np.pi, 400, endpoint=False)[:, None]
    outward = np.cos(turn) * across + np.sin(turn) * np.cross(along, across)
    ring = first_mm + ROD_SHARE * radius_mm * outward
    points = ring - (ring[:, 2] / along[2])[:, None] * along
    place = (points - first_mm) @ along
    there = (place > 0) & (place < np.linalg.norm(last_mm - first_mm))
    for centre in centres_mm:
        there &= np.linalg.norm(points - centre, axis=1) > radius_mm
    return [(points[there], outward[there])] if there.any() else []
