"""Asks a silent camera whether it is there, and whether it still obeys this program."""

import threading

from crenel.messages.message import Text, message
from crenel_hardware.errors import DeviceError, device_lost_error
from crenel_hardware.sensor.genicam.aravis import AravisError
from crenel_hardware.sensor.genicam.camera import AravisCamera, in_use_error
from crenel_hardware.sensor.genicam.gige_vision.control_register import ControlRegister


class CameraLink:
    """The control channel of a camera.

    A GigE Vision camera is asked through a socket of its own, which is quicker than Aravis.
    """

    def __init__(self, title: Text, camera: AravisCamera) -> None:
        self._title = title
        self._camera = camera
        self._lock = threading.Lock()
        self._heartbeat_ms = 0
        self._register: ControlRegister | None = None
        if camera.is_gige and camera.address:
            self._heartbeat_ms = camera.read_heartbeat_timeout()
            self._register = ControlRegister(camera.address)

    def require_control(self) -> None:
        """Asks the camera.

        Raises:
            DeviceError: it does not answer, or another program has taken it.
        """
        if self._register is None:
            try:
                self._camera.read_first_bytes()
            except AravisError as error:
                raise device_lost_error(self._title) from error
            return
        with self._lock:
            control = self._register.read()
        if control is None:
            raise device_lost_error(self._title)
        if not control:
            raise control_lost_error(self._title)
        try:
            self._camera.write_heartbeat_timeout(self._heartbeat_ms)
        except AravisError as error:
            raise in_use_error(self._title) from error

    def is_alive(self) -> bool:
        """Whether the camera answers and obeys."""
        try:
            self.require_control()
        except DeviceError:
            return False
        return True

    def close(self) -> None:
        if self._register is not None:
            self._register.close()


def control_lost_error(title: Text) -> DeviceError:
    """The error of a camera that nobody controls any more."""
    return DeviceError(
        message("camera-control-lost", title=title), message("check-network-load-or-power")
    )
