"""Results of performance tests from made-up measurements, by the program's own computations."""

from collections.abc import Callable
from itertools import product
from pathlib import Path
from typing import Any, Literal

import numpy as np

from crenel.formats.json_document import SOFTWARE, Vector3, file_sha256
from crenel.formats.results.calibration import Input, SerialNumbers
from crenel.formats.results.decision_rule import RulePart
from crenel.gauges.contact.maths import volumetric_length
from crenel.gauges.judgement.document import (
    ImpliedOffsetPart,
    LengthPoint,
    PatchPart,
    PerformanceFigure,
    PerformanceFile,
    PerformanceVerdict,
    SphereMeasurement,
    TemperaturesPart,
)
from crenel.gauges.plan.document import (
    RESULT,
    GatePart,
    Kind,
    LimitPart,
    PlatePart,
    SpherePart,
    TemperatureLimitsPart,
    length_feature,
    sphere_feature,
    sphere_features,
    sphere_scan,
)
from crenel.gauges.plan.document_length_standard import LengthPart, LengthStandardFile
from crenel.gauges.plan.document_symbols import TITLES, Quantity, editions, symbol_of
from crenel.gauges.plan.maths_lengths import CalibratedLength, MeasuredLength
from crenel.gauges.sphere.maths_location import estimate_offset, location_error_mm
from crenel.gauges.sphere.maths_pattern import pattern_directions
from crenel.messages.message import message, rounded
from crenel.metrology.decision import decide
from crenel.metrology.fitting.reference_sphere import SphereOfPoints, least_squares_sphere
from crenel.metrology.probing.seat_articulation import seat_articulation
from crenel.metrology.transforms import Floats

SPHERE = SpherePart(
    name="Ceramic sphere 25",
    serial_number="K-1207",
    certificate="DKD-K-00001 2026-03",
    valid_until="2027-03-31",
    diameter_mm=25.0012,
    diameter_sd_um=0.3,
    form_um=0.8,
    form_sd_um=0.1,
    expansion_per_c=5.5e-6,
)
BAR = LengthStandardFile(
    name="Ball bar 1500",
    serial_number="B-77",
    certificate="DKD-K-00002 2026-04",
    valid_until="2027-04-30",
    sphere_diameter_mm=20.0,
    expansion_per_c=0.5e-6,
    lengths=tuple(
        LengthPart(length_mm=length, standard_uncertainty_um=0.4 + length / 2000)
        for length in (300.012, 600.018, 900.021, 1200.034, 1500.041)
    ),
)
TEMPERATURES = TemperaturesPart(
    artefact_c=(20.2, 20.7),
    artefact_sd_c=0.1,
    arm_c=(21.3, 21.9),
    limits=TemperatureLimitsPart(),
    steady=True,
)
STATUS = "No conformity with these standards is claimed."


def figure(
    quantity: Quantity,
    values_um: list[float],
    uncertainty_um: float,
    limit_um: float | None,
    data: tuple[str, ...],
    edition: str = "2016",
) -> PerformanceFigure:
    """A figure with the worse of its values."""
    symbol = symbol_of(edition, quantity)
    value = max(values_um, key=abs)
    found = decide(value, limit_um, uncertainty_um / 2, signed=symbol.signed)
    return PerformanceFigure(
        quantity=quantity,
        symbol=symbol.symbol,
        title=TITLES[quantity],
        value=value,
        values=tuple(values_um),
        test_uncertainty=uncertainty_um,
        limit=limit_um,
        decision=found,
        reason=message("titled-text", title=TITLES[quantity], text=rounded(value, "µm", 3)),
        data=data,
    )


def vector(values: Floats) -> Vector3:
    x, y, z = (float(value) for value in values)
    return x, y, z


