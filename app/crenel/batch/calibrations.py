"""The calibrations, and the arms they belong to, with which recordings are rebuilt."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from crenel.archive.remote_store import RemoteStore, read_document
from crenel.batch.patience import Patience
from crenel.batch.places import Place
from crenel.batch.recordings import ScanRecording
from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.file_names import display_path
from crenel.formats.open_file import read_bounded
from crenel.formats.recording.reader import ARM_SERIAL, SENSOR_SERIAL
from crenel.formats.recording.topics import sensor_key, sensor_values
from crenel.formats.results.calibration import Calibration, read_calibration
from crenel.messages.message import join, message, replace_name
from crenel.metrology.arm.kinematics import AnyArm
from crenel.workflows.compatibility import check_serials

ARM, CALIBRATION = "arm.json", "calibration.json"


@dataclass(frozen=True)
class CalibrationFiles:
    """A calibration and the arm on which it was made, as their files' contents."""

    id: str
    calibration: bytes
    arm: bytes

    @property
    def digest(self) -> str:
        """A hash of both contents."""
        return f"{self.calibration_sha256} {self.arm_sha256}"

    @property
    def calibration_sha256(self) -> str:
        """The hash of the calibration's file."""
        return hashlib.sha256(self.calibration).hexdigest()

    @property
    def arm_sha256(self) -> str:
        """The hash of the arm's file."""
        return hashlib.sha256(self.arm).hexdigest()

    def write(self, folder: Path) -> None:
        """Writes both files under their usual names; raises ``OSError``."""
        for name, content in ((CALIBRATION, self.calibration), (ARM, self.arm)):
            (folder / name).write_bytes(content)

    def read(self, folder: Path) -> tuple[Calibration, AnyArm]:
        """What the files contain.

        Args:
            folder: for the files.

        Raises:
            OperationError: one is damaged, or they do not belong together.
        """
        self.write(folder)
        try:
            calibration, arm = read_calibration(folder / CALIBRATION), read_any_arm(folder / ARM)
            check_serials(calibration, arm)
        except OperationError as error:
            what = message("batch-calibration-unusable", id=self.id)
            found = join([error.what, error.why], ": ") if error.why else error.what
            why = replace_name(found, f"{display_path(folder)}/", "")  # nobody finds it there
            raise OperationError(error.code, what, why, error.remedy) from error
        return calibration, arm


BySensor = Mapping[str, CalibrationFiles]
"""By the name of the sensor; empty of the only one."""


class CalibrationFinder:
    """Looks up calibrations in places by their ids, and remembers what it found."""

    def __init__(self, places: Sequence[Place], patience: Patience | None = None) -> None:
        self._stores = [(place, place.store(patience)) for place in places]
        self._known: dict[tuple[str, str], CalibrationFiles | None] = {}

    def find(self, calibration_id: str, first: Place | None = None) -> CalibrationFiles | None:
        """A calibration; that of the place ``first`` if several have one of this name.

        Raises:
            OperationError: a place cannot be read.
        """
        key = (first.settings.url if first is not None else "", calibration_id)
        if key not in self._known:
            ordered = sorted(self._stores, key=lambda one: one[0] != first)
            found = (read_files(place, calibration_id, store) for place, store in ordered)
            self._known[key] = next((one for one in found if one is not None), None)
        return self._known[key]

    def of_recording(self, recording: ScanRecording, given: BySensor | None = None) -> BySensor:
        """The calibrations with which a scan was taken.

        Args:
            given: of some sensors, others instead.

        Raises:
            OperationError: one of them is in none of the places, or it is not known which.
        """
        ids, found = recording.calibration_ids, dict(given or {})
        for sensor, one in ids.items():
            if sensor in found:
                continue
            files = self.find(one, recording.file.place)
            if files is not None:
                found[sensor] = files
        if not found or len(found) < len(ids):
            missing = [one for sensor, one in ids.items() if sensor not in found]
            raise OperationError(
                "no-calibration",
                message("batch-no-calibration", id=", ".join(missing) or "?"),
                remedy=message("batch-name-calibration"),
            )
        return found


def read_files(place: Place, calibration_id: str, store: RemoteStore) -> CalibrationFiles | None:
    """A calibration of a place; None if it has none with this id.

    Raises:
        OperationError: the place cannot be read, or a file is longer than any document.
    """
    record = place.record("sessions", calibration_id, store)
    if record is None or not {ARM, CALIBRATION} <= record.files.keys():
        return None
    calibration, arm = (
        read_document(store, record.files[name].name) for name in (CALIBRATION, ARM)
    )
    return CalibrationFiles(calibration_id, calibration, arm)


def choose_calibration(text: str, arm: Path | None, finder: CalibrationFinder) -> CalibrationFiles:
    """A calibration by its file, or by its id in the places.

    Args:
        arm: of the calibration; None: that beside it.

    Raises:
        OperationError: there is none, or its arm is missing.
    """
    path = Path(text)
    if path.is_file():
        return CalibrationFiles(
            path.parent.name or path.stem,
            read_bounded(path),
            read_bounded(arm or path.with_name(ARM)),
        )
    found = finder.find(text)
    if found is None:
        raise OperationError(
            "no-calibration",
            message("batch-no-calibration", id=text),
            remedy=message("batch-name-calibration"),
        )
    if arm is not None:
        return CalibrationFiles(found.id, found.calibration, read_bounded(arm))
    return found


class GivenCalibrations:
    """Calibrations that are given for many recordings, of which some may be of other devices.

    Raises:
        OperationError: one is damaged, or does not belong to its arm.
    """

    def __init__(self, files: BySensor) -> None:
        self.files = files
        with TemporaryDirectory(prefix="crenel-") as folder:
            self._read = {sensor: one.read(Path(folder)) for sensor, one in files.items()}

    def belong_to(self, recording: ScanRecording) -> bool:
        """Whether the recording states no other arm and no other sensors."""
        stated = recording.metadata
        for sensor, (calibration, arm) in self._read.items():
            serials = calibration.serial_numbers
            for found, known in (
                (stated.get(sensor_key(SENSOR_SERIAL, sensor), ""), serials.sensor),
                (stated.get(ARM_SERIAL, ""), arm.serial_number),
            ):
                if found and known and found != known:
                    return False
        return True


def sensors_of(files: CalibrationFiles, recording: ScanRecording) -> list[str]:
    """The names of the sensors of a recording that a calibration is of, by the serial number; of
    the only one, also if it is not known.

    Raises:
        OperationError: the calibration is damaged, or does not belong to its arm.
    """
    names = list(recording.calibration_ids)
    fitting = [one for one in names if GivenCalibrations({one: files}).belong_to(recording)]
    if len(names) == 1:
        return fitting
    stated = sensor_values(recording.metadata, SENSOR_SERIAL)
    return [one for one in fitting if stated.get(one)]
