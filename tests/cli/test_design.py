"""``crenel design``."""

from pathlib import Path

from app.formats.datasheets.target import read_block
from tests.cli.test_cli import done, printed, refused

NUMBERS = ("--field-of-view", 55, "--depth-of-field", 20)


def test_a_block_is_designed_with_its_files(tmp_path: Path) -> None:
    made = printed(
        "design", "block", *NUMBERS, "--standoff", 115, "--pixels", "1280x1024", "-o", tmp_path
    )
    assert {Path(name).name for name in made["files"]} == {
        "object.json",
        "block.stl",
        "block.pdf",
        "block.dxf",
    }
    block = read_block(tmp_path / "object.json")
    assert list(block.edges_x_mm) == made["object"]["edges_x_mm"]
    assert 0 < made["eight_poses_um"] < made["one_pose_um"]
    assert made["mirror_difference_mm"] > 1.0


def test_what_is_missing_of_the_sensor_is_named(tmp_path: Path) -> None:
    said = refused("design", "block", *NUMBERS, "-o", tmp_path / "block")
    assert "stand-off" in said
    assert not (tmp_path / "block").exists()


def test_help_names_the_designs() -> None:
    assert "block" in done("design", "--help").output
