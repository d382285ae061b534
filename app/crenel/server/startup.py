"""Starts a station: its page is available at once, while everything heavy is loaded.

Heavy modules are imported only in the steps, which run while the page is already available.
"""

import socket
import tempfile
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from starlette.applications import Starlette

from crenel.errors import OperationError
from crenel.formats.file_modes import private_files
from crenel.monitoring.system_info import Network
from crenel.security.console_code import new_code
from crenel.server.listener import (
    LOCAL,
    listen,
    local_address,
    log_to_console,
    make_server,
    network_exposure,
    network_words,
    raise_file_limit,
    with_root_path,
)
from crenel.server.starting_page import (
    DATA,
    DEVICES,
    GUIDE,
    MEASURING,
    NUMERICS,
    PICTURES,
    VIEW,
    StartingApp,
    StartStep,
)
from crenel.settings.settings import DeviceTable, Serving, Settings, user_data_folder
from crenel.settings.station_toml import DEFAULT_FILE, read_settings

if TYPE_CHECKING:
    from crenel.operations.context import Context
    from crenel.operations.services import MonitoringSettings
    from crenel.server.live_replay import Replay
    from crenel.server.station_parts import StationParts
    from crenel.station.pulses.pulse_trigger import TriggerSettings

PORTS_TRIED = 20


@dataclass(frozen=True)
class Plan:
    """Properties of a station that are known before anything is loaded."""

    name: str
    parts: Callable[[], "StationParts"]
    """Loads the drivers, or starts the simulated devices."""
    host: str
    """Address that it listens on."""
    hosts: tuple[str, ...] = ()
    """Additional names by which browsers may reach it."""
    by_link: bool = False
    """A guest signs in with the link on the console."""
    serving: Serving = LOCAL


def serve(
    config: Path | None,
    data: Path | None,
    host: str,
    port: int,
    open_browser: bool,
    root_path: str = "",
) -> None:
    """Runs the station with the devices in ``station.toml`` until it is ended.

    Without a ``station.toml`` in the working folder, it is a station without devices: they are
    chosen on the Devices page.

    Args:
        root_path: the sub-path under which a proxy offers the station; empty: by the settings.

    Raises:
        OperationError: settings, driver, data folder or port are unusable.
    """
    settings = _read_or_begin(config)
    _check_drivers(settings, config)
    listening = listen(host, port, 1)
    plan = Plan(
        settings.station.name,
        lambda: _load_parts(settings, data, config or Path(DEFAULT_FILE)),
        host,
        settings.station.hosts,
        serving=with_root_path(settings.station, root_path),
    )
    print("Starting the station.", flush=True)
    run(plan, listening, open_browser)


def _read_or_begin(config: Path | None) -> Settings:
    """The settings; without a file and a name for it, those of a new station without devices."""
    if config is None and not Path(DEFAULT_FILE).exists():
        print(
            f"There is no {DEFAULT_FILE} here: choose the devices on the Devices page, which "
            "writes it.",
            flush=True,
        )
        return Settings()
    return read_settings(config)


def _check_drivers(settings: Settings, config: Path | None) -> None:
    """Loads the drivers, so that errors are reported before anything is served.

    Raises:
        OperationError: a driver is unknown, or its options are wrong.
    """
    from crenel_hardware.errors import DeviceError
    from crenel_hardware.registry import arm_driver, sensor_driver

    try:
        if (arm := settings.arm) is not None:
            arm_driver(arm.driver, arm.options)
        if (sensor := settings.sensor) is not None:
            sensor_driver(sensor.driver, sensor.options)
        for table in settings.sensors.values():
            sensor_driver(table.driver, table.options)
    except DeviceError as error:
        named = str(error.what).replace(DEFAULT_FILE, str(config or DEFAULT_FILE), 1)
        raise OperationError("driver", named, remedy=error.remedy) from error


def _load_parts(settings: Settings, data: Path | None, file: Path) -> "StationParts":
    """The parts that the settings name; no device is touched yet."""
    from crenel.metrology.limits import Limits
    from crenel.operations.device_setup import StationDevices
    from crenel.server.station_parts import StationParts

    station = settings.station
    devices = StationDevices(file.absolute(), settings.devices, sensors=settings.sensors)
    return StationParts(
        name=station.name,
        data=data or station.data,
        devices=devices,
        limits=Limits(settings.limits.good_um, settings.limits.usable_um),
        verification=settings.verification,
        rule=settings.decision.decision_rule,
        temperature_limits=settings.performance.temperature_limits,
        due=settings.due,
        trigger=_trigger_settings(settings),
        monitoring=_monitoring_settings(settings),
        sign_in=settings.sign_in,
    )


def _trigger_settings(settings: Settings) -> "TriggerSettings | None":
    from crenel.station.pulses.pulse_trigger import TriggerSettings

    table = settings.trigger
    if table is None:
        return None
    return TriggerSettings(table.rate_hz, table.delay_us, table.delays_us)


def _monitoring_settings(settings: Settings) -> "MonitoringSettings":
    """The station's properties from the settings, and the settings for display."""
    from crenel.operations.services import MonitoringSettings
    from crenel_hardware.thermometer import FileThermometer

    station, mqtt = settings.station, settings.mqtt
    tables: dict[str, DeviceTable] = dict(settings.devices.items())
    tables |= {f"sensor {name}": table for name, table in settings.sensors.items()}
    file = settings.temperature.file if settings.temperature else None
    effective_settings: dict[str, object] = {
        "drivers": {name: table.driver for name, table in tables.items()},
        "name": station.name,
        "data": str(station.data),
        "hosts": list(station.hosts),
        "limits": settings.limits.model_dump(),
        "decision": settings.decision.model_dump(),
        "tls": station.tls_certificate is not None,
        **{name: dict(table.options) for name, table in tables.items()},
        "mqtt": None if mqtt is None else {k: str(v) for k, v in mqtt},
        "archive": None if settings.archive is None else settings.archive.place,
        "sign_in": None if settings.sign_in is None else settings.sign_in.issuer,
        "temperature": None if file is None else str(file),
    }
    return MonitoringSettings(
        address=station.address,
        backups=station.backups,
        mqtt=mqtt,
        archive=settings.archive,
        thermometer=None if file is None else FileThermometer(file),
        effective_settings=effective_settings,
    )


