"""A damaged picture excludes its own pose, and is named: the session is not lost for it."""

from pathlib import Path

import pytest

from crenel.formats.session.calibration_session import read_session
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.workflows.calibrate import calibration_origin, joint_inputs
from tests.formats.builders import write_session
from tests.refusals import refused_as


def damage(path: Path) -> None:
    """Changes one byte of the picture's data, behind its header."""
    raw = bytearray(path.read_bytes())
    raw[len(raw) // 2] ^= 0xFF
    path.write_bytes(raw)


@pytest.mark.parametrize("name", ["a", "l"])
def test_a_damaged_picture_of_a_block_is_a_failed_pose(tmp_path: Path, name: str) -> None:
    folder = write_session(tmp_path / "s")
    damage(folder / f"images/{name}.png")
    session = read_session(folder)
    inputs = joint_inputs(session)
    assert not inputs.observations
    (failed,) = inputs.failed_poses
    assert failed.error.code == "image-damaged"
    assert f"{name}.png" in failed.error.line
    with refused_as("image-damaged"):  # there is no other pose
        calibrate_block(inputs)
    assert calibration_origin(session, session.poses, "").inputs
