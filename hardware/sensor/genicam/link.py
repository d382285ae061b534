"""Asks a silent camera whether it is there, and whether it still obeys this program."""

import socket
import struct
import threading
from itertools import count

from app.messages.message import Text, message
from hardware.errors import DeviceError
from hardware.sensor.genicam.aravis import AravisError
from hardware.sensor.genicam.camera import AravisCamera, in_use_error

_GVCP_PORT = 3956
_KEY, _ACKNOWLEDGE = 0x42, 0x01
_READ_REGISTER, _READ_REGISTER_ACK = 0x0080, 0x0081
_CONTROL_REGISTER = 0x0A00
_CONTROLLED = 0b11
_TRIES, _TRY_S = 3, 0.15


class CameraLink:
    """The control channel of a camera.

    Aravis waits up to 3 s for the answer of a GigE Vision camera. So this asks through a socket of
    its own, and knows after half a second; any program may read a camera's registers.

    Source:
        AIA, GigE Vision 2.0, sections 17.1 (READREG) and 28.4 (control channel privilege).
    """

    def __init__(self, title: Text, camera: AravisCamera) -> None:
        self._title = title
        self._camera = camera
        self._requests = count(1)
        self._lock = threading.Lock()
        self._heartbeat_ms = 0
        self._socket: socket.socket | None = None
        if camera.is_gige and camera.address:
            self._heartbeat_ms = camera.read_heartbeat_timeout()
            self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            self._socket.settimeout(_TRY_S)
            self._socket.connect((camera.address, _GVCP_PORT))

    def require_control(self) -> None:
        """Asks the camera.

        Raises:
            DeviceError: it does not answer, or another program has taken it.
        """
        if self._socket is None:
            try:
                self._camera.read_first_bytes()
            except AravisError as error:
                raise self._loss_error() from error
            return
        with self._lock:
            control = self._read_control(self._socket)
        if not control & _CONTROLLED:
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
        if self._socket is not None:
            self._socket.close()

    def _read_control(self, control: socket.socket) -> int:
        """The register that says whether a program controls the camera."""
        for _ in range(_TRIES):
            request = next(self._requests) % 0xFFFF + 1
            head = (_KEY, _ACKNOWLEDGE, _READ_REGISTER, 4, request, _CONTROL_REGISTER)
            try:
                control.send(struct.pack(">BBHHHI", *head))
                while True:
                    answer = control.recv(64)
                    if len(answer) < 12:
                        continue
                    status, command, _, of, value = struct.unpack_from(">HHHHI", answer)
                    if (command, of) == (_READ_REGISTER_ACK, request):
                        return int(value) if status == 0 else _CONTROLLED
            except OSError:  # no answer in time, or the system knows that nobody is there
                continue
        raise self._loss_error()

    def _loss_error(self) -> DeviceError:
        return DeviceError(message("device-lost", title=self._title), message("check-cable-power"))


def control_lost_error(title: Text) -> DeviceError:
    """The error of a camera that nobody controls any more."""
    return DeviceError(
        message("camera-control-lost", title=title), message("check-network-load-or-power")
    )
