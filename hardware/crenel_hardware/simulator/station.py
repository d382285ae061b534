"""The simulated station: ``SimulatedStation`` joins arm, sensor, table, operator and faults.

Its arm speaks real bytes at ``arm_url``, its sensor is a driver like any other, and
``datasheets`` are what an operator would be given with the devices.
"""

from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from crenel_hardware.interfaces import Button, SensorDriver, SensorInfo
from crenel_hardware.registry import sensor_driver
from crenel_hardware.simulator.configuration import SimulationConfig, build_rig, model_frame
from crenel_hardware.simulator.devices.arm_device import ArmDevice, ArmFaults, Encoders
from crenel_hardware.simulator.devices.gige_camera.camera import (
    LASER_LINE,
    TRIGGER_LINE,
    GigeCamera,
)
from crenel_hardware.simulator.devices.gige_camera.registers import CameraIdentity
from crenel_hardware.simulator.devices.kinematics import (
    Floats,
    flange_pose,
    flange_poses,
    rotation_about,
)
from crenel_hardware.simulator.devices.motion import Motion
from crenel_hardware.simulator.devices.ports import DevicePort, PtyPort, TcpPort
from crenel_hardware.simulator.devices.rtde_server import RobotState, RtdeServer
from crenel_hardware.simulator.operator.gauges.bar import ball_bar_datasheet
from crenel_hardware.simulator.operator.gauges.part import example_program
from crenel_hardware.simulator.operator.gauges.plate import flat_plate_datasheet
from crenel_hardware.simulator.operator.gauges.step_gauge import step_gauge_datasheet
from crenel_hardware.simulator.operator.holding import SensorMount
from crenel_hardware.simulator.operator.operator import ScriptedOperator
from crenel_hardware.simulator.rendering.line_sensor import LineSensor, find_profile
from crenel_hardware.simulator.rendering.noise import RawImage
from crenel_hardware.simulator.rendering.render import Renderer
from crenel_hardware.simulator.rendering.sensor import (
    EXPOSURE_RANGE_US,
    LONGEST_GAP_S,
    CameraFaults,
    Lighting,
    SharedRenderer,
    SimulatedSensor,
)
from crenel_hardware.simulator.rendering.triggered_sensor import TriggeredSensor
from crenel_hardware.simulator.scene.datasheets import (
    JsonObject,
    arm_datasheet,
    block_datasheet,
    board_datasheet,
    plane_nominal,
    robot_datasheet,
    sensor_datasheet,
    sphere_nominal,
)
from crenel_hardware.simulator.scene.random_scenes import (
    draw_true_board,
)
from crenel_hardware.simulator.scene.tabletop import build_table_scene
from crenel_hardware.simulator.scene.world import Box, GaugeSphere, SimulatedScene
from crenel_hardware.simulator.session import ground_truth

__all__ = ["SimulatedStation", "SimulationConfig"]
SENSOR_SERIAL_NUMBER = "TWIN-S1"
JUMBO_BYTES = 8192
SECOND_SERIAL_NUMBER = "TWIN-S2"
SECOND_MOUNTING = rotation_about("z", 0.6) @ rotation_about("x", 0.2)
"""``T_sensor_second`` (4, 4): about the middle of the measuring range, so that both lines meet."""


