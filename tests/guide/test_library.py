"""What the station knows: what can be chosen, by certificates too, and what is said of all else."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.guide.calibration.live import ConnectedArm
from crenel.guide.calibration.session_datasheets import best_guess, guess_for_connected
from crenel.guide.calibration.state import CalibrationState
from crenel.guide.common.datasheet_library import DatasheetLibrary, read_gauges, read_library
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated
from tests.datasheets import write_object
from tests.gauges.exchange.certificates import DIAMETER, FORM, certificate, quantity, real
from tests.guide.builders import BLOCK

BOARD = Chessboard("board 7", "", (7, 6), 10.0, 0.05)
SPHERE = certificate(DIAMETER, FORM)
BARE = certificate(quantity("Diameter", real("25", "\\milli\\metre")))


def library_with(folder: Path, **objects: Crenellated | Chessboard) -> DatasheetLibrary:
    (folder / "objects").mkdir()
    for name, item in objects.items():
        write_object(folder / "objects" / f"{name}.json", item)
    return read_library(folder)


def test_blocks_and_chessboards_can_be_chosen_and_damaged_files_are_named(tmp_path: Path) -> None:
    library_with(tmp_path, block=BLOCK, board=BOARD)
    (tmp_path / "objects/damaged.json").write_text(json.dumps({"format": "crenel/object"}))
    library = read_library(tmp_path)
    known = {name: entry.datasheet for name, entry in library.objects.items()}
    assert known == {"block": BLOCK, "board": BOARD}
    (damaged,) = library.findings
    assert str(damaged.remedy) == "Correct or remove the file."


def test_the_only_block_is_guessed_beside_chessboards(tmp_path: Path) -> None:
    library = library_with(tmp_path, a_board=BOARD, block=BLOCK, other_board=BOARD)
    assert best_guess(library, CalibrationState(), None, None)["object"] == "block"
    before = CalibrationState(choices={"object": "other_board"})
    assert best_guess(library, before, None, None)["object"] == "other_board"


def test_of_several_chessboards_none_is_guessed(tmp_path: Path) -> None:
    library = library_with(tmp_path, one=BOARD, two=BOARD)
    assert "object" not in best_guess(library, CalibrationState(), None, None)


ROBOT = ConnectedArm("R-1", 6, "pose")


def test_an_arm_that_connects_late_has_its_own_choices(tmp_path: Path) -> None:
    """The session began with what an arm with joints would use."""
    library = library_with(tmp_path, block=BLOCK, board=BOARD)
    begun = CalibrationState(choices=best_guess(library, CalibrationState(), None, None))
    assert begun.choices["object"] == "block"
    assert guess_for_connected(library, begun, ROBOT, None) == {"object": "board"}
    assert guess_for_connected(library, begun, replace(ROBOT, reports="joints"), None) == {}
    chosen = CalibrationState(choices={"object": "board"})
    assert guess_for_connected(library, chosen, replace(ROBOT, reports="joints"), None) == {}
    assert guess_for_connected(library, CalibrationState(), ROBOT, None) == {"object": "board"}


def test_a_robot_is_guessed_no_block_that_was_chosen_last(tmp_path: Path) -> None:
    library = library_with(tmp_path, block=BLOCK, one=BOARD, two=BOARD)
    before = CalibrationState(choices={"object": "block"})
    assert "object" not in best_guess(library, before, ROBOT, None)


def test_a_sensor_of_raw_pictures_is_not_chosen_on_a_station(tmp_path: Path) -> None:
    """Its driver selects the pixels, so that the datasheet describes the picture of these."""
    fields = {"name": "S", "serial_number": "1", "width_px": 640, "height_px": 480}
    raw = {**fields, "stripe_axis": "u", "laser_wavelength_nm": 660.0, "bayer": "RGGB"}
    (tmp_path / "sensors").mkdir()
    SensorDatasheet.model_validate(raw).write(tmp_path / "sensors" / "raw.json")
    library = read_library(tmp_path)
    assert not library.sensors
    (finding,) = library.findings
    assert "bayer and laser_colour in [sensor] of station.toml" in str(finding.text)


def folder_with(data: Path, **certificates: str) -> Path:
    """A data folder with these certificates of gauges."""
    (data / "gauges").mkdir()
    for name, text in certificates.items():
        (data / f"gauges/{name}.xml").write_text(text)
    return data


def test_a_certificate_is_a_gauge_with_all_that_it_states(tmp_path: Path) -> None:
    entry = read_gauges(folder_with(tmp_path, k=SPHERE)).known["k"]
    gauge = entry.datasheet
    named = (gauge.name, gauge.serial_number, gauge.certificate)
    assert named == ("Ceramic sphere", "K-17", "4711-2026")
    assert gauge.valid_until == "2028-03-12"
    assert gauge.radius_mm == pytest.approx(12.5006)
    assert gauge.standard_uncertainty_um == pytest.approx(0.15)
    assert gauge.form_um == pytest.approx(0.08)
    assert gauge.form_sd_um == pytest.approx(0.025)


def test_a_certificate_without_uncertainty_is_listed_with_its_reason(tmp_path: Path) -> None:
    gauges = read_gauges(folder_with(tmp_path, bare=BARE))
    assert not gauges.known
    assert not gauges.findings
    (refused,) = gauges.refused
    assert refused.id == "bare"
    assert "has no uncertainty" in str(refused.reason)
    assert str(refused.reason).count(". ") == 0


def test_a_datasheet_counts_before_a_certificate_of_its_name(tmp_path: Path) -> None:
    folder_with(tmp_path, k=SPHERE)
    GaugeFile(shape="sphere", radius_mm=10.0, name="own").write(tmp_path / "gauges/k.nominal.json")
    assert read_gauges(tmp_path).known["k"].datasheet.name == "own"
