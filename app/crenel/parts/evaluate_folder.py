"""The files of an inspection folder, read and checked before anything is measured."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import ArmFile, read_any_arm
from crenel.formats.file_names import display_path
from crenel.formats.json_document import file_sha256
from crenel.formats.recording.reader import SCAN_STARTED, Recording
from crenel.formats.results.calibration import (
    CALIBRATION,
    Calibration,
    CalibrationFile,
    Input,
    calibration_from_document,
)
from crenel.formats.session.calibration_session import ContactReadings, read_contacts
from crenel.messages.message import Text, message
from crenel.metrology.adjustment.core.arm_errors import LEAST_ENCODER_RAD
from crenel.metrology.arm.kinematics import AnyArm, RobotArm, tip_of
from crenel.metrology.transforms import Floats
from crenel.parts.document_program import PROGRAM, ProgramFile
from crenel.parts.maths.point_errors import TIP_NAMES
from crenel.parts.maths.shared_covariance import (
    ArmCovariance,
    add_arm,
    arm_by_identification,
    arm_by_scales,
    has_links,
    place_by_name,
    reading_sds,
    tip_covariance,
    with_links,
)
from crenel.timestamps import is_moment
from crenel.workflows.compatibility import check_serials

ARM, TOUCHES, SCANS = "arm.json", "touches.csv", "scans"


@dataclass(frozen=True)
class FolderFiles:
    """Which files are taken."""

    program: Path
    calibration: Path
    arm: Path
    scans: tuple[Path, ...]
    touches: Path | None
    tip_um: float = 0.0
    """Standard uncertainty of the tip's diameter; 0: it is not stated."""

    @property
    def all_files(self) -> tuple[Path, ...]:
        touches = () if self.touches is None else (self.touches,)
        return (self.program, self.calibration, self.arm, *self.scans, *touches)

    def inputs(self) -> tuple[Input, ...]:
        """The files with their hashes, by their places in the folder if they are in it."""
        return tuple(
            Input(file=self.name_of(path), sha256=file_sha256(path)) for path in self.all_files
        )

    def start_moment(self) -> str:
        """When the first recording began, as it says; empty if none does."""
        if not self.scans:
            return ""
        path = self.scans[0]
        began = Recording(path, path.stat().st_size).station_metadata().get(SCAN_STARTED, "")
        return began if is_moment(began) else ""

    def name_of(self, path: Path) -> str:
        """A file's name, within the program's folder if it is there: wherever that folder lies,
        the results are the same."""
        folder, place = self.program.parent.resolve(), path.resolve()
        within = place.is_relative_to(folder)
        return place.relative_to(folder).as_posix() if within else display_path(place)


@dataclass(frozen=True)
class StationKnowledge:
    """Arm and sensor, and how well they are known.

    ``shared`` (P, P) is the covariance of the shared errors and ``reading_sd`` the noise of each
    number of a reading; None where one of them is unknown: then there is only scatter.
    """

    arm: AnyArm
    calibration: Calibration
    pivot_mm: Floats
    shared: Floats | None
    reading_sd: Floats
    touch_sd_mm: float
    correlation_unknown: bool
    warnings: tuple[Text, ...]


@dataclass(frozen=True)
class Inspection:
    """All that an inspection needs, checked."""

    files: FolderFiles
    program: ProgramFile
    station: StationKnowledge
    touches: ContactReadings | None
    whole: ProgramFile | None = None
    """The program with what was skipped."""


def find_files(
    folder: Path,
    scans: Sequence[Path] = (),
    touches: Path | None = None,
    calibration: Path | None = None,
    arm: Path | None = None,
    tip_um: float = 0.0,
) -> FolderFiles:
    """The files of a folder, or others in their place.

    Args:
        tip_um: standard uncertainty of the tip's diameter; 0: it is not stated.

    Raises:
        OperationError: ``inspection-folder-missing``.
    """
    if not folder.is_dir():
        raise OperationError(
            "inspection-folder-missing",
            message("part-no-folder", folder=display_path(folder)),
            "",
            message("part-folder-has", program=PROGRAM),
        )
    own_touches = folder / TOUCHES
    own_scans = sorted((folder / SCANS).glob("*.mcap")) if (folder / SCANS).is_dir() else []
    return FolderFiles(
        folder / PROGRAM,
        calibration or folder / CALIBRATION,
        arm or folder / ARM,
        tuple(scans) or tuple(own_scans),
        touches or (own_touches if own_touches.exists() else None),
        tip_um,
    )


