"""A real broker, Debian's mosquitto, on a free port of this machine; for tests, too."""

import getpass
import shutil
import socket
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import Self

from tests.bench.station.subprocess_station import free_port, stuck_error

STARTED_MODULES = ()  # programs of others

BINARY = shutil.which("mosquitto") or shutil.which("mosquitto", path="/usr/sbin:/usr/local/sbin")
START_S = 10.0
USER, PASSWORD = "station", "a broker's password"


class Mosquitto:
    """Can be killed and started again on the same port.

    Args:
        settings: further lines of its configuration, such as those of TLS.
    """

    def __init__(self, folder: Path, passwords: bool = False, settings: Sequence[str] = ()) -> None:
        self.port = free_port()
        self._config = folder / "mosquitto.conf"
        # started by root it would become a user who may not read the passwords
        lines = [f"listener {self.port} 127.0.0.1", f"user {getpass.getuser()}", *settings]
        if passwords:
            listed = folder / "passwords"
            maker = shutil.which("mosquitto_passwd") or "mosquitto_passwd"
            subprocess.run([maker, "-b", "-c", str(listed), USER, PASSWORD], check=True)
            lines += ["allow_anonymous false", f"password_file {listed}"]
        else:
            lines += ["allow_anonymous true"]
        self._config.write_text("\n".join(lines) + "\n")
        self._process: subprocess.Popen[bytes] | None = None
        self.start()

    def start(self) -> None:
        """Starts it, also again on its port; raises ``OperationError`` if it does not."""
        self._process = subprocess.Popen(
            [BINARY or "mosquitto", "-c", str(self._config)],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        deadline_s = time.monotonic() + START_S
        while True:
            with socket.socket() as trying:
                trying.settimeout(0.5)
                if trying.connect_ex(("127.0.0.1", self.port)) == 0:
                    return
            if time.monotonic() > deadline_s:
                raise stuck_error("the broker does not start", START_S)
            time.sleep(0.05)

    def kill(self) -> None:
        """Ends it as the kernel does; idempotent."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.kill()
