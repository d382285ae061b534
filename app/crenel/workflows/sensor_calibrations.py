"""The calibrations with which a recording is rebuilt: one for each sensor in it."""

from collections.abc import Mapping

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.recording.reader import Recording
from crenel.formats.results.calibration import Calibration
from crenel.messages.message import Text, message

SensorCalibrations = Calibration | Mapping[str, Calibration]
"""The calibration of the only sensor, or that of each sensor by its name."""


def calibrations_by_sensor(given: SensorCalibrations) -> dict[str, Calibration]:
    """Each calibration by the name of its sensor; that of the only one is empty."""
    return {"": given} if isinstance(given, Calibration) else dict(given)


class RecordedSensors:
    """Gives each frame its sensor's calibration, and counts the frames of sensors without one."""

    def __init__(self, recording: Recording, given: SensorCalibrations) -> None:
        self._recording = recording
        self._given = calibrations_by_sensor(given)
        self._left_out: dict[str, int] = {}

    def calibration_of(self, sensor: str) -> Calibration | None:
        """None for a named sensor whose calibration was not given.

        Raises:
            OperationError: the recording names its sensors and the calibrations do not, or the
                reverse.
        """
        if ("" in self._given) == (sensor == ""):
            return self._given.get(sensor)
        path = display_path(self._recording.path)
        if sensor:
            names = ", ".join(name for name in self._recording.sensors if name)
            raise OperationError(
                "recording-of-several-sensors",
                message("recording-has-sensors", path=path, names=names),
                message("a-calibration-belongs-to-one-sensor"),
                message("give-a-calibration-for-each-sensor", name=sensor),
            )
        raise OperationError(
            "recording-of-one-sensor",
            message("recording-has-one-sensor", path=path),
            message("its-sensor-has-no-name"),
            message("give-calibration-without-name"),
        )

    def leave_out(self, sensor: str, frames: int) -> None:
        """Counts frames of a sensor without a calibration."""
        self._left_out[sensor] = self._left_out.get(sensor, 0) + frames

    def refuse_unknown(self) -> None:
        """Raises ``OperationError`` if a calibration is of a sensor that was not recorded."""
        known = self._recording.sensors
        for name in self._given:
            if name and known and name not in known:
                raise OperationError(
                    "sensor-not-recorded",
                    message(
                        "recording-has-no-sensor-named",
                        path=display_path(self._recording.path),
                        name=name,
                    ),
                    message("its-sensors-are", names=", ".join(one for one in known if one)),
                    message("give-files-belong-together"),
                )

    def warnings(self) -> list[Text]:
        """The sensors whose frames were left out."""
        return [
            message("sensor-left-out", name=name, count=count)
            for name, count in sorted(self._left_out.items())
        ]
