"""A ball bar touched in seven places by the arm of the simulated station."""

from pathlib import Path

import numpy as np

from crenel.gauges.kinds import evaluate_performance
from crenel.gauges.plan.document import PLAN, PerformancePlan, length_feature
from crenel.gauges.plan.document_length_standard import LengthPart, LengthStandardFile
from crenel.gauges.plan.maths_length_places import ArmReach, propose_places
from crenel.gauges.plan.maths_lengths import PLACES
from crenel.gauges.sphere.maths_articulation import location_places
from crenel.metrology.transforms import Floats
from crenel_hardware.simulator.devices.kinematics import tip_centres
from crenel_hardware.simulator.scene.datasheets import arm_datasheet, write_document
from tests.bench.metrology.rendered_sphere import RenderedStation, with_wrong_link
from tests.bench.metrology.synthetic_sphere import POLE, PlantedFaults, TouchGroup

REACH = ArmReach(np.array([0.0, 0.0, 320.0]), 1000.0, known=True)
LENGTHS_MM = (80.0, 160.0, 240.0, 320.0, 400.0)


class BarTest:
    """Length tests in ``folder``, by touch, each length once in each place."""

    def __init__(self, station: RenderedStation, folder: Path) -> None:
        self._station, self._folder = station, folder
        self.clean_um = max(self._errors_um("clean", PlantedFaults()), key=abs)

    def largest_um(self, fault: PlantedFaults) -> tuple[float, float, float]:
        """The error of largest magnitude with a wrong link: expected, found, and without it."""
        found_um = self._errors_um("wrong", fault)
        expected_um = max(self._link_effects_um(fault), key=abs)
        return expected_um, max(found_um, key=abs), self.clean_um

    def _errors_um(self, name: str, fault: PlantedFaults) -> list[float]:
        station, folder = self._station, self._folder / name
        folder.mkdir(parents=True)
        plan = PerformancePlan(
            id="test",
            kind="lengths",
            started_at="2026-11-26T10:00:00+00:00",
            length=LengthStandardFile(
                name="Simulated ball bar",
                serial_number="TWIN-L1",
                sphere_diameter_mm=2 * station.radius_mm,
                lengths=tuple(
                    LengthPart(length_mm=length, standard_uncertainty_um=0.5)
                    for length in LENGTHS_MM
                ),
            ),
        )
        plan.write(folder / PLAN)
        write_document(folder / "arm.json", arm_datasheet(with_wrong_link(station.rig, fault)))
        station.write_touches(folder, _groups(), fault)
        return [one.error_um for one in evaluate_performance(folder).lengths]

    def _link_effects_um(self, fault: PlantedFaults) -> list[float]:
        """The errors that the link makes of the latest touches, by the simulator's kinematics."""
        station = self._station
        stated = with_wrong_link(station.rig, fault)
        ends: dict[str, Floats] = {}
        for group in _groups():
            q_rad = station.touched_rad[group.feature]
            off = tip_centres(stated, q_rad) - tip_centres(station.rig.arm, q_rad)
            # with the diameter known, the centre moves by what the touches move along their normals
            along = np.einsum("ij,ij->i", group.outward, off)
            ends[group.feature] = np.linalg.lstsq(group.outward, along, rcond=None)[0]
        errors_um = []
        for place, number, length_mm in _lengths():
            a, b = propose_places(REACH, length_mm)[place - 1]
            first, second = (ends[length_feature(place, 1, number, end)] for end in (0, 1))
            errors_um.append(1e3 * float((b - a) / length_mm @ (second - first)))
        return errors_um


def _lengths() -> list[tuple[int, int, float]]:
    """Place, number of the length, and the length, of each."""
    return [
        (place, number, length_mm)
        for place in range(1, PLACES + 1)
        for number, length_mm in enumerate(LENGTHS_MM, 1)
    ]


def _groups() -> list[TouchGroup]:
    groups = []
    for place, number, length_mm in _lengths():
        for end, centre in enumerate(propose_places(REACH, length_mm)[place - 1]):
            outward = location_places(POLE, POLE, -centre)
            feature = length_feature(place, 1, number, end)
            groups.append(TouchGroup(feature, centre, outward, None))
    return groups
