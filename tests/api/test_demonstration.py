"""The datasheets that a demonstration puts into its data folder."""

from pathlib import Path

from app.formats.datasheets.arm import read_arm
from app.formats.datasheets.sensor import read_sensor
from app.formats.datasheets.target import read_object
from app.metrology.targets.chessboard import Chessboard
from app.metrology.targets.crenellated_block import Crenellated
from app.server.demo import write_datasheets
from hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.refusals import refused_as

CONFIG = SimulationConfig(width_px=640, height_px=512)


def test_block_and_board_stand_side_by_side(tmp_path: Path) -> None:
    simulation = SimulatedStation(CONFIG)
    write_datasheets(simulation, tmp_path)
    assert isinstance(read_object(tmp_path / "objects/simulated.json"), Crenellated)
    board = read_object(tmp_path / "objects/chessboard.json")
    assert isinstance(board, Chessboard)
    assert (board.name, board.serial_number) == ("Simulated chessboard", "TWIN-C1")
    assert board.inner_corners == simulation.config.board.inner_corners
    assert board.square_mm == simulation.config.board.square_x_mm
    assert board.standard_uncertainty_mm == simulation.config.certificate_sd_mm
    assert read_arm(tmp_path / "arms/simulated.json").name == simulation.config.arm.name
    assert read_sensor(tmp_path / "sensors/simulated.json").width_px == 640
    gauges = {path.name for path in (tmp_path / "gauges").iterdir()}
    nominals = {f"{name}.nominal.json" for name in ("plate", "sphere", "surface-plate")}
    assert gauges == nominals | {"step-gauge.json", "ball-bar.json"}


def test_a_folder_that_cannot_be_written_is_refused_with_a_remedy(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with refused_as("data-folder-unwritable", "--data"):
        write_datasheets(SimulatedStation(CONFIG), tmp_path / "file" / "data")
