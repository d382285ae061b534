"""A simulated robot that carries the sensor, by RTDE: calibrated, scanned, verified, rebuilt."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crenel.formats.clouds.files import read_cloud
from crenel.formats.clouds.points import Cloud
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.results.calibration import read_calibration
from crenel.metrology.transforms import Floats
from crenel.server import demo
from crenel.workflows.reconstruct import Reconstruction, reconstruct_points
from tests.api.conftest import Server, running_server, wait_for
from tests.bench.faults.served import HALF
from tests.gauges.quick.test_flow import VerifyDesk

pytestmark = pytest.mark.device


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(demo, "ROBOT_HZ", 125.0)  # as of older controllers: half the work
        with running_server(
            tmp_path_factory.mktemp("robot"),
            replace(HALF, arm=demo.ROBOT.arm, robot=demo.ROBOT.robot),
        ) as server:
            yield server
    assert not server.sent.untranslated()


@pytest.fixture(scope="module")
def calibrated(server: Server) -> Server:
    """By the simulated operator, from the first step to the accepted calibration."""
    server.http.post("/api/flow/start")
    server.wait(lambda view: any(a["name"] == "confirm_devices" for a in view["actions"]))
    server.do("confirm_devices")
    view = server.flow()
    chosen = {each["field"]: each["selected"] for each in view["picture"]["choices"]}
    assert chosen == {"arm": "simulated", "object": "chessboard", "sensor": "simulated"}
    server.do("confirm_setup")
    assert server.flow()["step"] == "place"  # it has no tip, and touches nothing
    view = server.simulate_up_to_review()
    assert view["picture"]["result"]["verdict"] in ("good", "attention"), view["findings"]
    server.do("accept")
    return server


def test_a_block_is_refused_for_an_arm_that_reports_poses(server: Server) -> None:
    server.http.post("/api/flow/start")
    server.do("confirm_devices")
    server.do("choose", field="object", id="simulated")
    refusal = server.command("confirm_setup")
    assert refusal.status_code == 422
    assert "chessboard" in refusal.text
    server.do("choose", field="object", id="chessboard")
    server.do("back", to="devices")


def distances_from_plate_um(server: Server, points_mm: Floats) -> Floats:
    """Of points (N, 3) near the plate, from the plane of its certificate."""
    nominal = json.loads((server.data / "gauges/plate.nominal.json").read_text())
    away_mm = points_mm - np.array(nominal["point_mm"])
    return np.asarray(1e3 * away_mm @ np.array(nominal["normal"]))


def stated_um(session: Path) -> float:
    """Standard uncertainty of a scanned point, as the calibration states it."""
    document = json.loads((session / "calibration.json").read_text())
    return float(document["uncertainty"]["total_um"])


def scan_plate(server: Server, session: Path) -> tuple[Cloud, Reconstruction]:
    """The cloud of a scan of the plate, which its recording is rebuilt to, and the rebuild's
    counts."""
    http = server.http
    assert http.post("/api/scan/start", json={"name": "Plate"}).json()["state"] == "running"
    assert server.simulation.operator.scan_part("plate")
    http.post("/api/stop")
    scans = wait_for(lambda: http.get("/api/scans").json(), bool)
    folder = server.data / "scans" / scans[0]["id"]
    live = read_cloud(folder / "cloud.ply")
    assert len(live.points_mm) == scans[0]["points"] > 1000
    again, counts = reconstruct_points(
        folder / "scan.mcap",
        read_calibration(session / "calibration.json"),
        read_any_arm(session / "arm.json"),
        allow_incomplete=True,
    )
    np.testing.assert_allclose(again, live.points_mm, atol=1e-4)
    return live, counts


def test_a_scan_is_rebuilt_to_the_same_points(calibrated: Server, tmp_path: Path) -> None:
    session = next((calibrated.data / "sessions").glob("*/calibration.json")).parent
    live, counts = scan_plate(calibrated, session)
    # on a busy machine packets may be missing: live, too
    lacking = calibrated.http.get("/api/scan").json()["frames_without_joints"]
    assert counts.frames_without_joints == lacking
    off_um = distances_from_plate_um(calibrated, live.points_mm)
    near = np.abs(off_um) < 200
    assert near.sum() > 1000
    assert abs(np.median(off_um[near])) < 2 * stated_um(session)
    # k = 2 should hold 95 % of the points; but the robot's own model is off in every one of them
    assert live.uncertainty_um is not None
    expanded_um = 2 * np.hypot(stated_um(session), live.uncertainty_um[near])
    assert (np.abs(off_um[near]) < expanded_um).mean() > 0.8


def test_a_verification_needs_no_touches(calibrated: Server) -> None:
    desk = VerifyDesk(calibrated)
    calibrated.http.post("/api/verify/start").raise_for_status()
    desk.do("choose_gauge", id="plate")
    assert desk.do("confirm_gauge")["step"] == "scan"
    view = desk.simulate_up_to_review()
    assert len([one for one in view["picture"]["clouds"] if one["state"] == "good"]) == 3
    figures = {one["name"]: one for one in view["picture"]["figures"]}
    assert {"form", "rms", "angle_range"} <= set(figures)
    assert "offset" not in figures  # nothing was touched
    desk.do("accept")