def sphere_measurement(
    position: int, rng: np.random.Generator, offset_mm: Floats
) -> tuple[SphereMeasurement, Floats]:
    """One position: touches with 8 µm of noise, scans with 4 µm in their patches."""
    centre = np.array([420.0 * position, 80.0, 210.0])
    directions = pattern_directions(np.array([0.0, 0.0, 1.0]))
    reach = SPHERE.diameter_mm / 2
    touches = centre + directions * (reach + rng.normal(0, 0.008, (25, 1)))
    scanned = centre + directions * (reach + rng.normal(0, 0.004, (25, 1)))
    orientations = rotations()
    scans = centre - np.einsum("nij,j->ni", orientations, offset_mm)
    scans = scans + rng.normal(0, 0.003, (5, 3))
    located = centre + rng.normal(0, 0.009, (5, 3))

    def off_um(points: Floats) -> list[float]:
        found = least_squares_sphere(points)
        away = np.linalg.norm(points - found.centre_mm, axis=1) - found.diameter_mm / 2
        return [*(1e3 * away).tolist()]

    def patch(off: float) -> PatchPart:
        points, frames = (int(rng.integers(*between)) for between in ((120, 900), (4, 30)))
        return PatchPart(points=points, frames=frames, deviation_um=off)

    patches = tuple(patch(off) for off in off_um(scanned))
    measured = SphereMeasurement(
        position=position,
        touched_centre_mm=vector(least_squares_sphere(touches).centre_mm),
        end_centre_mm=vector(centre + 0.001),
        moved_um=1.7,
        touch_deviations_um=tuple(off_um(touches)),
        tactile_centres_mm=tuple(vector(row) for row in located),
        scan_centres_mm=tuple(vector(row) for row in scans),
        fixed_centres_mm=tuple(vector(row) for row in scans + rng.normal(0, 0.001, (5, 3))),
        location_fixed_um=1e3 * location_error_mm(scans),
        scanned_centre_mm=vector(scans.mean(axis=0)),
        points=sum(patch.points for patch in patches) * 6,
        points_outside=3120,
        patches=patches,
        free_dispersion_um=29.8,
    )
    return measured, np.concatenate([touches, scanned])


def rotations() -> Floats:
    """(5, 3, 3) orientations of the sensor: looking down, and along ±x and ±y."""
    down = np.diag([1.0, -1.0, -1.0])
    along_x = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
    along_y = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
    turned = np.diag([-1.0, -1.0, 1.0])
    return np.array([down, along_x, turned @ along_x, along_y, turned @ along_y])


def sphere_result(folder: Path, seed: int = 5) -> PerformanceFile:
    """The one-sphere test at two positions, with the probe matrix 50 µm off."""
    rng = np.random.default_rng(seed)
    offset = np.array([0.05, 0.0, 0.0])
    spheres, points = zip(*(sphere_measurement(n, rng, offset) for n in (1, 2)), strict=True)
    features = tuple(sphere_features(2))
    scans = tuple(sphere_scan(p, a) for p in (1, 2) for a in range(1, 6))
    pattern = tuple(sphere_feature(p, "pattern") for p in (1, 2))
    located = tuple(sphere_feature(p, "location", n) for p in (1, 2) for n in range(1, 6))
    touched, scanned, both = (
        [least_squares_sphere(one[part]) for one in points]
        for part in (slice(25), slice(25, None), slice(None))
    )

    def sizes(found: list[SphereOfPoints]) -> list[float]:
        return [1e3 * (one.diameter_mm - SPHERE.diameter_mm) for one in found]

    def forms(found: list[SphereOfPoints]) -> list[float]:
        return [1e3 * one.form_mm for one in found]

    def location(name: str) -> list[float]:
        return [1e3 * location_error_mm(np.array(getattr(one, name))) for one in spheres]

    apart = [
        1e3 * float(np.linalg.norm(a.centre_mm - b.centre_mm))
        for a, b in zip(touched, scanned, strict=True)
    ]
    figures = (
        figure("size-touch", sizes(touched), 0.7, 25.0, pattern),
        figure("form-touch", forms(touched), 0.8, 45.0, pattern),
        figure("location-touch", location("tactile_centres_mm"), 1.1, 60.0, located),
        figure("size-scan", sizes(scanned), 0.7, 40.0, scans),
        figure("form-scan", forms(scanned), 0.8, 30.0, scans),
        figure("dispersion-scan", [30.4, 31.9], 0.8, 32.0, scans),
        figure("location-scan", location("scan_centres_mm"), 1.1, 80.0, scans),
        figure("form-both", forms(both), 0.8, None, (*pattern, *scans)),
        figure("location-both", apart, 0.9, 60.0, (*pattern, *scans)),
        PerformanceFigure(
            quantity="size-all-scan",
            symbol=symbol_of("2016", "size-all-scan").symbol,
            title=TITLES["size-all-scan"],
            value=None,
            decision="uncertain",
            reason="Patch 17 has no points.",
            problem="Patch 17 has no points.",
        ),
    )
    implied = estimate_offset(np.array(spheres[0].scan_centres_mm), rotations())
    return written(
        folder,
        "sphere",
        figures,
        (*features, *scans),
        sphere=SPHERE,
        spheres=spheres,
        offset=ImpliedOffsetPart(
            offset_mm=vector(implied.offset_mm),
            standard_uncertainty_mm=vector(np.sqrt(np.diag(implied.covariance))),
            significant=implied.is_significant,
            left_um=1e3 * implied.left_mm,
            text="The probe matrix is off.",
        ),
        problems=("Patch 17 has no points.",),
        notes=("Points seen once are kept.",),
    )


