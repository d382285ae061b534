"""The test value uncertainty of the plane, of lengths by scan and of the contact tests against what
artefact and set-up truly do.

As in ``claimed_uncertainty``, each test is evaluated twice with the same noise: on artefacts drawn
from their certificates, at a temperature of which only a measured value is known, and on perfect
ones at 20 °C.
"""

from dataclasses import dataclass
from functools import partial

import numpy as np

from crenel.gauges.contact.maths import (
    PLACEMENTS,
    SPHERE_POINTS,
    SPHERES,
    effective_diameter,
    volumetric_length,
    volumetric_uncertainty_um,
)
from crenel.gauges.judgement.evaluate_measured_data import ScanCloud
from crenel.gauges.judgement.maths_value_uncertainty import (
    DIAMETER_BY_FORM_OF_NINE,
    LOBES,
    PlateCertificate,
    SphereCertificate,
    draw_plate_form,
    plane_effect_um,
    size_uncertainty_um,
)
from crenel.gauges.plan.maths_lengths import CalibratedLength, MeasuredLength, length_of_bar_mm
from crenel.gauges.plan.maths_temperature import MeanTemperature
from crenel.gauges.plane.evaluate import measure_plate_scan
from crenel.gauges.sphere.maths_articulation import frame_about
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.metrology.fitting.reference_sphere import dispersion_mm, sphere_centre
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from tests.bench.metrology.claimed_uncertainty import ClaimedRow, TrueSphere, rms

TOUCH_SD_MM, POINT_SD_MM = 0.003, 0.008
PLATE = PlateCertificate(flatness_um=4.0, flatness_sd_um=0.5)
SIDE_MM, POINTS, SHELL_MM = 100.0, 6000, 10.0
MASTER = SphereCertificate(25.0, 0.5, 1.0, 0.2, 8e-6, 1e-6)
BAR = CalibratedLength(400.0, 0.8, 11.5e-6, 1.0e-6, 1.0)
BALL_MM, TIP_MM = 20.0, 3.0
CAP_DEG = 40.0
"""Of a sphere that a scan sees."""
CAP_POINTS = 1000
TRUE_C, TEMPERATURE_SD_C = 23.0, 0.1
POLE = np.array([0.0, 0.0, 1.0])
NINE = (0, 5, 7, 9, 11, 18, 20, 22, 24)
FOUR = (0, 17, 20, 23)
"""Places of the pattern of 25 that are touched."""


@dataclass(frozen=True)
class _Pair:
    """A figure on true artefacts and on perfect ones, and its stated uncertainty; in µm."""

    found: float
    perfect: float
    stated: float


def plane_and_contact_rows(tests: int, progress: Progress = no_progress) -> list[ClaimedRow]:
    """A row for every figure, over so many simulated tests."""
    random = np.random.default_rng(11)
    pairs: dict[str, list[_Pair]] = {}
    for test in range(tests):
        progress(test / tests, f"test {test + 1} of {tests}")
        found = {
            "plane-scan": _plane(random),
            "length-scan": _length_by_scan(random),
            "effective-diameter": _diameter(random),
            **_volume(random),
        }
        for figure, pair in found.items():
            pairs.setdefault(figure, []).append(pair)
    return [
        ClaimedRow(
            figure,
            rms([one.stated for one in of_figure])
            / rms([one.found - one.perfect for one in of_figure]),
        )
        for figure, of_figure in pairs.items()
    ]


def _plane(random: np.random.Generator) -> _Pair:
    """A plate that is bowl, saddle, bent or wavy, as far as its certificate allows."""
    flat = random.uniform(-SIDE_MM / 2, SIDE_MM / 2, (POINTS, 2))
    noise_mm = POINT_SD_MM * random.normal(size=POINTS)
    flatness_um = PLATE.flatness_um + PLATE.flatness_sd_um * float(random.normal())
    off_mm = 1e-3 * flatness_um * draw_plate_form(flat / (SIDE_MM / 2), random)
    up = np.tile(POLE, (POINTS, 1))
    frame = np.zeros(POINTS, dtype=np.int64)
    scans = [
        measure_plate_scan(ScanCloud(np.column_stack([flat, off]), frame, up, np.eye(3)), SHELL_MM)
        for off in (noise_mm + off_mm, noise_mm)
    ]
    return _Pair(
        scans[0].dispersion_um,
        scans[1].dispersion_um,
        plane_effect_um(PLATE, scans[0].points_mm, dispersion_mm),
    )


def _draw_ball(random: np.random.Generator, radius_sd_um: float = 0.0) -> TrueSphere:
    """A sphere with a form of 1 µm ± 0.2 µm, and lobes about any axis."""
    axis = random.normal(size=3)
    axis /= np.linalg.norm(axis)
    return TrueSphere(
        radius_off_mm=1e-3 * radius_sd_um * float(random.normal()),
        form_mm=1e-3 * (1.0 + 0.2 * float(random.normal())),
        lobes=int(random.integers(*LOBES)),
        axis=(axis[0], axis[1], axis[2]),
        phase_rad=float(random.uniform(0, 2 * np.pi)),
    )


def _thermometer(random: np.random.Generator) -> MeanTemperature:
    return MeanTemperature(TRUE_C + TEMPERATURE_SD_C * random.normal(), TEMPERATURE_SD_C)


