"""Maps of simulated plates with a dent, a bump and a step: decisions against the truth.

Every draw has another station, arm, plate and noise: true errors are from the covariance that the
station's files state. A cell is judged by what is truly below its points, at 1 mm or more from
where the height changes.
"""

import tempfile
from pathlib import Path

import numpy as np

from crenel.metrology.transforms import Floats
from crenel.parts.cad.evaluate_part import read_part
from crenel.parts.deviation.evaluate_deviation import DeviationOrder, DeviationResult, deviate
from crenel.parts.deviation.maths_decisions import IN, OUT, UNDECIDED, DeviationLimits
from tests.bench.rows import bench_parser, measured_rows, rms
from tests.parts.meshes import write_stl
from tests.parts.simulated_inspection import (
    draw_station,
    draw_truth,
    plan_passes,
    scan_part,
    usual_passes,
    write_station,
)
from tests.parts.simulated_plate import Plate

LIMITS = DeviationLimits(-0.04, 0.04)
CLEAR_MM = 1.0


def draw_plate(rng: np.random.Generator) -> Plate:
    """A plate with its spots and its step somewhere."""
    dent, bump = rng.uniform(10.0, [54.0, 34.0]), rng.uniform([66.0, 10.0], [110.0, 34.0])
    x, y = rng.uniform([25.0, 46.0], [50.0, 54.0])
    width = float(rng.uniform(2.5, 4.5))
    spots = tuple(
        (float(at[0]), float(at[1]), height_mm, width, 3.0)
        for at, height_mm in ((dent, -0.05), (bump, 0.15))
    )
    return Plate(spots=spots, step=(float(x), float(y), float(x + 20), float(y + 20), 0.06))


def measure_draw(folder: Path, seed: int) -> tuple[Plate, DeviationResult]:
    """The map of one plate by one station."""
    rng = np.random.default_rng(seed)
    plate, station = draw_plate(rng), draw_station(int(rng.integers(1 << 30)))
    write_station(folder, station)
    planned = plan_passes(station, usual_passes(plate), seed)
    scan = folder / f"{seed}.mcap"
    scan_part(scan, plate, draw_truth(station, int(rng.integers(1 << 30))), planned, seed)
    part = read_part(write_stl(folder / "part.stl", plate.corners()), "mm")
    found = deviate(DeviationOrder(scan, part, limits=LIMITS))
    scan.unlink()
    return plate, found


def true_heights(plate: Plate, found: DeviationResult) -> Floats:
    """(C,) of the surface at each cell; NaN off the top, and where it changes within 1 mm."""
    cells = found.placed.cells
    x, y, z = cells.at_mm.T
    turns = np.linspace(0, 2 * np.pi, 8, endpoint=False)
    ring = [plate.relief_mm(x + CLEAR_MM * np.cos(a), y + CLEAR_MM * np.sin(a)) for a in turns]
    here = plate.relief_mm(x, y)
    is_top = (cells.normals[:, 2] > 0.9) & (z < plate.top_mm + 1)
    is_clear = np.abs(np.array(ring) - here).max(axis=0) < 0.001
    return np.where(is_top & is_clear, here, np.nan)


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("--draws", type=int, default=12)
    parser.add_argument("--first", type=int, default=1000, help="the first seed")
    given = parser.parse_args()
    places = {"dent -50 um": -0.05, "flat": 0.0, "step +60 um": 0.06, "bump +150 um": 0.15}
    counts = {name: np.zeros(3, np.int64) for name in places}
    medians: dict[str, list[float]] = {name: [] for name in places}
    pulls: list[Floats] = []
    with measured_rows(given.json) as rows, tempfile.TemporaryDirectory() as kept:
        for seed in range(given.first, given.first + given.draws):
            plate, found = measure_draw(Path(kept), seed)
            true, cells = true_heights(plate, found), found.placed.cells
            for name, height in places.items():
                here = np.abs(true - height) < 0.0005
                decided = found.decisions[here]
                counts[name] += [int((decided == one).sum()) for one in (IN, OUT, UNDECIDED)]
                off = (cells.deviation_mm - height)[here]
                medians[name].append(float(np.median(off) / np.median(found.u_mm[here])))
            flat = np.abs(true) < 0.0005
            pulls.append(cells.deviation_mm[flat] / found.u_mm[flat])
        for name in places:
            values = dict(zip(("in", "out", "undecided"), map(float, counts[name]), strict=True))
            worst = float(np.abs(medians[name]).max())
            rows.add(name, {**values, "worst median in u": worst})
        rows.add("flat", {"claimed/observed": 1 / rms(np.concatenate(pulls))})


if __name__ == "__main__":
    main()
