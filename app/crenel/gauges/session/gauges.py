"""What performance tests are done on: gauges of the data folder, and what speaks against one."""

from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.io_errors import convert_all_errors
from crenel.formats.results.calibration import read_calibration
from crenel.formats.session.calibration_session import ARM
from crenel.gauges.guide_plan import plate_part, sphere_part
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.evaluate_artefacts import list_problems
from crenel.gauges.session.state import ArtefactShape
from crenel.guide.common.datasheet_library import AnyGauge, Gauges
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm

BAR = "bar.json"
"""The file in a test's folder with the bar of a contact test, which has a sphere, too."""


@dataclass(frozen=True, eq=False)
class CalibratedWith:
    """What a sensor was calibrated with; of one that is not, the arm alone."""

    object_serial: str
    arm: AnyArm | None
    """None if it is not known."""


def _shape_of(gauge: AnyGauge) -> ArtefactShape:
    return "length" if isinstance(gauge, LengthStandardFile) else gauge.shape


def gauges_of_shape(found: Gauges[AnyGauge], shape: ArtefactShape) -> Gauges[AnyGauge]:
    """Those of a shape; certificates are of spheres."""
    known = {
        name: entry for name, entry in found.known.items() if _shape_of(entry.datasheet) == shape
    }
    return Gauges(known, found.findings, found.refused if shape == "sphere" else ())


def bars_of(found: Gauges[AnyGauge]) -> Gauges[AnyGauge]:
    """The ball bars among the data folder's gauges."""
    known = {
        name: entry
        for name, entry in found.known.items()
        if isinstance(entry.datasheet, LengthStandardFile) and entry.datasheet.kind == "ball-bar"
    }
    return Gauges(known, ())


def problems_in_test(
    name: str, gauge: AnyGauge, as_bar: bool, day: str, calibrated: CalibratedWith
) -> list[Text]:
    """Why a gauge cannot serve in a kind of test; empty if it can.

    Args:
        name: of its file.
        as_bar: whether a length standard is the bar of a contact test.
        day: of the test, ISO 8601.
        calibrated: what the sensor was calibrated with.
    """
    if isinstance(gauge, LengthStandardFile):
        # the reach is not checked in a contact test: a bar across the arm's column may be longer
        arm = None if as_bar else calibrated.arm
        problems = list_problems(gauge, day, calibrated.object_serial, arm)
        if as_bar and gauge.sphere_diameter_mm is None:
            problems.append(message("bar-without-sphere-diameter"))
        return problems
    part = sphere_part(name, gauge) if gauge.shape == "sphere" else plate_part(name, gauge)
    return list_problems(part, day, calibrated.object_serial)


def read_calibrated_with(calibration: Path) -> CalibratedWith | OperationError:
    """The object and the arm of a calibration's file, or why they cannot be read."""
    try:
        with convert_all_errors(calibration):
            serial = read_calibration(calibration).serial_numbers.object
            return CalibratedWith(serial, read_any_arm(calibration.parent / ARM))
    except OperationError as error:
        return error
