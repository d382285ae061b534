"""Touches of nests before and after something slips, with an arm that errs as its file says."""

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from crenel_hardware.simulator.devices.kinematics import solve_joints
from tests.parts.simulated_inspection import (
    PART_PLACE,
    Floats,
    Station,
    TrueStation,
    rigid,
    write_touches,
)

NESTS: dict[str, tuple[float, float, float]] = {
    "P1": (10.0, 10.0, 20.0),
    "P2": (110.0, 12.0, 20.0),
    "P3": (60.0, 75.0, 20.0),
    "B1": (-60.0, -40.0, 0.0),
    "B2": (190.0, -30.0, 5.0),
    "B3": (60.0, 150.0, 0.0),
}
REPEATS = 2


def nest_places() -> dict[str, Floats]:
    """Where the centre of the tip rests in each nest, arm frame."""
    return {
        name: PART_PLACE[:3, :3] @ np.array(at) + PART_PLACE[:3, 3] for name, at in NESTS.items()
    }


def small_motion(rng: np.random.Generator, size_mm: float) -> Floats:
    """A rigid motion (4, 4) that moves the part by about so much."""
    turn = Rotation.from_rotvec(rng.normal(size=3) * size_mm / 100).as_matrix()
    middle = PART_PLACE[:3, :3] @ np.array([60.0, 40.0, 10.0]) + PART_PLACE[:3, 3]
    shift = rng.normal(size=3)
    return rigid(turn, middle - turn @ middle + size_mm * shift / np.linalg.norm(shift))


def write_round(
    path: Path,
    station: Station,
    truth: TrueStation,
    places: dict[str, Floats],
    rng: np.random.Generator,
    seat_sd_mm: float = 0.003,
) -> None:
    """Touches of all nests, with postures that vary as a hand's do."""
    rows: list[list[object]] = []
    tip = np.array(truth.arm.tip_mm)
    q = np.array([-0.3, 0.5, 0.0, -1.6, 0.0, 1.2, 0.0])
    for name, place in places.items():
        for _ in range(REPEATS):
            lean = Rotation.from_euler("xy", rng.uniform(-8, 8, 2), degrees=True)
            turn = (lean * Rotation.from_euler("x", 180.0, degrees=True)).as_matrix()
            R = PART_PLACE[:3, :3] @ turn
            centre = place + rng.normal(size=3) * seat_sd_mm
            q = solve_joints(truth.arm, rigid(R, centre - R @ tip), q, rng)
            noisy = q + rng.normal(size=len(q)) * truth.arm.encoder_sd_rad
            rows.append([name, *np.degrees(noisy).tolist()])
    folder = path.parent / f"{path.stem}-touches"
    folder.mkdir()
    write_touches(folder, station, rows)
    (folder / "touches.csv").rename(path)
