"""Sessions on the simulated table's chessboard: rendered pictures, and the truth behind them."""

import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from crenel.formats.datasheets.arm import read_arm
from crenel.formats.datasheets.target import read_object
from crenel.metrology.adjustment.board.calibrate import (
    BoardCalibration,
    calibrate_board,
    observe_board,
)
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats, apply, inverse
from crenel_hardware.simulator.devices.kinematics import solve_joints
from crenel_hardware.simulator.operator.holding import sensor_over_board
from crenel_hardware.simulator.rendering.noise import RawImage
from crenel_hardware.simulator.scene.world import Board
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig

COUNT = 8
RAYS = 34
"""Over a pixel at an edge."""


@dataclass(frozen=True)
class BoardShot:
    """One pose: what both pictures show, what the encoders say, and where the sensor truly was."""

    ambient: RawImage
    laser: RawImage
    reading_rad: Floats
    T_board_sensor: Floats


class RenderedBoards:
    """A simulation that is not started, as nothing moves: poses are reached, pictures rendered."""

    def __init__(self, folder: Path, config: SimulationConfig, count: int = COUNT) -> None:
        self.simulation = SimulatedStation(config)
        self._rng = np.random.default_rng(config.seed + 500)
        self._renderer = self.simulation._renderer()
        for name, datasheet in self.simulation.datasheets().items():
            (folder / name).write_text(json.dumps(datasheet))
        self.arm = read_arm(folder / "arm.json")
        board = read_object(folder / "chessboard.json")
        assert isinstance(board, Chessboard)
        self.board = board
        self.axis = str(self.simulation.datasheets()["sensor.json"]["stripe_axis"])
        self.shots = [self._shot(view) for view in range(count)]

    def _shot(self, view: int) -> BoardShot:
        rig, thing = self.simulation._rig, self.simulation._scene.find_object("board")
        assert isinstance(thing.shape, Board)
        mount = self.simulation.operator._sensor_mount
        T_board_sensor = sensor_over_board(thing.shape, mount, view, self._rng)
        T = thing.T_arm_obj @ T_board_sensor
        T_flange = T @ inverse(rig.T_flange_sensor)
        q = solve_joints(rig.arm, T_flange, self.simulation._home, self._rng)
        noise = self._rng.normal(0.0, rig.arm.encoder_sd_rad, len(q))
        pictures = (self._renderer.render(T, 1.0, 0.0, RAYS), self._renderer.render(T, 0.0, 1.0))
        return BoardShot(*pictures, q + noise, T_board_sensor)

    @cached_property
    def detections(self) -> tuple[BoardObservation, ...]:
        return tuple(
            observe_board(k + 1, self.board, shot.ambient, shot.laser, self.axis)
            for k, shot in enumerate(self.shots)
        )

    @cached_property
    def calibration(self) -> BoardCalibration:
        readings = np.array([shot.reading_rad for shot in self.shots])
        size = (self.simulation.config.width_px, self.simulation.config.height_px)
        return calibrate_board(BoardInputs(self.arm, self.board, self.detections, readings, size))

    def camera(self, T_frame_sensor: Floats) -> Camera:
        """The true camera, placed in a frame."""
        optics = self.simulation._rig.optics
        T = optics.T_cam_sensor @ inverse(T_frame_sensor)
        size = (optics.width_px, optics.height_px)
        return Camera(optics.matrix, T[:3, :3], T[:3, 3], *size, np.array(optics.distortion))

    def true_points(self, uv_px: Floats) -> Floats:
        """Where the light of pixels (N, 2) truly comes from, flange frame."""
        document = self.simulation._rig.light_plane
        plane = LaserPlane(np.array(document.normal), document.offset_mm)
        points = sensor_points(self.camera(np.eye(4)), plane, uv_px)
        return apply(self.simulation._rig.T_flange_sensor, points)


def errors_um(session: RenderedBoards) -> Floats:
    """(G,) how far reconstructed points over the measuring volume lie off, flange frame."""
    found, uv = session.calibration, session.calibration.uncertainty.volume.uv_px
    state = found.adjustment.state
    ours = apply(state.T_flange_cam, sensor_points(state.camera, state.plane, uv))
    return np.asarray(1e3 * np.linalg.norm(ours - session.true_points(uv), axis=1))