class SimulatedStation:
    """A simulated station. Nothing runs before ``start``; ``stop`` may be called twice."""

    def __init__(self, config: SimulationConfig | None = None) -> None:
        self.config = config or SimulationConfig()
        self.arm_faults, self.camera_faults = ArmFaults(), CameraFaults()
        self.second_camera_faults = CameraFaults()
        self.lighting = Lighting()
        rng = np.random.default_rng(self.config.seed)
        self._rig, self._home = build_rig(self.config, rng)
        self._correction = model_frame(self._rig, self._home, rng)
        self._board = draw_true_board(self.config.board, self.config.certificate_sd_mm, rng)
        rig = self._rig
        self._scene = build_table_scene(
            rig.block, rig.T_arm_obj, self._board, self._correction, self.config.light
        )
        tremor_rad = self.config.tremor_um * 1e-3 / 600.0
        self._motion = Motion(self._home, tremor_rad, self.config.seed)
        self.shared_renderer = SharedRenderer(
            self._renderer,
            self.sensor_pose,
            self._motion.is_resting,
            self.lighting,
            self.camera_faults,
        )
        self._T_flange_second = rig.T_flange_sensor @ SECOND_MOUNTING
        self._second_renderer: SharedRenderer | None = None
        if self.config.second_sensor:
            self._second_renderer = SharedRenderer(
                self._renderer,
                self._second_pose,
                self._motion.is_resting,
                self.lighting,
                self.second_camera_faults,
            )
        self._line: DevicePort | None = None
        self._device: ArmDevice | None = None
        self._robot: RtdeServer | None = None
        self._triggered: dict[str, TriggeredSensor] = {}
        self._gige: GigeCamera | None = None
        self.operator = ScriptedOperator(
            self._rig.arm,
            self._motion,
            self._scene,
            SensorMount(self._rig.optics, self._rig.light_plane, self._rig.T_flange_sensor),
            self._press,
            self._show,
            self.config.contact_sd_mm,
            self.config.pace,
            self.config.seed,
        )

    @property
    def arm_url(self) -> str:
        """What the ``serial-encoder`` driver opens; known once started."""
        if self._line is None:
            raise RuntimeError("the simulation is not started")
        return self._line.url

    @property
    def robot(self) -> RtdeServer:
        """The robot's controller; there once started, if the arm is a robot."""
        if self._robot is None:
            raise RuntimeError("the simulated robot is not started")
        return self._robot

    @property
    def device(self) -> ArmDevice:
        """The arm's electronics; there once started."""
        if self._device is None:
            raise RuntimeError("the simulation is not started")
        return self._device

    @property
    def gige_camera(self) -> GigeCamera:
        """The GigE camera; there once started, if the sensor is one."""
        if self._gige is None:
            raise RuntimeError("the simulated camera is not started")
        return self._gige

    def start(self) -> "SimulatedStation":
        """Makes ready for pictures, and serves the arm's bytes.

        Raises ``OSError`` when the port is taken, ``DeviceError`` when that of the GigE camera is.
        """
        self.shared_renderer.prepare()
        if self._second_renderer is not None:
            self._second_renderer.prepare()
        if self.config.camera == "gige" and self._gige is None:
            gige = self._make_gige()
            gige.start()
            self._gige = gige
        if self.config.robot:
            self._start_robot()
        elif self._device is None:
            config = self.config
            self._line = PtyPort() if config.line == "pty" else TcpPort(config.host, config.port)
            encoders = Encoders(
                config.rate_hz, config.counts_per_revolution, self._rig.arm.encoder_sd_rad
            )
            self._device = ArmDevice(
                self._motion,
                self._line,
                encoders,
                self.arm_faults,
                config.seed,
                self._controller_poses if config.arm_reports == "pose" else None,
                self._trigger,
            )
            self._device.start()
        return self

    def clear_faults(self) -> None:
        """Everything works again."""
        self.arm_faults.clear()
        for faults in (self.camera_faults, self.second_camera_faults):
            faults.lost, faults.drop_rate = False, 0.0
        if self._gige is not None:
            self._gige.faults.clear()

    def stop(self) -> None:
        """Ends the arm and the simulated operator's move."""
        self.operator.cancel()
        if self._robot is not None:
            self._robot.stop()
            self._robot = None
        if self._device is not None:
            self._device.stop()
            self._device = None
        if self._gige is not None:
            self._gige.stop()
            self._gige = None

    def __enter__(self) -> "SimulatedStation":
        return self.start()

    def __exit__(self, *_: object) -> None:
        self.stop()

    def sensor_options(self) -> dict[str, object]:
        """Options of the driver ``genicam`` for the GigE camera."""
        options: dict[str, object] = {
            "address": self.config.camera_address,
            "packet_size": JUMBO_BYTES,
        }
        if self.config.laser_switch:
            options["laser_line"] = LASER_LINE
        if self.config.triggered:
            options["trigger"] = TRIGGER_LINE
        return options

    def sensor(self) -> SensorDriver:
        """A new driver of the station's one sensor, unopened."""
        if self.config.camera == "gige":
            return sensor_driver("genicam", self.sensor_options())
        info = self._sensor_info(SENSOR_SERIAL_NUMBER)
        if self.config.triggered:
            return self._make_triggered(self.shared_renderer, info, self.config.seed)
        info = replace(info, delivers=self.config.delivers)
        early_ns = round(1e6 * self.config.arm_delay_ms)
        make = LineSensor if "line" in info.delivers else SimulatedSensor
        return make(self.shared_renderer, info, self.config.frames_hz, self.config.seed, early_ns)

    def second_sensor(self) -> SensorDriver:
        """A new driver of the second sensor, unopened."""
        assert self._second_renderer is not None, "there is no second sensor"
        info, config = self._sensor_info(SECOND_SERIAL_NUMBER), self.config
        if config.triggered:
            return self._make_triggered(self._second_renderer, info, config.seed + 1)
        return SimulatedSensor(self._second_renderer, info, config.frames_hz, config.seed + 1)

    def _make_triggered(
        self, renderer: SharedRenderer, info: SensorInfo, seed: int
    ) -> SensorDriver:
        waiting = replace(info, free_running=False)
        sensor = TriggeredSensor(renderer, waiting, self.config.jitter_ms, seed)
        self._triggered[info.serial_number] = sensor
        return sensor

    def _sensor_info(self, serial_number: str) -> SensorInfo:
        optics = self._rig.optics
        return SensorInfo(
            name="Simulated stripe sensor",
            serial_number=serial_number,
            width_px=optics.width_px,
            height_px=optics.height_px,
            exposure_range_us=EXPOSURE_RANGE_US,
            has_laser_switch=self.config.laser_switch,
            longest_gap_s=LONGEST_GAP_S,
        )

    def _second_pose(self, stamp_ns: int) -> Floats:
        T = flange_pose(self._rig.arm, self._motion.at(stamp_ns)) @ self._T_flange_second
        return np.asarray(T)

    def sensor_pose(self, stamp_ns: int) -> Floats:
        """``T_arm_sensor`` (4, 4) as it truly is at a moment."""
        T = flange_pose(self._rig.arm, self._motion.at(stamp_ns)) @ self._rig.T_flange_sensor
        return np.asarray(T)

    def joints(self, stamps_ns: NDArray[np.int64]) -> Floats:
        """(N, n) encoder angles as they truly were at moments (N,) of the last seconds."""
        return self._motion.at_all(stamps_ns)

    def datasheets(self) -> dict[str, JsonObject]:
        """What the operator is given, by file name."""
        rig = self._rig
        arm = rig.nominal_arm
        if self.config.robot:
            arm_document = robot_datasheet(arm, tip=False)
        else:
            poses = self.config.arm_reports == "pose"
            arm_document = robot_datasheet(arm) if poses else arm_datasheet(arm)
        ball = self._scene.find_object("sphere").shape
        assert isinstance(ball, GaugeSphere)
        small = self._scene.find_object("plate").shape
        assert isinstance(small, Box)
        width_mm = min(2 * small.high_mm[0], 2 * small.high_mm[1])
        plate, sphere = (
            np.linalg.inv(self._correction) @ self._scene.find_object(name).T_arm_obj
            for name in ("plate", "sphere")
        )
        return {
            "arm.json": arm_document,
            "object.json": block_datasheet(rig.certificate, self.config.certificate_sd_mm),
            "chessboard.json": board_datasheet(self.config.board, self.config.certificate_sd_mm),
            "sensor.json": sensor_datasheet(rig.optics, rig.light_plane),
            "plate.nominal.json": plane_nominal(plate[:3, 3], plate[:3, 2], width_mm),
            "surface-plate.nominal.json": flat_plate_datasheet(),
            "sphere.nominal.json": sphere_nominal(sphere[:3, 3], ball),
            "ball-bar.json": ball_bar_datasheet(),
            "example-plate.json": example_program(),
            "step-gauge.json": step_gauge_datasheet(self.operator.step_gauge),
        }

    def truth(self) -> JsonObject:
        """What only nature knows; as ``truth.json`` of a rendered session, and the board."""
        board, at = self._board, self._scene.find_object("board").T_arm_obj
        squares = [board.square_x_mm, board.square_y_mm]
        second = self._T_flange_second.tolist()
        truth = {**ground_truth(self._rig), "T_flange_second_sensor": second}
        return {**truth, "squares_mm": squares, "T_arm_board": at.tolist()}

    def _start_robot(self) -> None:
        if self._robot is not None:
            return
        noise = np.random.default_rng(self.config.seed + 1)

        def state_at(at_ns: int) -> RobotState:
            q = self._motion.at(at_ns)
            q = q + noise.normal(0.0, self._rig.arm.encoder_sd_rad, q.shape)
            return RobotState(q, self._controller_poses(q[None])[0])

        self._robot = RtdeServer(state_at, self.config.host, self.config.port)
        self._robot.start()

    def _make_gige(self) -> GigeCamera:
        config, optics = self.config, self._rig.optics
        finds_lines = "line" in config.delivers
        return GigeCamera(
            CameraIdentity(
                config.camera_address,
                SENSOR_SERIAL_NUMBER,
                optics.width_px,
                optics.height_px,
                config.frames_hz,
                1 if finds_lines else None,
            ),
            self.shared_renderer.expose if config.laser_switch else self._expose_with_laser,
            config.detector.bits,
            seed=config.seed,
            has_power=lambda: not self.camera_faults.lost,
            find_line=partial(find_profile, detector=config.detector) if finds_lines else None,
        )

    def _expose_with_laser(self, mid_ns: int, exposure_us: float, _: float) -> RawImage:
        """A picture of a sensor whose laser is wired on."""
        return self.shared_renderer.expose(mid_ns, exposure_us, 1.0)

    def trigger_camera(self, stamp_ns: int) -> None:
        """A pulse on the cameras' inputs, of another arm than the simulated one."""
        self._trigger(stamp_ns)

    def _trigger(self, stamp_ns: int) -> None:
        for sensor in tuple(self._triggered.values()):
            sensor.trigger(stamp_ns)
        if self._gige is not None:
            self._gige.trigger(stamp_ns)

    def _controller_poses(self, q_rad: Floats) -> Floats:
        return flange_poses(self._rig.nominal_arm, q_rad)

    def _press(self, button: Button, pressed: bool, at_ns: int) -> None:
        if self._device is not None:
            self._device.press(button, pressed, at_ns)

    def _show(self, scene: SimulatedScene) -> None:
        self.shared_renderer.show(scene)
        if self._second_renderer is not None:
            self._second_renderer.show(scene)

    def _renderer(self) -> Renderer:
        rig = self._rig
        return Renderer(
            self._scene, rig.optics, rig.light_plane, self.config.detector, self.config.seed
        )
