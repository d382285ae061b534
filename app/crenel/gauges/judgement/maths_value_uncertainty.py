"""Test value uncertainty: of the artefact and the set-up, not of the instrument that is tested.

ISO 14253-5 keeps the two apart: what the arm or scanner scatters is what the test measures.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.metrology.transforms import Floats

DIAMETER_BY_FORM = 2 * 0.33 / (2 * np.sqrt(2.0))
"""What a lobed form of 1 µm makes of a diameter: its deviations have the standard deviation
``F / (2 sqrt(2))``, and the radius through 25 places 0.33 of that of a point."""
DIAMETER_BY_FORM_OF_NINE = 0.39
"""The same through nine places: the pole, four at 45° and four at the rim. Simulated."""
CENTRES_BY_FORM = {"touch": 0.7, "scan": 0.48, "both": 0.35}
"""What a form of 1 µm makes of the distance of centres by five touches, or by the patches that a
scan shows. Measured on simulated spheres with 5 to 8 lobes, by the benchmark
``performance``."""
CENTRES_BY_DRIFT = {"touch": 0.13, "scan": 0.13, "both": 0.5}
"""What a drift of 1 µm over the whole test makes of it: five articulations take up to two fifths of
the time, ``0.4 * 1.12 / sqrt(12)``; from touches to scans the sphere moves by most of it."""
FORM_BY_DRIFT = 0.25
"""The same of the form of touches and scans together."""
LOBES = (5, 9)
"""The lobes of the form of a ground sphere, around any axis: from the first to before the
second."""
WAVES = (0.5, 1.5)
"""The waves of the form of a plate, in periods over its width."""
DRAWS, DRAWS_OF_FEW = 100, 300
FEW_POINTS = 1000
MOST_POINTS = 50_000
"""The most points of a scan; what a form changes in the dispersion of more points is smaller
still."""


@dataclass(frozen=True)
class SphereCertificate:
    """A sphere by its certificate; standard uncertainties, k = 1."""

    diameter_mm: float
    diameter_sd_um: float
    form_um: float
    form_sd_um: float = 0.0
    expansion_per_c: float = 0.0
    expansion_sd_per_c: float = 0.0


@dataclass(frozen=True)
class PlateCertificate:
    """A plate by its certificate; standard uncertainty, k = 1."""

    flatness_um: float
    flatness_sd_um: float = 0.0


def form_uncertainty_um(sphere: SphereCertificate) -> float:
    """The uncertainty of form and dispersion, k = 1: ``u² = (F/2)² + u_F²``.

    Source:
        ISO/TS 23165.
    """
    return float(np.hypot(sphere.form_um / 2, sphere.form_sd_um))


def size_uncertainty_um(
    sphere: SphereCertificate,
    temperature_sd_c: float = 0.0,
    off_c: float = 0.0,
    diameter_by_form: float = DIAMETER_BY_FORM,
) -> float:
    """The uncertainty of size, k = 1: the diameter's, the form's over 25 places, the temperature's,
    and that of the coefficient of expansion.

    Args:
        off_c: temperature of the sphere minus 20 °C.
        diameter_by_form: what a form of 1 µm makes of the diameter, by the places.
    """
    by_form = diameter_by_form * sphere.form_um
    by_heat = 1e3 * sphere.diameter_mm * sphere.expansion_per_c * temperature_sd_c
    by_coefficient = 1e3 * sphere.diameter_mm * sphere.expansion_sd_per_c * off_c
    squares = sphere.diameter_sd_um**2 + by_form**2 + by_heat**2 + by_coefficient**2
    return float(np.sqrt(squares))


def centre_uncertainty_um(sphere: SphereCertificate) -> float:
    """The uncertainty of the centre of a sphere through many points, k = 1: what its form makes of
    it."""
    return 0.35 * sphere.form_um / 2


def location_uncertainty_um(
    sphere: SphereCertificate, moved_um: float, of: Literal["touch", "scan", "both"]
) -> float:
    """The uncertainty of a location error, k = 1: the sphere has to stand still, and its form moves
    the centres.

    Args:
        moved_um: distance between its centres by touch at the beginning and at the end.
        of: five articulations by touch or by scan, or touches against scans.
    """
    by_form = CENTRES_BY_FORM[of] * sphere.form_um
    return float(np.hypot(CENTRES_BY_DRIFT[of] * moved_um, by_form))


def form_of_both_uncertainty_um(sphere: SphereCertificate, moved_um: float) -> float:
    """The uncertainty of the form of touches and scans together, k = 1: the sphere moves between
    them."""
    return float(np.hypot(form_uncertainty_um(sphere), FORM_BY_DRIFT * moved_um))


def plane_uncertainty_um(flatness_um: float, flatness_sd_um: float) -> float:
    """The uncertainty of the form of a plane, k = 1."""
    return float(np.hypot(flatness_um / 2, flatness_sd_um))


def deviations_of_lobes(outward: Floats, axis: Floats, lobes: int, phase_rad: float) -> Floats:
    """Deviations (N,) of a lobed sphere with a form of 1 in unit directions (N, 3) from its centre.

    Example:
        >>> around = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
        >>> deviations_of_lobes(around, np.array([0.0, 0.0, 1.0]), 6, np.pi / 2).round(3).tolist()
        [-0.5, 0.5]
    """
    across = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    across /= np.linalg.norm(across)
    turn = np.arctan2(outward @ np.cross(axis, across), outward @ across)
    return np.asarray(0.5 * np.sin(lobes * turn + phase_rad))


@dataclass(frozen=True)
class SphereDrift:
    """A sphere that moves during the test."""

    moved_mm: Floats
    """(3,) from the beginning of the test to its end."""
    when: Floats
    """(N,) time of each point, of a test that takes 1."""


def form_effect_um(
    sphere: SphereCertificate,
    points_mm: Floats,
    centre_mm: Floats,
    figure: Callable[[Floats], float],
    drift: SphereDrift | None = None,
) -> float:
    """Test value uncertainty of a figure of form, k = 1: what a sphere that its certificate
    allows, and that drifts, changes in it.

    Lobed forms with the certificate's size, from 5 to 8 lobes about any axis, are added to the
    points, and the drift is taken off them; what a least-squares sphere takes of these is left
    out. Where the figure is hardly larger than the certified form, it may be that form: then the
    share that it has in the square of the figure counts, too.

    Args:
        points_mm: (N, 3) on the sphere, N > 4.
        centre_mm: (3,) of their least-squares sphere.
        figure: of the points' deviations from that sphere, (N,) in mm; returns mm.

    Source:
        JCGM 101, propagation by drawing. The half form of ISO/TS 23165 is its bound for few
        points.
    """
    step = -(-len(points_mm) // MOST_POINTS)
    away = points_mm[::step] - centre_mm
    distance = np.linalg.norm(away, axis=1)
    outward, off_mm = away / distance[:, None], distance - distance.mean()
    drift_mm = None if drift is None else -drift.when[::step] * (outward @ drift.moved_mm)
    fitted = np.column_stack([outward, np.ones(len(outward))])
    forms_mm = _draw_forms_mm(sphere, outward)
    return _effect_um(off_mm, fitted, sphere.form_um, forms_mm, figure, drift_mm)


def plane_effect_um(
    plate: PlateCertificate, points_mm: Floats, figure: Callable[[Floats], float]
) -> float:
    """Test value uncertainty of a figure of the form of a plane, k = 1: what a plate that its
    certificate allows changes in it.

    Bowls, saddles, bends and waves with the certificate's flatness are added to the points, as of
    ``form_effect_um``.

    Args:
        points_mm: (N, 3) on the plate, N > 3.
        figure: of the points' distances from their plane, (N,) in mm; returns mm.
    """
    step = -(-len(points_mm) // MOST_POINTS)
    away = points_mm[::step] - points_mm.mean(axis=0)
    _, _, axes = np.linalg.svd(away, full_matrices=False)
    flat, off_mm = away @ axes[:2].T, away @ axes[2]
    at = 2 * (flat - flat.min(axis=0)) / np.ptp(flat, axis=0) - 1
    fitted = np.column_stack([at, np.ones(len(at))])
    random = np.random.default_rng(0)
    forms_mm = (
        1e-3
        * (plate.flatness_um + plate.flatness_sd_um * random.normal())
        * draw_plate_form(at, random)
        for _ in range(DRAWS)
    )
    return _effect_um(off_mm, fitted, plate.flatness_um, forms_mm, figure)


def draw_plate_form(at: Floats, random: np.random.Generator) -> Floats:
    """Deviations (N,) of a plate with a flatness of 1 at places (N, 2) from -1 to 1: a bowl, a
    saddle or a bend, or waves, in any direction."""
    turn = random.uniform(0, np.pi)
    u = np.cos(turn) * at[:, 0] + np.sin(turn) * at[:, 1]
    v = np.cos(turn) * at[:, 1] - np.sin(turn) * at[:, 0]
    if random.random() < 0.5:
        off = u**2 + random.uniform(-1, 1) * v**2
    else:
        off = np.sin(np.pi * random.uniform(*WAVES) * u + random.uniform(0, 2 * np.pi))
    system = np.column_stack([at, np.ones(len(at))])
    off = off - system @ np.linalg.lstsq(system, off, rcond=None)[0]
    return np.asarray(off / np.ptp(off))


def _effect_um(
    off_mm: Floats,
    system: Floats,
    certified_um: float,
    forms_mm: Iterable[Floats],
    figure: Callable[[Floats], float],
    drift_mm: Floats | None = None,
) -> float:
    """What forms (N,) and a drift (N,) change in a figure of deviations (N,), k = 1; what the
    columns of the system (N, m) take of them in a fit is left out."""
    fitted, _ = np.linalg.qr(system)

    def changed_um(added_mm: Floats) -> float:
        return 1e3 * figure(off_mm + added_mm - fitted @ (fitted.T @ added_mm)) - found_um

    found_um = 1e3 * figure(off_mm)
    by_form = [changed_um(form_mm) for form_mm in forms_mm]
    # the nearer the figure is to the certified form, the less of it do further forms change
    share = found_um - np.sqrt(max(found_um**2 - certified_um**2, 0.0))
    share *= min(certified_um / max(found_um, 1e-9), 1.0)
    by_drift = 0.0 if drift_mm is None else changed_um(drift_mm)
    return float(np.sqrt(np.mean(np.square(by_form)) + share**2 + by_drift**2))


def _draw_forms_mm(sphere: SphereCertificate, outward: Floats) -> Iterator[Floats]:
    """Deviations (N,) of spheres that the certificate allows."""
    random = np.random.default_rng(0)
    for _ in range(DRAWS_OF_FEW if len(outward) <= FEW_POINTS else DRAWS):
        axis = random.normal(size=3)
        axis /= np.linalg.norm(axis)
        lobes, phase_rad = int(random.integers(*LOBES)), random.uniform(0, 2 * np.pi)
        form_um = sphere.form_um + sphere.form_sd_um * random.normal()
        yield 1e-3 * form_um * deviations_of_lobes(outward, axis, lobes, phase_rad)
