"""What the version of commit c166f23 wrote is opened, shown and worked with.

The archive is the data folder of that version's demonstration: a calibration from three poses,
accepted; a scan of two seconds; and a verification that was left open at its touch step.
"""

import shutil
import tarfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from crenel.formats.clouds.files import read_cloud
from crenel.formats.results.calibration import read_calibration
from tests.api.conftest import Server, running_server
from tests.cli.test_cli import done
from tests.gauges.quick.test_flow import VerifyDesk

pytestmark = pytest.mark.device

ARCHIVE = Path(__file__).parent / "station-c166f23.tar.xz"
CALIBRATION, SCAN, VERIFICATION = "20261125-130750-769f", "20261125-130843", "20261125-130847-bdb4"


@pytest.fixture(scope="module")
def earlier(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The data folder as that version left it."""
    folder = tmp_path_factory.mktemp("earlier")
    with tarfile.open(ARCHIVE) as archive:
        archive.extractall(folder, filter="data")
    return folder


@pytest.fixture(scope="module")
def station(earlier: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """This version on a copy of it."""
    data = shutil.copytree(earlier, tmp_path_factory.mktemp("station") / "data")
    with running_server(data) as server:
        yield server


def test_everything_that_was_kept_is_listed_and_healthy(station: Server) -> None:
    (calibration,) = station.http.get("/api/calibrations").json()
    (scan,) = station.http.get("/api/scans").json()
    assert (calibration["id"], scan["id"]) == (CALIBRATION, SCAN)
    assert (scan["points"], scan["calibration_id"], scan["note"]) == (65226, CALIBRATION, "")
    assert station.http.get("/api/home").json()["calibration"]["id"] == CALIBRATION
    health = station.http.get("/api/health").json()["health"]
    assert not [item for item in health["items"] if item["quality"] == "bad"]


def test_its_reports_pictures_and_clouds_are_served(station: Server) -> None:
    files = ("report.html", "report.pdf", "calibration.json", "image/capture-1-laser.png")
    paths = (f"calibrations/{CALIBRATION}/{name}" for name in files)
    for path in (*paths, f"scans/{SCAN}/cloud.ply"):
        answer = station.http.get(f"/api/{path}")
        assert (path, answer.status_code) == (path, 200)
        assert len(answer.content) > 1000


def test_the_session_that_was_open_goes_on(station: Server) -> None:
    desk = VerifyDesk(station)
    view = desk.view()
    assert (view["session_id"], view["step"]) == (VERIFICATION, "touch")
    desk.do("run_simulation")
    assert desk.wait(lambda view: view["step"] != "touch")["step"] == "scan"


def test_its_session_calibrates_to_the_same_figures(earlier: Path, tmp_path: Path) -> None:
    folder = earlier / "sessions" / CALIBRATION
    before = read_calibration(folder / "calibration.json")
    done("calibrate", folder, "-o", tmp_path / "calibration.json")
    now = read_calibration(tmp_path / "calibration.json")
    np.testing.assert_allclose(now.T_flange_sensor, before.T_flange_sensor, atol=0.02)


def test_its_recording_is_rebuilt_with_its_calibration(earlier: Path, tmp_path: Path) -> None:
    folder, scan = earlier / "sessions" / CALIBRATION, earlier / "scans" / SCAN
    used = ("--calibration", folder / "calibration.json", "--arm", folder / "arm.json")
    done("reconstruct", scan / "scan.mcap", *used, "-o", tmp_path / "cloud.ply")
    now = read_cloud(tmp_path / "cloud.ply").points_mm
    before = read_cloud(scan / "cloud.ply").points_mm
    assert len(now) == len(before) == 65226
    assert np.abs(now - before).max() < 0.001
