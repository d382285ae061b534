"""``crenel design``."""

from pathlib import Path

from crenel.formats.datasheets.target import read_block, read_object
from crenel.metrology.targets.chessboard import Chessboard
from tests.cli.test_cli import done, printed, refused

NUMBERS = ("--field-of-view", 55, "--depth-of-field", 20)


def test_a_block_is_designed_with_its_files(tmp_path: Path) -> None:
    made = printed(
        *("design", "block", *NUMBERS, "--standoff", 115, "--pixels", "1280x1024"),
        *("--width", 40.5, "--groove-depth", 12, "--tolerance", 0.03, "-o", tmp_path),
    )
    assert {Path(name).name for name in made["files"]} == {
        "object.json",
        "block.step",
        "block.stl",
        "block.pdf",
        "block.dxf",
    }
    block = read_block(tmp_path / "object.json")
    assert list(block.edges_x_mm) == made["object"]["edges_x_mm"]
    assert block.edges_x_mm[-1] - block.edges_x_mm[0] == 40.5
    assert (block.crest_z_mm, made["tolerance_mm"]) == (12.0, 0.03)
    assert 0 < made["eight_poses_um"] < made["one_pose_um"]
    assert made["mirror_difference_mm"] > 1.0


def test_what_is_missing_of_the_sensor_is_named(tmp_path: Path) -> None:
    said = refused("design", "block", *NUMBERS, "-o", tmp_path / "block")
    assert "stand-off" in said
    numbers = (*NUMBERS, "--standoff", 115, "--pixels", "1280x1024", "-o", tmp_path / "block")
    assert "mirror image" in refused("design", "block", *numbers, "--width", 30, "--merlons", 9)
    assert not (tmp_path / "block").exists()


def test_a_board_is_made_and_its_file_follows_from_two_measured_lengths(tmp_path: Path) -> None:
    board = ("design", "board", "charuco", "--squares", "11x8", "--square", 20, "-o", tmp_path)
    assert len(printed(*board)["files"]) == 2
    second = printed(*board, "--first-id", 44)["object"]
    assert (second["first_id"], second["dictionary"]) == (44, "DICT_4X4_100")
    printed(*board, "--measured-x", 219.78, "--measured-y", 159.84)
    found = read_object(tmp_path / "object.json")
    assert isinstance(found, Chessboard)
    assert found.square_mm == 19.98
    said = refused(*board[:-2], "-o", tmp_path / "other", "--measured-x", 200, "--measured-y", 100)
    assert "100.0 mm was measured where 160.0 mm" in said
    assert "one length" in refused(*board[:-2], "-o", tmp_path / "other", "--measured-x", 219)
    assert not (tmp_path / "other").exists()


def test_a_board_that_fits_on_no_page_is_refused(tmp_path: Path) -> None:
    said = refused(
        "design", "board", "chessboard", "--squares", "40x40", "--square", 50, "-o", tmp_path / "b"
    )
    assert "A0" in said
    small = ("design", "board", "chessboard", "--squares", "11x8", "--square", 20)
    assert "does not fit on letter" in refused(*small, "--page", "Letter", "-o", tmp_path / "b")
    assert "Give one of A4" in refused(*small, "--page", "B5", "-o", tmp_path / "b")
    assert not (tmp_path / "b").exists()


def test_help_names_the_designs() -> None:
    said = done("design", "--help").output
    assert "block" in said
    assert "board" in said
