"""``crenel drift`` over archives: what moved, and what was only calibrated again."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import least_squares
from typer.testing import CliRunner

pytest.importorskip("distributed")

from crenel.batch.drift import GaugeDrift, figures_of, find_drifts, quantity_of
from crenel.batch.places import find_places, settings_for
from crenel.batch.recordings import Selection
from crenel.batch.task import perform
from crenel.batch.verifications import VerificationTask, plan_verifications
from crenel.cli.main import cli
from crenel.errors import OperationError
from crenel.formats.session.calibration_session import ContactReadings, write_contacts
from crenel.metrology.arm.kinematics import flange_pose, tip_centres, tip_of
from crenel.metrology.transforms import Floats, apply
from tests.batch.filled import CALIBRATION, archive_and_close, fill_station
from tests.batch.test_rebuild import run
from tests.batch.test_verifications import OTHER, add_calibration, add_verification
from tests.formats.builders import ARM, little_calibration, q_at
from tests.gauges.quick.test_repeatability import NORMAL
from tests.workflows.test_reconstruct import MS

pytestmark = pytest.mark.device

DAYS = range(1, 9)
CHANGED = 5
"""The first day of what is different."""
Z_ERROR = quantity_of("gauge-z-error")


def touch_plane() -> Floats:
    """(5, 6) joint angles at which the tip touches the plane that is scanned."""
    use = little_calibration()
    start = q_at(200 * MS)
    middle = apply(flange_pose(ARM, start) @ use.T_flange_sensor, np.zeros((1, 3)))[0]
    along = np.cross(NORMAL, [1.0, 0.0, 0.0])
    across = np.cross(NORMAL, along)
    height = tip_of(ARM).radius_mm * NORMAL
    corners = ((0, 0), (-20, -15), (20, -15), (20, 15), (-20, 15))
    targets = [middle + height + u * along + v * across for u, v in corners]
    found = []
    for target in targets:
        solved = least_squares(lambda q, at=target: tip_centres(ARM, q[None])[0] - at, start)
        assert solved.cost < 1e-8
        found.append(solved.x)
    return np.array(found)


def fill(tmp_path: Path, moved_mm: float, recalibrated: bool, touched: bool = True) -> Path:
    """An archive of a station with a scan and a verification on each day. From the day ``CHANGED``
    on the gauge lies lower for the sensor than for the probe, and another calibration may be in
    use."""
    place = tmp_path / "room-2"
    store = fill_station(tmp_path / "data", [f"scan-{day}" for day in DAYS])
    add_calibration(store, OTHER)
    readings = touch_plane()
    for day in DAYS:
        later = day >= CHANGED
        used = OTHER if later and recalibrated else CALIBRATION
        offset_mm = 0.001 * (day % 2) + (moved_mm if later else 0.0)
        at = f"2026-05-0{day}T12:00:00Z"
        folder = add_verification(store, f"v{day}", at, offset_mm, used, clouds=1)
        if touched:
            contacts = ContactReadings(("gauge",) * len(readings), readings)
            write_contacts(folder / "touches.csv", contacts)
        scan = tmp_path / f"data/scans/scan-{day}/scan.mcap"
        scan.write_bytes(scan.read_bytes().replace(CALIBRATION.encode(), used.encode()))
    archive_and_close(store, place)
    return place


def measure(place: Path, tmp_path: Path, calibration: str = "") -> list[GaugeDrift]:
    places = find_places([str(place)])
    given: Any = "own"
    if calibration:
        from crenel.batch.calibrations import CalibrationFinder

        given = (CalibrationFinder(places).find(calibration),)
    output = settings_for(str(tmp_path))
    tasks, refused = plan_verifications(places, Selection(), output, given, "plane")
    assert refused == []
    figures, untouched = figures_of(Z_ERROR, [(one, study(one, tmp_path)) for one in tasks])
    assert untouched == []
    return find_drifts(places, figures)


def study(task: VerificationTask, tmp_path: Path) -> Any:
    outcome = perform(task, tmp_path, 1)
    assert outcome.refusal is None
    return outcome.result


def scans_from(day: int) -> list[str]:
    return [f"scan-{one}" for one in DAYS if one >= day]


def test_a_sensor_that_moved_is_found_with_one_calibration_for_all(tmp_path: Path) -> None:
    (drift,) = measure(fill(tmp_path, moved_mm=0.05, recalibrated=False), tmp_path, CALIBRATION)
    assert (drift.station, len(drift.figures)) == ("room-2", len(DAYS))
    (found,) = drift.affected
    assert abs(found.period.size) == pytest.approx(50, rel=0.1)
    assert found.period.ended is None
    assert found.calibration_ids == ()
    # the last verification before was at noon of day 4, and the scan of day 5 in the morning
    assert [one.id for one in found.recordings] == scans_from(CHANGED + 1)
    assert [one.id for one in found.possible] == [f"scan-{CHANGED}"]


def test_a_change_by_another_calibration_is_none_with_one_for_all(tmp_path: Path) -> None:
    place = fill(tmp_path, moved_mm=0.0, recalibrated=True)
    (drift,) = measure(place, tmp_path)
    (found,) = drift.affected
    assert found.calibration_ids == (OTHER,)
    assert [one.id for one in found.recordings] == scans_from(CHANGED)
    (same,) = measure(place, tmp_path, CALIBRATION)
    assert same.affected == ()


def test_a_gauge_that_was_not_touched_has_no_height(tmp_path: Path) -> None:
    place = fill(tmp_path, moved_mm=0.05, recalibrated=False, touched=False)
    output = settings_for(str(tmp_path))
    tasks, _ = plan_verifications(find_places([str(place)]), Selection(), output, "own")
    studies = [(one, study(one, tmp_path)) for one in tasks[:2]]
    figures, untouched = figures_of(Z_ERROR, studies)
    assert (figures, untouched) == ({}, ["room-2/v1", "room-2/v2"])
    of_rms, untouched = figures_of(quantity_of("gauge-rms"), studies)
    assert (len(of_rms["room-2"]), untouched) == (2, [])


def test_workers_need_something_to_measure() -> None:
    refused = CliRunner().invoke(cli, ["drift", "gauge-z-error", "--workers", "2"])
    assert refused.exit_code == 2
    assert "needs archives or data folders, too" in refused.output


def test_only_figures_that_can_be_measured_again_are_taken() -> None:
    with pytest.raises(OperationError, match="no figure of a verification"):
        quantity_of("location-scan")


def test_the_command_measures_once_and_names_what_is_affected(tmp_path: Path) -> None:
    place = fill(tmp_path, moved_mm=0.05, recalibrated=False)
    args = ("drift", "gauge-z-error", place, "--calibration", CALIBRATION, "--workers", 1)
    found = run(*args, "-o", "out", cwd=tmp_path)
    assert (found["made"], found["refused"], found["without_touches"]) == (len(DAYS), {}, [])
    (station,) = found["stations"]
    (period,) = station["periods"]
    assert period["recordings"] == scans_from(CHANGED + 1)
    again = run(*args, "-o", "out", "--until", "2026-05-04", cwd=tmp_path)
    assert (again["made"], again["already_there"]) == (0, 3)
    assert again["stations"][0]["periods"] == []