def _draw_bar_mm(random: np.random.Generator) -> float:
    """The length of the bar as it truly is at the true temperature."""
    expansion = BAR.expansion_per_c + BAR.expansion_sd_per_c * random.normal()
    at_20_mm = BAR.length_mm + 1e-3 * BAR.standard_uncertainty_um * random.normal()
    return float(at_20_mm * (1 + expansion * (TRUE_C - 20.0)))


def _length_by_scan(random: np.random.Generator) -> _Pair:
    """Two spheres of a bar seen from different sides."""
    true_mm = _draw_bar_mm(random)
    moved = []
    for ball in (_draw_ball(random), _draw_ball(random)):
        direction = random.normal(size=3)
        outward = _cap(direction / np.linalg.norm(direction), random)
        noise_mm = POINT_SD_MM * random.normal(size=len(outward))
        centres = [
            sphere_centre(outward * (BALL_MM / 2 + noise_mm + off)[:, None], BALL_MM)
            for off in (ball.deviations_mm(outward), np.zeros(len(outward)))
        ]
        moved.append(centres)
    along = np.array([1.0, 0.0, 0.0])
    lengths_mm = [
        float((moved[1][which] - moved[0][which]) @ along) + base
        for which, base in ((0, true_mm), (1, BAR.length_mm))
    ]
    one = MeasuredLength(1, 1, BAR, lengths_mm[0], _thermometer(random), "scan")
    perfect = MeasuredLength(1, 1, BAR, lengths_mm[1])
    return _Pair(one.error_um, perfect.error_um, one.test_uncertainty_um)


def _cap(direction: Floats, random: np.random.Generator) -> Floats:
    """(N, 3) unit directions within the cap about a direction (3,)."""
    cosine = 1 - random.random(CAP_POINTS) * (1 - np.cos(np.radians(CAP_DEG)))
    turn, flat = random.uniform(0, 2 * np.pi, CAP_POINTS), np.sqrt(1 - cosine**2)
    across = np.eye(3)[int(np.argmin(np.abs(direction)))]
    frame = frame_about(direction, across)
    return np.column_stack([flat * np.cos(turn), flat * np.sin(turn), cosine]) @ frame.T


def _diameter(random: np.random.Generator) -> _Pair:
    """The master sphere, three times at nine places."""
    ball = _draw_ball(random, MASTER.diameter_sd_um / 2)
    outward = pattern_directions(POLE, 85.0)[list(NINE)]
    expansion = MASTER.expansion_per_c + MASTER.expansion_sd_per_c * random.normal()
    growth = 1 + expansion * (TRUE_C - 20.0)
    noise_mm = TOUCH_SD_MM * random.normal(size=(SPHERES, SPHERE_POINTS))
    perfect_mm = np.full(SPHERE_POINTS, MASTER.diameter_mm / 2)
    radii = (growth * (perfect_mm + ball.deviations_mm(outward)), perfect_mm)
    artefact = _thermometer(random)
    known = (1 + MASTER.expansion_per_c * artefact.off_c, 1.0)
    errors = [
        effective_diameter(
            [(radius + TIP_MM / 2 + noise)[:, None] * outward for noise in noise_mm],
            TIP_MM,
            MASTER.diameter_mm,
            by,
        ).mean_error_um
        for radius, by in zip(radii, known, strict=True)
    ]
    stated = size_uncertainty_um(MASTER, artefact.sd_c, artefact.off_c, DIAMETER_BY_FORM_OF_NINE)
    return _Pair(errors[0], errors[1], stated)


def _volume(random: np.random.Generator) -> dict[str, _Pair]:
    """The bar in twenty placements: the same bar and spheres in each."""
    true_mm = _draw_bar_mm(random)
    artefact, reach_mm = _thermometer(random), (BALL_MM + TIP_MM) / 2
    balls = (_draw_ball(random), _draw_ball(random))
    found, perfect = [], []
    for placement in range(PLACEMENTS):
        turned = np.linalg.qr(random.normal(size=(3, 3)))[0]
        ends: list[list[Floats]] = []
        for ball in balls:
            outward = pattern_directions(POLE, 85.0)[list(FOUR)]
            noise_mm = TOUCH_SD_MM * random.normal(size=len(outward))
            centre = partial(sphere_centre, diameter_mm=2 * reach_mm)
            ends.append(
                [
                    centre(outward * (reach_mm + noise_mm + off)[:, None])
                    for off in (ball.deviations_mm(outward @ turned), np.zeros(len(outward)))
                ]
            )
        apart = np.array([1.0, 0.0, 0.0])
        lengths = [
            length_of_bar_mm(ends[0][which], ends[1][which] + base * apart)
            for which, base in ((0, true_mm), (1, BAR.length_mm))
        ]
        found.append(MeasuredLength(placement + 1, 1, BAR, lengths[0], artefact))
        perfect.append(MeasuredLength(placement + 1, 1, BAR, lengths[1]))
    of_found, of_perfect = (
        volumetric_length([one.error_um for one in of]) for of in (found, perfect)
    )
    largest_sd_um, two_rms_sd_um = volumetric_uncertainty_um(
        np.array(of_found.deviations_um),
        np.array([one.certificate_uncertainty_um for one in found]),
        np.array([one.form_uncertainty_um for one in found]),
    )
    return {
        "volumetric-largest": _Pair(of_found.largest_um, of_perfect.largest_um, largest_sd_um),
        "volumetric-two-rms": _Pair(of_found.two_rms_um, of_perfect.two_rms_um, two_rms_sd_um),
    }
