"""What performance tests are done on: gauges of the data folder, and what speaks against one."""

from dataclasses import dataclass, replace
from pathlib import Path

from app.errors import OperationError
from app.formats.datasheets.arm import read_any_arm
from app.formats.datasheets.length_standard import LengthStandardFile
from app.formats.results.calibration import read_calibration
from app.formats.session.calibration_session import ARM
from app.guide.common.datasheet_library import AnyGauge, Gauges, read_any_gauges
from app.guide.performance.state import Test
from app.metrology.arm.kinematics import AnyArm


def read_test_gauges(data_folder: Path) -> Gauges[AnyGauge]:
    """The spheres and length standards among the data folder's gauges."""
    found = read_any_gauges(data_folder)
    known = {
        name: entry
        for name, entry in found.known.items()
        if isinstance(entry.datasheet, LengthStandardFile) or entry.datasheet.shape == "sphere"
    }
    return replace(found, known=known)


def gauges_of_test(found: Gauges[AnyGauge], test: Test) -> Gauges[AnyGauge]:
    """Those that a kind of test is done on; certificates are of spheres."""
    known = {
        name: entry
        for name, entry in found.known.items()
        if isinstance(entry.datasheet, LengthStandardFile) == (test == "lengths")
    }
    return Gauges(known, found.findings, found.refused if test == "sphere" else ())


@dataclass(frozen=True, eq=False)
class CalibratedWith:
    """What a sensor was calibrated with."""

    object_serial: str
    arm: AnyArm


def read_calibrated_with(calibration: Path) -> CalibratedWith | OperationError:
    """The object and the arm of a calibration's file, or why they cannot be read."""
    try:
        serial = read_calibration(calibration).serial_numbers.object
        return CalibratedWith(serial, read_any_arm(calibration.parent / ARM))
    except OperationError as error:
        return error
