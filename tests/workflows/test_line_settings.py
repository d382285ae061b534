"""What is set of the line counts in calibrations, by options and by ``line.json``."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import read_session
from crenel.formats.settings.line_settings import LineSettings, SessionLine
from crenel.formats.settings.mask import Mask
from crenel.metrology.stripe import StripeSettings
from crenel.workflows.calibrate import calibration_origin, joint_inputs
from tests.cli.test_cli import refused

pytestmark = pytest.mark.slow


@pytest.fixture
def session(samples: Path, tmp_path: Path) -> Path:
    folder = tmp_path / "session"
    shutil.copytree(samples / "one-pose", folder)
    return folder


def left_half(width_px: int, height_px: int) -> Mask:
    half = width_px / 2
    zone = ((0, 0), (half, 0), (half, height_px), (0, height_px))
    return Mask(width_px=width_px, height_px=height_px, zones=(zone,))


def test_zones_of_the_sessions_folder_are_left_out(session: Path) -> None:
    whole = read_session(session)
    assert whole.line.is_automatic
    mask = left_half(whole.sensor.width_px, whole.sensor.height_px)
    SessionLine(threshold=2.0, mask=mask).write(session / "line.json")
    masked = read_session(session)
    (before,), (after,) = (joint_inputs(one).observations for one in (whole, masked))
    assert before.stripe.u.min() < mask.width_px / 2 - 50
    assert after.stripe.u.min() >= mask.width_px / 2
    right = before.stripe.u > mask.width_px / 2 + 50
    assert np.isin(before.stripe.u[right], after.stripe.u).mean() > 0.95
    origin = calibration_origin(masked, masked.poses, "")
    assert json.loads(origin.extraction) == {"threshold": 2.0, "mask": mask.fields()}
    assert "line.json" in [one.file for one in origin.inputs]


def test_zones_of_another_picture_exclude_the_pose(session: Path) -> None:
    found = replace(read_session(session), line=LineSettings(mask=left_half(64, 48)))
    (failed,) = joint_inputs(found).failed_poses
    assert failed.error.code == "mask-size"


def test_options_of_the_line_replace_the_sessions(session: Path) -> None:
    SessionLine(threshold=2.0).write(session / "line.json")
    said = refused(
        "calibrate", session, "-o", session / "c.json", "--min-width", 9, "--max-width", 2
    )
    assert "width" in said
    with pytest.raises(OperationError) as caught:
        SessionLine.read(session / "object.json")
    assert caught.value.code
    blind = replace(read_session(session), line=LineSettings(StripeSettings(threshold=250.0)))
    (seen,) = joint_inputs(blind).observations
    assert not len(seen.stripe.u)
