"""Faults planted on the rendered simulated station, and the figures in which they should show."""

import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from scipy.optimize import brentq
from scipy.stats import norm

from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import sphere_feature
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.sphere.maths_location import smallest_enclosing_sphere
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from crenel_hardware.simulator.devices.kinematics import tip_centres
from tests.bench.metrology.bar_touches import BarTest
from tests.bench.metrology.rendered_sphere import OUTLIER_MM, RenderedStation, with_wrong_link
from tests.bench.metrology.sphere_geometry import PointMovement, scan_effect, sphere_change
from tests.bench.metrology.synthetic_sphere import POLE, PlantedFaults, touch_groups

COLUMNS = ("fault", "figure, µm", "expected", "found", "without the fault")
MATRIX_MM, SCALE, LINK_MM, TIP_MM, MOVED_MM, OUTLIERS = 0.05, 1.001, 0.1, -0.02, 0.1, 0.04
HELD = 0.95
DRAWS = 400


@dataclass(frozen=True)
class PlantedFaultRow:
    """A figure in µm with one fault and without it."""

    fault: str
    figure: str
    expected: float
    found: float
    without: float


def run(progress: Progress = no_progress) -> list[PlantedFaultRow]:
    """All rows."""
    station = RenderedStation(progress=lambda share, text: progress(0.3 * share, text))
    with tempfile.TemporaryDirectory() as folder:
        tests = FaultTests(station, Path(folder))
        rows = []
        for number, part in enumerate(tests.parts):
            progress(0.3 + 0.7 * number / len(tests.parts), "planted faults")
            rows += part()
    return rows


def table(rows: Sequence[PlantedFaultRow]) -> list[tuple[str, str, str, str, str]]:
    """For the console."""
    return [
        (row.fault, row.figure, f"{row.expected:.1f}", f"{row.found:.1f}", f"{row.without:.1f}")
        for row in rows
    ]