def lengths_result(folder: Path, seed: int = 5) -> PerformanceFile:
    """105 lengths of a ball bar by touch, one place with an outlier beyond its limit."""
    rng = np.random.default_rng(seed)
    limit = LimitPart(quantity="length-touch", a_um=20.0, k=40.0, b_um=50.0)
    points = []
    for place, part, repeat in product(range(1, 8), BAR.lengths, range(1, 4)):
        off_mm = rng.normal(0.002, 0.008) + (0.07 if (place, repeat) == (4, 2) else 0)
        known = CalibratedLength(part.length_mm, part.standard_uncertainty_um, 0.5e-6)
        one = MeasuredLength(place, repeat, known, part.length_mm + off_mm)
        points.append(
            LengthPoint(
                place=place,
                repeat=repeat,
                length_mm=part.length_mm,
                measured_mm=one.measured_mm,
                error_um=one.error_um,
                test_uncertainty_um=2 * one.test_uncertainty_um,
                limit_um=limit.error.at(part.length_mm),
            )
        )
    ends = product(range(1, 8), range(1, 4), range(1, 6), (0, 1))
    data = tuple(length_feature(*end) for end in ends)
    errors = [point.error_um for point in points]
    found = figure("length-touch", errors, 2.3, 45.0, data)
    fields: dict[str, Any] = {"length": BAR, "temperatures": TEMPERATURES, "notes": ("All kept.",)}
    return written(folder, "lengths", (found,), data, lengths=tuple(points), **fields)


def contact_result(folder: Path, seed: int = 5) -> PerformanceFile:
    """The contact test: three seats of ten points, and twenty placements of a ball bar."""
    rng = np.random.default_rng(seed)
    seats = [seat_articulation(rng.normal(0, 0.01 * (i + 1), (10, 3))) for i in range(3)]
    volume = volumetric_length(list(rng.normal(3.0, 18.0, 20)))
    edition, data = "B89.4.22", ("seat-1", "seat-2", "seat-3")
    bar = tuple(f"bar-{i}" for i in range(1, 21))
    largest = [seat.largest_um for seat in seats]
    two_s = [seat.two_s_um for seat in seats]
    figures = (
        # the mean of three
        figure("effective-diameter", [1.8], 0.8, 30.0, ("sphere",), edition).model_copy(
            update={"values": (3.1, -2.0, 4.3)}
        ),
        figure("articulation-largest", largest, 0.0, 90.0, data, edition),
        figure("articulation-two-s", two_s, 0.0, 90.0, data, edition),
        figure("volumetric-largest", list(volume.deviations_um), 1.6, 60.0, bar, edition),
        figure("volumetric-two-rms", [volume.two_rms_um], 1.6, None, bar, edition),
    )
    return written(
        folder, "contact", figures, (*data, *bar), edition=edition, sphere=SPHERE, length=BAR
    )


def plane_result(folder: Path) -> PerformanceFile:
    """The scanned plane in two orientations."""
    found = figure("plane-scan", [38.0, 41.5], 1.2, 60.0, ("plane-1", "plane-2"))
    plate = PlatePart(name="Granite plate", serial_number="G-3", flatness_um=1.0)
    return written(folder, "plane", (found,), ("plane-1", "plane-2"), plate=plate)


def written(
    folder: Path,
    kind: Kind,
    figures: tuple[PerformanceFigure, ...],
    groups: tuple[str, ...],
    edition: str = "2016",
    **fields: object,
) -> PerformanceFile:
    """Writes ``performance.json`` and a file for each scan and for the touches."""
    folder.mkdir(parents=True, exist_ok=True)
    inputs = []
    for name in ["touches.csv", *[f"{one}/scan.mcap" for one in groups if "-a" in one]]:
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(name.encode())
        inputs.append(Input(file=name, sha256=file_sha256(path)))
    worst = {one.decision for one in figures}
    result: Literal["pass", "fail", "uncertain"] = "pass"
    if worst & {"fail", "uncertain"}:
        result = "fail" if "fail" in worst else "uncertain"
    document = PerformanceFile.model_validate(
        {
            "id": "20261124-101500-ab12",
            "kind": kind,
            "station": "Room 2",
            "operator": "Anna",
            "started_at": "2026-11-24T10:15:00+00:00",
            "ended_at": "2026-11-24T10:52:00+00:00",
            "edition": edition,
            "standards": editions()[edition].standards,
            "status": STATUS,
            "serial_numbers": SerialNumbers(arm="A-1", sensor="S-1", object=""),
            "gate": GatePart(),
            "rule": RulePart(),
            "figures": figures,
            "verdict": PerformanceVerdict(result=result, text="See the figures."),
            "temperature_c": (20.4, 20.9),
            "inputs": tuple(inputs),
            "software": SOFTWARE,
            **fields,
        }
    )
    document.write(folder / RESULT)
    return document


Build = Callable[[Path], PerformanceFile]
BUILDERS: tuple[Build, ...] = (sphere_result, lengths_result, contact_result, plane_result)
