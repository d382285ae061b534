"""Journals in memory, contacts at will, and a station on which all is well."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.guide.arm.view import ArmView
from crenel.guide.calibration.flow import build_view
from crenel.guide.calibration.live import (
    CalibrationLive,
    ConnectedArm,
    ConnectedSensor,
    SelectedDatasheets,
)
from crenel.guide.calibration.outcome import from_payload
from crenel.guide.calibration.state import CalibrationState, apply_row
from crenel.guide.calibration.touch.report import touch_report
from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.guide.common.journal import fold
from crenel.guide.common.view import Action, FlowView
from crenel.metrology.arm.kinematics import Arm, Joint, Tip, geometric_jacobian, tip_centres
from crenel.metrology.targets.crenellated_block import Crenellated, probing_face
from crenel.metrology.targets.target import CalibrationTarget
from crenel.station.devices.link_state import DeviceState
from crenel.station.devices.stillness import Stillness

Row = tuple[str, Mapping[str, object]]
"""Kind and payload of a row of a journal."""
CHOICES = {"arm": "a", "object": "b", "sensor": "s"}
_SHAPE = [(0, -90, 280), (450, 0, 0), (60, -90, 0), (0, 90, 400), (0, -90, 0), (0, 0, 90)]
ARM = Arm(
    "test arm",
    "A-1",
    tuple(
        Joint(f"J{i + 1}", a, np.radians(alpha), d, 0.0, encoder_sd_rad=1e-5)
        for i, (a, alpha, d) in enumerate(_SHAPE)
    ),
    Tip(0.0, 0.0, 120.0, 6.0),
)
"""Of six axes, with a long reach."""
_EDGES_MM = (-22.0, -14.0, -7.0, -2.0, 5.0, 10.0, 17.0, 22.0)
BLOCK = Crenellated("block", "B-1", _EDGES_MM, -12.0, 12.0, 15.0, 0.0, -12.0, 0.002)


@dataclass(frozen=True)
class FakeRow:
    number: int
    kind: str
    payload: Mapping[str, object]
    session_id: str = "s1"
    at: str = "2026-01-01T00:00:00Z"


def journal_of(*rows: Row) -> list[FakeRow]:
    """A journal with these rows, after passing through JSON as on the disk."""
    return [FakeRow(i + 1, kind, json.loads(json.dumps(p))) for i, (kind, p) in enumerate(rows)]


def state_after(*rows: Row) -> CalibrationState:
    """The state that rows lead to."""
    return fold(journal_of(*rows), CalibrationState(), apply_row)


def start_row(step: str = "devices") -> Row:
    return "started", {"choices": CHOICES, "step": step}


def point_row(face: str, q_rad: ArrayLike = (0.0,) * 6) -> Row:
    return "point_taken", {"face": face, "q_rad": [float(q) for q in np.ravel(q_rad)]}


def capture_row(**changes: object) -> Row:
    payload: dict[str, object] = {
        "ambient": "images/capture-1-ambient.png",
        "laser": "images/capture-1-laser.png",
        "q_rad": [0.0] * 6,
        "width_px": 1280,
        "height_px": 1024,
        "outcome": {"corners": [], "outline": [], "stripe": [], "findings": [], "result": None},
    }
    return "image_captured", {**payload, **changes}


def reach_tip(arm: Arm, target_mm: np.ndarray, q_rad: np.ndarray) -> np.ndarray:
    """Angles that bring the tip's centre to a target, by Gauss-Newton from a start."""
    q = q_rad.copy()
    for _ in range(60):
        off = target_mm - tip_centres(arm, q[None])[0]
        if np.linalg.norm(off) < 1e-9:
            return q
        J = geometric_jacobian(arm, q, arm.tip.centre_mm)[:3]
        step = np.linalg.pinv(J) @ off
        q = q + step * min(1.0, 0.2 / float(np.abs(step).max()))
    raise AssertionError("the tip cannot get there")


REST_RAD = np.radians([10.0, -40.0, 60.0, 20.0, 35.0, -15.0])


def contact_joints(arm: Arm, block: Crenellated, face: str, place_mm: object) -> np.ndarray:
    """Angles with the tip in contact with a place (3,) on a face; the block stands unturned
    in front of the arm."""
    origin = tip_centres(arm, REST_RAD[None])[0]
    normal, _ = probing_face(block, face)
    target = origin + np.asarray(place_mm) + arm.tip.radius_mm * normal
    return reach_tip(arm, target, REST_RAD)


CONNECTED = DeviceState("Arm", "connected", "good", "test device", 0.01, 1000.0, 10, 0, 0)
SENSOR = SensorDatasheet(
    name="sensor", serial_number="S-1", width_px=1280, height_px=1024, stripe_axis="u"
)


def make_live(
    state: CalibrationState,
    item: CalibrationTarget | None = BLOCK,
    arm: Arm | None = ARM,
    **changes: Any,
) -> CalibrationLive:
    """A station on which all is well, changed where a test says so."""
    report = touch_report(state.counted, arm, item, 15.0) if arm and item else None
    live = CalibrationLive(
        rev=state.rev,
        arm_link=CONNECTED,
        sensor_link=replace(CONNECTED, title="Sensor"),
        arm=ConnectedArm("A-1", 6, "joints"),
        sensor=ConnectedSensor("S-1", 1280, 1024),
        stillness=Stillness(True, 2.0, 1.0, "Still"),
        library=DatasheetLibrary({}, {}, {}, ()),
        chosen=SelectedDatasheets(arm, item, SENSOR if arm else None),
        touch=report,
        laser_on=False,
        corners_detected=20,
        picture_findings=(),
        latest_outcome=None,
        capture_outcomes={c.number: from_payload(c.outcome) for c in state.captures},
        advice=None,
        to_move=None,
        scanning=False,
        tip=None,
        has_simulation=False,
        busy=None,
        simulation_running=False,
        taking_poses=False,
        trouble=None,
    )
    return replace(live, **changes)


def view_of(
    state: CalibrationState, item: CalibrationTarget | None = BLOCK, **changes: Any
) -> FlowView:
    """The view on a station on which all is well, changed where a test says so."""
    return build_view(state, make_live(state, item, **changes))


def action(view: FlowView | ArmView, name: str) -> Action:
    return next(action for action in view.actions if action.name == name)
