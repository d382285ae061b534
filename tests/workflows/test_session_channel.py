"""Sessions of colour cameras: what of their pictures is measured, and in whose pixels."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.datasheets.sensor import SelectedPart, SensorDatasheet
from crenel.formats.session.calibration_session import BoardSession, read_any_session
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.metrology.bayer import BayerPattern, BayerPlane
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.colour import PLANES, ColourWeights
from crenel.metrology.transforms import Floats
from crenel.workflows.calibrate import (
    board_inputs,
    calibrate_session,
    calibration_origin,
    session_channel,
)
from tests.colours import mosaic
from tests.formats.builders import edit_json
from tests.present import present
from tests.real_sessions import write_real_session

pytestmark = pytest.mark.slow
PATTERN: BayerPattern = "GBRG"
LASER = {"blue": 0.05, "green": 0.3, "red": 1.0}


@pytest.fixture
def session(real: Path, tmp_path: Path) -> Path:
    return write_real_session(real / "robot-laser-chessboard" / "calib3", tmp_path / "session")


def seen_colours(path: Path) -> Floats:
    """(height, width, 3) of a grey picture's light, of which each channel sees its share."""
    grey = present(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE))
    return np.asarray(grey[..., None] * np.array([LASER[name] for name in PLANES]))


def colour_pictures(folder: Path) -> dict[Path, NDArray[np.uint8]]:
    """The session's pictures as a camera takes them whose channels see less of the light."""
    coloured = {}
    for path in sorted((folder / "images").glob("*.png")):
        coloured[path] = np.rint(seen_colours(path)).astype(np.uint8)
    return coloured


def state(folder: Path, **fields: object) -> None:
    sensor = SensorDatasheet.read(folder / "sensor.json")
    sensor.model_copy(update=fields).write(folder / "sensor.json")


def read_session(folder: Path) -> BoardSession:
    session = read_any_session(folder)
    assert isinstance(session, BoardSession)
    return session


def numbered(found: BoardDetection) -> Iterator[tuple[int, Floats]]:
    return zip(map(int, found.number), found.uv_px, strict=True)


def test_raw_pictures_are_calibrated_in_their_own_pixels(session: Path) -> None:
    whole = read_session(session)
    few = replace(whole, poses=whole.poses[:3])
    expected = board_inputs(few).observations
    for path, colours in colour_pictures(session).items():
        cv2.imwrite(str(path), mosaic(colours, PATTERN))
    state(session, bayer=PATTERN, laser_wavelength_nm=660.0)
    raw = read_session(session)
    assert session_channel(raw) == BayerPlane(PATTERN, "red")
    seen = board_inputs(replace(raw, poses=raw.poses[:3])).observations
    for one, other in zip(seen, expected, strict=True):
        at = dict(numbered(other.detection))
        off = [uv - at[number] for number, uv in numbered(one.detection)]
        assert float(np.abs(np.median(off, axis=0)).max()) < 0.05
        assert len(off) == len(at)
        assert one.stripe.v.max() > 900
        rows = np.interp(one.stripe.v, other.stripe.v, other.stripe.u)
        assert abs(float(np.median(one.stripe.u - rows))) < 0.15
    with pytest.raises(OperationError, match="not sufficient"):
        calibrate_session(session, session.parent / "c.json", method="one-pose")


def test_a_raw_picture_needs_the_lasers_colour(session: Path) -> None:
    for pattern, said in (("RGGB", "bayer requires laser_wavelength_nm"), ("RGBG", "bayer")):
        edit_json(session / "sensor.json", partial(dict.update, bayer=pattern))
        with pytest.raises(OperationError, match=said):
            read_any_session(session)


def test_weights_are_found_where_no_colour_is_stated(samples: Path, tmp_path: Path) -> None:
    """From the first pose with a picture of each kind."""
    session = read_any_session(samples / "one-pose")
    assert session_channel(session) == "red"
    sensor = session.sensor.model_copy(update={"laser_wavelength_nm": None})
    unstated = replace(session, sensor=sensor)
    assert session_channel(unstated) is None
    files = []
    rng = np.random.default_rng(0)
    for path in session.poses[0].files:
        colours = seen_colours(path)
        noisy = np.clip(np.rint(colours + rng.normal(0, 2, colours.shape)), 0, 255)
        files.append(tmp_path / path.name)
        cv2.imwrite(str(files[-1]), noisy.astype(np.uint8))
    pose = replace(session.poses[0], ambient=files[0], laser=files[1])
    weights = session_channel(replace(unstated, poses=(pose,)))
    assert isinstance(weights, ColourWeights)
    assert weights.red > 2 * weights.green > 4 * weights.blue


def test_a_station_states_what_of_a_colour_camera_it_took(session: Path) -> None:
    """Its pictures are grey, and measured as such; so does ``crenel calibrate`` afterwards."""
    folder, unchanged = SessionFolder(session), (session / "sensor.json").read_bytes()
    for selected, text in (
        (SelectedPart(colour="red", bayer="GRBG"), "red pixels of GRBG"),
        (SelectedPart(colour="green"), "green"),
        (None, "grey"),
    ):
        folder.keep_selected(selected)
        found = read_session(session)
        assert session_channel(found) is None
        assert str(calibration_origin(found, found.poses[:1], "").channel) == text
    folder.keep_selected(None)
    assert read_session(session).sensor == SensorDatasheet.model_validate_json(unchanged)