def demo(
    data: Path | None,
    host: str,
    port: int,
    open_browser: bool,
    robot: bool = False,
    gige: bool = False,
    root_path: str = "",
) -> None:
    """Runs the complete station with simulated devices; if the port is taken, on the next free one.

    Args:
        robot: a robot carries the sensor, instead of an arm that an operator guides.
        gige: the sensor's camera sends its pictures over GigE Vision.
        root_path: the sub-path under which a proxy offers the station.

    Raises:
        OperationError: the data folder is unusable, or no port is free.
    """
    serving = with_root_path(LOCAL, root_path)
    listening = listen(host, port, PORTS_TRIED)
    folder = data or user_data_folder() / ("demo-robot" if robot else "demo")
    with ExitStack() as devices:

        def parts() -> "StationParts":
            from crenel.server.demo import open_simulation

            return devices.enter_context(open_simulation(folder, robot, gige))

        print("Starting the simulated station.", flush=True)
        plan = Plan("Demonstration", parts, host, by_link=True, serving=serving)
        run(plan, listening, open_browser)


def replay(
    show: "Replay",
    title: str,
    host: str,
    port: int,
    open_browser: bool,
    fill: Callable[[Path], None] = lambda data: None,
) -> None:
    """Runs the live view with a recording, in a temporary data folder.

    Args:
        fill: puts into the data folder what the station has besides.

    Raises:
        OperationError: no port is free.
    """
    from crenel.server.station_parts import StationParts

    listening = listen(host, port, PORTS_TRIED)
    with tempfile.TemporaryDirectory(prefix="crenel-replay-") as data:
        fill(Path(data))
        parts = StationParts(title, Path(data), show.arm, show.sensor, guest="Replay")
        plan = Plan(title, lambda: parts, host, by_link=True)
        try:
            run(plan, listening, open_browser, lambda ready: show.start(ready.scene, ready.bus))
        finally:
            show.stop()


def run(
    plan: Plan,
    listening: socket.socket,
    open_browser: bool,
    on_ready: Callable[["Context"], None] = lambda context: None,
) -> None:
    """Serves until SIGINT or SIGTERM.

    Args:
        on_ready: called on the event loop when everything is loaded.

    Raises:
        OperationError: the certificate, a driver or the data folder cannot be used, or the data
            folder is in use by another server.
    """
    raise_file_limit()
    network, code = network_exposure(plan.host, plan.serving), new_code()
    station = _StationLoader(plan, network, code)
    starting = StartingApp(plan.name, station.steps(), station.building(), station.hosts)
    server = make_server(starting, plan.serving)
    log_to_console()
    server.address = local_address(plan.host, listening, plan.serving)
    if plan.by_link:
        server.address += f"#code={code}"
    server.first_words += network_words(plan.host, plan.serving, DEFAULT_FILE)
    server.open_browser = open_browser

    def ready(app: Starlette, seconds: float) -> None:
        context: Context = app.state.context
        print(f"Ready after {seconds:.1f} s.", flush=True)
        if context.authenticator.first_start:
            print(
                f"Nobody can sign in yet. The code {code} creates the first administrator there.",
                flush=True,
            )
        on_ready(context)

    def failed() -> None:
        server.should_exit = True

    starting.on_ready, starting.on_failed = ready, failed
    try:
        with private_files():
            server.run(sockets=[listening])
    except KeyboardInterrupt:
        pass  # uvicorn raises the signal again after a regular end
    finally:
        listening.close()
    if starting.failure is not None:
        raise starting.failure


class _StationLoader:
    """Loads one station, step by step; the seconds of each are those of a cold start on two
    cores."""

    def __init__(self, plan: Plan, network: Network, code: str) -> None:
        self._plan, self._network, self._code = plan, network, code
        self.hosts = (*plan.hosts, plan.host)
        self._parts: StationParts | None = None

    def steps(self) -> list[StartStep[object]]:
        """The steps before the application can be built."""
        return [
            StartStep(NUMERICS, 1.0, _import_step("scipy.optimize", "scipy.spatial.transform")),
            StartStep(PICTURES, 0.3, _import_step("cv2")),
            StartStep(VIEW, 0.9, _import_step("viser")),
            StartStep(GUIDE, 2.0, _import_step("crenel.server.application")),
            StartStep(DEVICES, 0.7, self._load_devices),
            StartStep(MEASURING, 0.1, _load_libraries),
        ]

    def building(self) -> StartStep[Starlette]:
        """The last step: it opens the data folder."""
        return StartStep(DATA, 0.2, self._build)

    def _load_devices(self) -> None:
        self._parts = self._plan.parts()

    def _build(self) -> Starlette:
        from crenel.server.application import build_app

        assert self._parts is not None
        watching = replace(self._parts.monitoring, network=self._network)
        return build_app(
            replace(self._parts, hosts=self.hosts, code=self._code, monitoring=watching)
        )


def _import_step(*modules: str) -> Callable[[], object]:
    return lambda: [import_module(module) for module in modules]


def _load_libraries() -> None:
    """Reports a missing or outdated library now, not in the middle of a calibration."""
    from crenel.native.library import CRENEL

    CRENEL.load()