class FaultTests:
    """One-sphere tests with one fault each, beside the one without. The noise is the same."""

    def __init__(self, station: RenderedStation, folder: Path) -> None:
        self.station, self.folder = station, folder
        self.clean = evaluate_performance(station.write(folder / "clean"))
        self.parts: tuple[Callable[[], list[PlantedFaultRow]], ...] = (
            *(partial(self.matrix_rows, axis) for axis in range(3)),
            self.scale_rows,
            self.link_rows,
            self.tip_rows,
            self.movement_rows,
            self.outlier_rows,
        )

    def matrix_rows(self, axis: int) -> list[PlantedFaultRow]:
        """The probe matrix is off along an axis of the sensor's frame."""
        along = np.eye(3)[axis]
        offset = MATRIX_MM * along
        fault = PlantedFaults(matrix_offset_mm=(offset[0], offset[1], offset[2]))
        name, found = f"probe matrix off by 50 µm along {'xyz'[axis]}", self._evaluate(fault)
        assert found.offset is not None
        assert self.clean.offset is not None
        sizes = [1e3 * float(along @ one.offset_mm) for one in (found.offset, self.clean.offset)]
        U_um = 2e3 * float(along @ found.offset.standard_uncertainty_mm)
        figure = f"implied error, U = {U_um:.1f}"
        rows = self._scan_rows(name, found, lambda T, _: -T[:3, :3] @ offset)
        return [*rows, PlantedFaultRow(name, figure, 1e3 * MATRIX_MM, *sizes)]

    def scale_rows(self) -> list[PlantedFaultRow]:
        """What the sensor measures is 0.1 % too large, about the middle of its range."""
        found, share = self._evaluate(PlantedFaults(scale=SCALE)), SCALE - 1
        name = "sensor's scale 0.1 % too large"
        return self._scan_rows(name, found, lambda T, point: share * (point - T[:3, 3]))

    def link_rows(self) -> list[PlantedFaultRow]:
        """The second link is longer than its datasheet states."""
        fault, name = PlantedFaults(link_mm=LINK_MM), "second link 0.1 mm longer than stated"
        found, station = self._evaluate(fault), self.station
        stated = with_wrong_link(station.rig, fault)
        changes = {}
        for group in touch_groups(station.centre_mm, np.zeros(3)):
            q_rad = station.touched_rad[group.feature]
            off = tip_centres(stated, q_rad) - tip_centres(station.rig.arm, q_rad)
            changes[group.feature] = sphere_change(group.outward, off)
        centres = [changes[sphere_feature(1, "location", i + 1)][:3] for i in range(5)]
        location_um = 1e3 * smallest_enclosing_sphere(np.array(centres)).diameter_mm
        size_um = 2e3 * float(changes[sphere_feature(1, "pattern")][3])
        bar = BarTest(station, self.folder / "bar")
        worst = [PlantedFaultRow(name, "E_Uni by touch, largest", *bar.largest_um(fault))]
        return [
            *worst,
            self._row(name, found, "location-touch", "L_Dia by touch", location_um, 0.0),
            self._row(name, found, "size-touch", "P_Size by touch", size_um),
        ]

    def tip_rows(self) -> list[PlantedFaultRow]:
        """The tip is worn."""
        name, found = "tip worn by 20 µm", self._evaluate(PlantedFaults(tip_excess_mm=TIP_MM))
        return [
            self._row(name, found, "size-touch", "P_Size by touch", 1e3 * TIP_MM),
            self._row(name, found, "form-touch", "P_Form by touch", 0.0),
            self._row(name, found, "location-touch", "L_Dia by touch", 0.0),
        ]

    def movement_rows(self) -> list[PlantedFaultRow]:
        """The sphere moves before the touches at the end; no figure is stated then."""
        found = self._evaluate(PlantedFaults(moved_mm=(MOVED_MM, 0.0, 0.0)))
        assert all(figure.value is None for figure in found.figures)
        sizes = [one.spheres[0].moved_um or 0.0 for one in (found, self.clean)]
        return [PlantedFaultRow("sphere moved by 100 µm", "movement", 1e3 * MOVED_MM, *sizes)]

    def outlier_rows(self) -> list[PlantedFaultRow]:
        """Points of the scanner are false."""
        name, found = "4 % outliers", self._evaluate(PlantedFaults(outliers=OUTLIERS))
        wider_um = _dispersion_growth_um(value_of(self.clean, "dispersion-scan"))
        rougher_um = _form_growth_um(self.clean)
        return [
            self._row(name, found, "dispersion-scan", "P_Form.Sph.D95% by scan", wider_um),
            self._row(name, found, "form-scan", "P_Form.Sph.1x25 by scan", rougher_um),
            self._row(name, found, "size-all-scan", "P_Size.Sph.All by scan", 0.0),
        ]

    def _evaluate(self, fault: PlantedFaults) -> PerformanceFile:
        folder = self.folder / f"fault-{sum(1 for _ in self.folder.iterdir())}"
        return evaluate_performance(self.station.write(folder, fault))

    def _row(
        self,
        name: str,
        found: PerformanceFile,
        of: Quantity,
        figure: str,
        effect_um: float,
        begin_um: float | None = None,
    ) -> PlantedFaultRow:
        """``effect_um`` is added to the figure without the fault, or to ``begin_um``."""
        without = value_of(self.clean, of)
        expected = effect_um + (without if begin_um is None else begin_um)
        return PlantedFaultRow(name, figure, expected, value_of(found, of), without)

    def _scan_rows(
        self, name: str, found: PerformanceFile, movement: PointMovement
    ) -> list[PlantedFaultRow]:
        effect = scan_effect(self.station, movement)
        return [
            self._row(name, found, "location-scan", "L_Dia by scan", effect.location_um, 0.0),
            self._row(name, found, "size-scan", "P_Size.Sph.1x25 by scan", effect.size_um),
            self._row(name, found, "size-touch", "P_Size by touch", 0.0),
        ]


def value_of(result: PerformanceFile, quantity: Quantity) -> float:
    """The value of a quantity in µm."""
    value = next(one.value for one in result.figures if one.quantity == quantity)
    assert value is not None, quantity
    return value


def _dispersion_growth_um(dispersion_um: float) -> float:
    """By how much outliers widen the shell that holds 95 % of normally distributed points."""
    sd_um = dispersion_um / (2 * norm.ppf((1 + HELD) / 2))

    def missing(half_um: float) -> float:
        good = 2 * norm.cdf(half_um / sd_um) - 1
        false = min(half_um / (1e3 * OUTLIER_MM), 1.0)
        return float((1 - OUTLIERS) * good + OUTLIERS * false - HELD)

    return float(2 * brentq(missing, 0.0, 1e3 * OUTLIER_MM) - dispersion_um)


def _form_growth_um(clean: PerformanceFile) -> float:
    """By how much outliers raise the form of the means of 25 patches."""
    random = np.random.default_rng(5)
    patches = clean.spheres[0].patches
    off: Floats = np.array([patch.deviation_um or 0.0 for patch in patches])
    points = np.array([patch.points for patch in patches])
    sd = 1e3 * OUTLIER_MM * np.sqrt(OUTLIERS / 3 / points)
    J = np.column_stack([pattern_directions(POLE), np.ones(len(off))])
    left = np.eye(len(off)) - J @ np.linalg.pinv(J)
    drawn = (off + sd * random.normal(size=(DRAWS, len(off)))) @ left
    return float(np.ptp(drawn, axis=1).mean() - np.ptp(off @ left))
