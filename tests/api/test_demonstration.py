"""A demonstration: the datasheets in its data folder, and the button that does everything."""

from pathlib import Path

import httpx
import pytest

from crenel.formats.datasheets.arm import read_arm
from crenel.formats.datasheets.sensor import read_sensor
from crenel.formats.datasheets.target import read_object
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.operations import demonstration
from crenel.server.demo import write_datasheets
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig
from tests.api.conftest import Server, until, wait_for
from tests.entering import enter
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


@pytest.mark.device
def test_one_request_goes_up_to_a_cloud(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    """A bystander stops it where it would accept; it begins again there, and a person accepts."""
    monkeypatch.setattr(demonstration, "SCAN_S", 1)
    monkeypatch.setattr(demonstration, "ACCEPT_S", 100)
    running = server.context.demonstration
    _begin_up_to_the_decision(server)
    with httpx.Client(base_url=server.address) as bystander:
        enter(bystander, server.context.authenticator.code)
        bystander.post("/api/demonstration/stop").raise_for_status()
    until(lambda: not running.state.running)
    assert (server.view()["step"], server.view()["running"]) == ("review", True)

    _begin_up_to_the_decision(server)
    server.do("accept")
    wait_for(lambda: running.state.page, "scan".__eq__)
    until(lambda: not running.state.running)
    scan = server.http.get("/api/scan").json()
    assert (scan["state"], scan["points"] > 1000) == ("idle", True)
    newest = server.context.store.scans.newest()
    assert newest is not None
    assert newest.points == scan["points"]
    assert server.http.get("/api/activity").json()["activity"] is None


def _begin_up_to_the_decision(server: Server) -> None:
    """A busy machine loses a device for a moment: then it is begun again."""
    running = server.context.demonstration

    def is_over() -> bool:
        return not running.state.running or running.state.decides_in_s is not None

    for _ in range(5):
        server.http.post("/api/demonstration").raise_for_status()
        while not is_over():
            rev = server.view()["rev"]
            until(lambda: is_over() or server.view()["rev"] != rev)  # noqa: B023
        if running.state.running:
            assert running.state.page == "calibrate"
            return
    raise AssertionError("it never came to the decision")
