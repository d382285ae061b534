"""Inspections of one part with many true stations, each as its files state it might be."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from crenel.parts.document_results import DimensionResult, InspectionFile
from crenel.parts.evaluate import inspect_part, measure_part
from crenel.parts.evaluate_folder import find_files
from crenel.parts.maths.shapes import Shape
from tests.parts.bracket_program import (
    bore_touches,
    bracket_dimensions,
    datum_touches,
    write_program,
)
from tests.parts.simulated_inspection import (
    Floats,
    Planned,
    Sensor,
    Station,
    draw_station,
    draw_truth,
    plan_passes,
    scan_part,
    seven_axis_arm,
    touch_rows,
    usual_passes,
    write_station,
    write_touches,
)
from tests.parts.simulated_solid import Bore, Bracket


@dataclass(frozen=True)
class Setting:
    """A part as drawn and as made, on a station."""

    nominal: Bracket
    true: Bracket
    station: Station
    planned: list[Planned]


@dataclass(frozen=True)
class Found:
    """One dimension of one draw."""

    result: DimensionResult
    true: float

    @property
    def pull(self) -> float:
        """Its error over its standard uncertainty."""
        assert self.result.standard_uncertainty is not None
        return (self.result.value - self.true) / self.result.standard_uncertainty

    @property
    def off_limits(self) -> float:
        """How far the true value is within the nearest limit, negative outside, in u."""
        one = self.result
        off = self.true - one.nominal
        room = [
            sign * (limit - off)
            for limit, sign in ((one.lower, -1), (one.upper, 1))
            if limit is not None
        ]
        assert one.standard_uncertainty is not None
        return min(room) / one.standard_uncertainty

    @property
    def is_needlessly_open(self) -> bool:
        """Whether nothing was decided though the measured value is 2.5 u from its limits."""
        one = self.result
        assert one.standard_uncertainty is not None
        off = one.value - one.nominal
        limits = [limit for limit in (one.lower, one.upper) if limit is not None]
        nearest = min(abs(off - limit) for limit in limits) / one.standard_uncertainty
        return one.decision == "undecided" and nearest > 2.5

    @property
    def is_wrong(self) -> bool:
        """Whether its decision contradicts the true value."""
        decided = self.result.decision in ("pass", "fail")
        return decided and (self.result.decision == "pass") != (self.off_limits >= 0)


@cache
def first_setting() -> Setting:
    """A bracket with faults on a seven-axis arm."""
    nominal = Bracket()
    bores = (
        replace(nominal.bores[0], diameter_mm=12.055),
        replace(nominal.bores[1], diameter_mm=11.988, x_mm=105.17),
        replace(nominal.bores[2], diameter_mm=16.03),
    )
    x, y, diameter, height = nominal.boss
    true = replace(
        nominal,
        bores=bores,
        boss=(x, y, diameter - 0.03, height),
        step=(*nominal.step[:4], nominal.step[4] + 0.06),
    )
    station = draw_station(1)
    return Setting(nominal, true, station, plan_passes(station, usual_passes(nominal), 1))


@cache
def other_setting() -> Setting:
    """Another part, arm and sensor."""
    nominal = Bracket(
        (150.0, 70.0),
        26.0,
        (Bore(18, 20, 10, 16), Bore(132, 52, 14, 12), Bore(130, 16, 9, 14)),
        (75.0, 48.0, 30.0, 12.0),
        (112.0, 48.0, 36.0, 16.0),
        (50.0, 4.0, 95.0, 13.0, 3.0),
        (75.0, 24.0, 12.0, 36.0, 9.0),
        (24.0, 50.0, 40.0, 7.0),
    )
    bores = (
        replace(nominal.bores[0], diameter_mm=9.97, y_mm=20.06),
        replace(nominal.bores[1], diameter_mm=14.02, x_mm=132.03),
        replace(nominal.bores[2], diameter_mm=9.045),
    )
    true = replace(
        nominal,
        bores=bores,
        ball=(112.0, 48.0, 36.02, 16.01),
        step=(*nominal.step[:4], nominal.step[4] - 0.02),
    )
    sensor = Sensor(
        f_px=(1350.0, 1352.0), lens=(0.06, -0.03, -2e-4, 1e-4), normal=(-0.03, 0.78, 0.62)
    )
    station = draw_station(77, arm=seven_axis_arm(8e-6, 1.1), sensor=sensor)
    return Setting(nominal, true, station, plan_passes(station, usual_passes(nominal), 9))


def inspect_draw(
    setting: Setting, seed: int, by: str = "scan", touch: tuple[str, ...] = ()
) -> tuple[InspectionFile, list[Found]]:
    """Scans and touches the part with a station drawn by a seed, and inspects it."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        write_draw(folder, setting, seed, by, touch)
        result = inspect_part(find_files(folder))
    true = {one["id"]: value for one, value in bracket_dimensions(setting.nominal, setting.true)}
    return result, [Found(one, true[one.id]) for one in result.dimensions]


def difference_of_means(setting: Setting, seed: int) -> float:
    """The diameter of a bore by stripe less that by tip, over its standard uncertainty."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        write_draw(folder, setting, seed, both=("H1",))
        found = measure_part(find_files(folder))
    pair = [found.wanted.index(("H1", "scan")), found.wanted.index(("H1", "touch"))]

    def difference(shapes: Sequence[Shape]) -> Floats:
        first, second = (shapes[k].sizes[0] for k in pair)
        return np.array([first - second])

    row = found.knowledge.gradients(difference)[0]
    off = float(difference(found.knowledge.shapes)[0])
    return off / float(np.sqrt(row @ found.knowledge.total @ row))


def write_draw(
    folder: Path,
    setting: Setting,
    seed: int,
    by: str = "scan",
    touch: tuple[str, ...] = (),
    both: tuple[str, ...] = (),
) -> None:
    """The inspection folder of a draw."""
    station, truth = setting.station, draw_truth(setting.station, seed)
    write_station(folder, station)
    (folder / "scans").mkdir()
    scan_part(folder / "scans" / "scan.mcap", setting.true, truth, setting.planned, seed)
    touched = datum_touches(setting.true)
    if both:
        touched |= {"H1": bore_touches(setting.true)}
    write_touches(folder, station, touch_rows(station, truth, touched, seed))
    write_program(folder / "program.json", setting.nominal, setting.true, by, touch, both)


def ratios(draws: list[list[Found]]) -> Iterator[tuple[str, float, float, float]]:
    """Of each dimension: claimed over observed, bias in u, and the rms of its errors."""
    for column in zip(*draws, strict=True):
        name = column[0].result.id
        if name.startswith("pos-"):
            continue  # a length near zero: judged by its vector, which the coordinates show
        errors = np.array([one.result.value - one.true for one in column])
        claimed = np.array([one.result.standard_uncertainty or 0.0 for one in column])
        pulls: Floats = errors / claimed
        yield (
            name,
            float(np.sqrt(np.mean(claimed**2) / np.mean(errors**2))),
            float(np.mean(pulls)),
            float(np.sqrt(np.mean(errors**2))),
        )