def read_inspection(files: FolderFiles) -> Inspection:
    """Reads and checks all files but the recordings.

    Raises:
        OperationError: names the file and the place in it; a program that needs touches or scans
            that are not there.
    """
    program = ProgramFile.read(files.program)
    station = read_station(files.calibration, files.arm, files.tip_um)
    measured = program.without_skipped()
    means = {means for _, means in measured.list_wanted()}
    if "scan" in means and not files.scans:
        raise OperationError(
            "inspection-without-scan",
            message("part-no-scans", program=display_path(files.program)),
            message("part-features-by-scan"),
            message("part-put-scans", folder=SCANS),
        )
    for path in files.scans:
        if not path.exists():
            file_sha256(path)  # says what is wrong with it
    if "touch" in means and files.touches is None:
        raise OperationError(
            "inspection-without-touches",
            message("part-no-touches", program=display_path(files.program)),
            message("part-features-by-touch"),
            message("part-put-touches", file=TOUCHES),
        )
    touches = None
    if files.touches is not None:
        tip_of(station.arm)
        known = [one.id for one in program.features]
        touches = read_contacts(files.touches, station.arm, known)
    return Inspection(files, measured, station, touches, program)


def read_station(calibration_path: Path, arm_path: Path, tip_um: float = 0.0) -> StationKnowledge:
    """Arm and sensor of these files, and how well they are known.

    Args:
        tip_um: standard uncertainty of the tip's diameter, by which all touches err alike.
    """
    document, arm = CalibrationFile.read(calibration_path), read_any_arm(arm_path)
    calibration = calibration_from_document(document)
    check_serials(calibration, arm)
    known, scales = document.covariance, document.scales
    pivot = np.zeros(3) if known is None else np.array(known.pivot_mm)
    warnings: list[Text] = []
    if isinstance(arm, RobotArm):
        warnings.append(message("part-robot-noise-unknown"))
        none = np.zeros(6)
        return StationKnowledge(arm, calibration, pivot, None, none, 0.0, False, tuple(warnings))
    factor = None if scales is None else scales.reading_factor
    sds = reading_sds(arm, factor, LEAST_ENCODER_RAD)
    identified = ArmFile.read(arm_path).identification
    touch_sd = 0.0 if scales is None else scales.touch_mm
    if not touch_sd and identified is not None and identified.scatter_um:
        touch_sd = identified.scatter_um / 1e3
    shared, independent = None, False
    if known is None:
        warnings.append(message("part-calibration-without-covariance"))
    else:
        names, matrix = known.parameters, np.array(known.matrix)
        shared = place_by_name(names, matrix, arm.joint_count)
        if has_links(names, arm.joint_count):
            if identified is not None and not set(names) & set(TIP_NAMES):
                own = [one.name for one in identified.parameters]
                tip = tip_covariance(own, np.array(identified.covariance))
                none = np.zeros((6 * arm.joint_count, 6 * arm.joint_count))
                shared = add_arm(shared, ArmCovariance(none, tip))
            arm = with_links(arm, np.array(known.links))
        elif identified is not None:
            own = [one.name for one in identified.parameters]
            by = arm_by_identification(arm, own, np.array(identified.covariance))
            shared, independent = add_arm(shared, by), True
        elif scales is not None:
            by = arm_by_scales(arm.joint_count, scales.links_rad, scales.links_mm)
            shared, independent = add_arm(shared, by), True
        else:
            shared = None
            warnings.append(message("part-arm-errors-unknown"))
    if independent:
        warnings.append(message("part-correlation-unknown"))
    if shared is not None:
        shared[-1, -1] += (tip_um / 2e3) ** 2
    if sds is None:
        shared = None
        warnings.append(message("part-encoder-noise-unknown"))
    return StationKnowledge(
        arm,
        calibration,
        pivot,
        shared,
        np.zeros(arm.joint_count) if sds is None else sds,
        touch_sd,
        independent,
        tuple(warnings),
    )
