"""Which of several sensors is seen, switched, exposed and calibrated."""

from collections.abc import Callable

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.station.devices.rig import Rig, SensorChoice
from crenel.station.preview.preview import Preview


class SensorSelection:
    """Selects a sensor for the whole station.

    Args:
        use: called after a change: the calibrations in use are applied again.
        name_open: says that a guided session is open, whose sensor must not change; or nothing.
        is_scanning: whether all sensors are in use.
    """

    def __init__(
        self,
        rig: Rig,
        preview: Preview,
        use: Callable[[], None],
        name_open: Callable[[], Text],
        is_scanning: Callable[[], bool],
    ) -> None:
        self._rig, self._preview, self._use = rig, preview, use
        self._name_open, self._is_scanning = name_open, is_scanning

    def select(self, name: str) -> SensorChoice:
        """Selects a sensor.

        Raises:
            OperationError: there is no such sensor, or a guided session is open.
        """
        if name != self._rig.selected and (what := self._name_open()):
            raise OperationError(
                "busy", message("sensor-cannot-be-selected-now"), what, message("end-it-first")
            )
        self._rig.select(name, self._is_scanning())
        self._preview.use_sensor(self._rig.sensor)
        self._use()
        return self._rig.sensor_choice()
