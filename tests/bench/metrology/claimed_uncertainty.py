"""The test value uncertainty of every figure against what artefact and set-up truly do.

Each simulated test is evaluated twice with the same noise of arm and scanner: on the sphere as it
is, drawn from its certificate and drifting, and on a perfect one that stands still. The figures
differ by what the uncertainty has to cover.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.gauges.judgement.evaluate_measured_data import MeasuredData, ScanCloud
from crenel.gauges.judgement.maths_value_uncertainty import LOBES, deviations_of_lobes
from crenel.gauges.plan.document import ARTICULATIONS, SpherePart, sphere_feature, sphere_scan
from crenel.gauges.plan.document_symbols import SPHERE_QUANTITIES, Quantity
from crenel.gauges.plan.document_temperatures import EndTemperatures
from crenel.gauges.plan.maths_lengths import CalibratedLength, MeasuredLength
from crenel.gauges.plan.maths_temperature import TemperatureSpan, mean_temperature
from crenel.gauges.sphere.evaluate import measure_position
from crenel.gauges.sphere.evaluate_position import (
    PositionResult,
    sphere_certificate,
    sphere_uncertainty_um,
)
from crenel.gauges.sphere.maths_articulation import articulation_directions
from crenel.metrology.arm.kinematics import RobotArm, Tip
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from tests.bench.metrology.synthetic_arm import TIP
from tests.bench.metrology.synthetic_sphere import (
    CENTRE,
    POLE,
    TouchGroup,
    sphere_plan,
    touch_groups,
)

SPHERE = SpherePart(
    name="Sphere", diameter_mm=25.0, diameter_sd_um=0.5, form_um=1.0, form_sd_um=0.2
)
TOUCH_SD_MM, POINT_SD_MM = 0.003, 0.008
DRIFT_SD_MM = 0.003
"""Along each axis, over the whole test."""
POINTS, FRAMES = 3000, 40
"""Of a scan."""
SEEN_DEG = 58.0
LENGTH = CalibratedLength(500.0, 0.8, 11.5e-6, 1.0e-6)
TEMPERATURE_C, TEMPERATURE_SD_C = 23.0, 0.1
WARMER_C = 0.8
"""By so much between beginning and end."""


@dataclass(frozen=True)
class ClaimedRow:
    """Standard uncertainty as stated over the scatter that is observed; 1 is right."""

    figure: str
    ratio: float


@dataclass(frozen=True)
class TrueSphere:
    """A sphere as it is."""

    radius_off_mm: float = 0.0
    form_mm: float = 0.0
    """Largest minus smallest deviation."""
    lobes: int = 0
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    phase_rad: float = 0.0
    drift_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """From the beginning of the test to its end."""

    def deviations_mm(self, outward: Floats) -> Floats:
        """(N,) of its surface in directions (N, 3) from the calibrated one."""
        off = deviations_of_lobes(outward, np.array(self.axis), self.lobes, self.phase_rad)
        return np.asarray(self.radius_off_mm + self.form_mm * off)


def coverage_rows(tests: int, progress: Progress = no_progress) -> list[ClaimedRow]:
    """A row for every figure, over so many simulated tests."""
    random = np.random.default_rng(7)
    off: dict[Quantity, list[float]] = {of: [] for of in SPHERE_QUANTITIES}
    stated: dict[Quantity, list[float]] = {of: [] for of in SPHERE_QUANTITIES}
    certificate = sphere_certificate(SPHERE)
    for test in range(tests):
        progress(test / tests, f"test {test + 1} of {tests}")
        noise = int(random.integers(1 << 30))
        sphere = draw_sphere(random)
        found, perfect = (_measure(one, noise) for one in (sphere, TrueSphere()))
        moved_um = 1e3 * float(np.linalg.norm(sphere.drift_mm))
        for of in SPHERE_QUANTITIES:
            off[of].append(1e3 * (found.values_mm[of] - perfect.values_mm[of]))
            effect_um = found.form_effects_um.get(of)
            stated[of].append(sphere_uncertainty_um(of, certificate, moved_um, effect_um))
    rows = [ClaimedRow(of, rms(stated[of]) / rms(off[of])) for of in SPHERE_QUANTITIES]
    return [*rows, _length_row(tests, random)]


def draw_sphere(random: np.random.Generator) -> TrueSphere:
    """A sphere that its certificate allows, with lobes about any axis, and that drifts."""
    axis = random.normal(size=3)
    axis /= np.linalg.norm(axis)
    drift = DRIFT_SD_MM * random.normal(size=3)
    return TrueSphere(
        radius_off_mm=5e-4 * SPHERE.diameter_sd_um * float(random.normal()),
        form_mm=1e-3 * (SPHERE.form_um + SPHERE.form_sd_um * float(random.normal())),
        lobes=int(random.integers(*LOBES)),
        axis=(axis[0], axis[1], axis[2]),
        phase_rad=float(random.uniform(0, 2 * np.pi)),
        drift_mm=(drift[0], drift[1], drift[2]),
    )


class _Scans(MeasuredData):
    """Scans that are in memory."""

    clouds: dict[str, ScanCloud]

    def has_scan(self, name: str) -> bool:
        return name in self.clouds

    def scan(self, name: str) -> ScanCloud:
        return self.clouds[name]


def _measure(sphere: TrueSphere, seed: int) -> PositionResult:
    random = np.random.default_rng(seed)
    groups = touch_groups(CENTRE, np.zeros(3))
    times = np.linspace(0.0, 1.0, len(groups) + ARTICULATIONS)
    drift = np.array(sphere.drift_mm)
    tips = {
        group.feature: _tips(sphere, group, drift * t, random)
        for group, t in zip(groups[:-1], times, strict=False)
    }
    clouds = {}
    held = articulation_directions(POLE, -CENTRE)
    for number, (direction, t) in enumerate(zip(held, times[len(groups) - 1 :], strict=False), 1):
        clouds[sphere_scan(1, number)] = _cloud(sphere, direction, drift * t, random)
    tips[sphere_feature(1, "end")] = _tips(sphere, groups[-1], drift, random)
    styli = {
        group.feature: np.tile(
            POLE if group.stylus_from is None else group.stylus_from, (len(group.outward), 1)
        )
        for group in groups
    }
    arm = RobotArm("Arm", "A-1", Tip(TIP.x_mm, TIP.y_mm, TIP.z_mm, TIP.diameter_mm))
    data = _Scans(Path(), sphere_plan(SPHERE), arm, None, tips, styli, (), EndTemperatures())
    object.__setattr__(data, "clouds", clouds)
    return measure_position(data, SPHERE, 1)


def _tips(
    sphere: TrueSphere, group: TouchGroup, moved_mm: Floats, random: np.random.Generator
) -> Floats:
    reach = (SPHERE.diameter_mm + TIP.diameter_mm) / 2 + sphere.deviations_mm(group.outward)
    reach += TOUCH_SD_MM * random.normal(size=len(reach))
    return np.asarray(CENTRE + moved_mm + reach[:, None] * group.outward)


def _cloud(
    sphere: TrueSphere, direction: Floats, moved_mm: Floats, random: np.random.Generator
) -> ScanCloud:
    cosine = 1 - random.random(POINTS) * (1 - np.cos(np.radians(SEEN_DEG)))
    turn = random.uniform(0, 2 * np.pi, POINTS)
    x = np.cross(direction, np.eye(3)[int(np.argmin(np.abs(direction)))])
    x /= np.linalg.norm(x)
    side = np.cos(turn)[:, None] * x + np.sin(turn)[:, None] * np.cross(direction, x)
    outward = cosine[:, None] * direction + np.sqrt(1 - cosine**2)[:, None] * side
    reach = SPHERE.diameter_mm / 2 + sphere.deviations_mm(outward)
    reach += POINT_SD_MM * random.normal(size=POINTS)
    points = CENTRE + moved_mm + reach[:, None] * outward
    frames: NDArray[np.int64] = random.integers(0, FRAMES, POINTS)
    R = np.column_stack([x, np.cross(direction, x), direction])
    return ScanCloud(points, frames, np.tile(direction, (POINTS, 1)), R)


def _length_row(tests: int, random: np.random.Generator) -> ClaimedRow:
    """Errors of length by an arm without error, while the artefact warms up."""
    off, stated = [], []
    for _ in range(tests):
        at_20_mm = LENGTH.length_mm + 1e-3 * LENGTH.standard_uncertainty_um * random.normal()
        expansion = LENGTH.expansion_per_c + LENGTH.expansion_sd_per_c * random.normal()
        thermometer_c = TEMPERATURE_SD_C * random.normal()
        begin_c, end_c = TEMPERATURE_C + thermometer_c, TEMPERATURE_C + WARMER_C + thermometer_c
        artefact = mean_temperature(TemperatureSpan(begin_c, end_c), TEMPERATURE_SD_C)
        then_c = TEMPERATURE_C + WARMER_C * random.random()
        length_mm = at_20_mm * (1 + expansion * (then_c - 20.0))
        one = MeasuredLength(1, 1, LENGTH, length_mm, artefact)
        off.append(one.error_um)
        stated.append(one.test_uncertainty_um)
    return ClaimedRow("length-touch", rms(stated) / rms(off))


def rms(values: list[float]) -> float:
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))
