"""An arm session: its fold, the points that take themselves, and what is allowed when."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crenel.formats.session.arm_session import read_bars, write_observations
from crenel.guide.arm.flow import build_view
from crenel.guide.arm.observations import HOLD_NS, TURN_RAD, collect_observations, sample_points
from crenel.guide.arm.rules import LEAST, RULES
from crenel.guide.arm.state import ArmLive, ArmState, apply_row
from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.guide.common.journal import fold
from crenel.guide.common.view import Busy
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.station.devices.reading_buffer import ReadingWindow
from tests.guide.builders import ARM, CONNECTED, REST_RAD, Row, action, journal_of, reach_tip
from tests.present import present

MS = 1_000_000
SEAT_ENDED: Row = ("seat_ended", {})


def state_after(*rows: Row) -> ArmState:
    return fold(journal_of(*rows), ArmState(), apply_row)


def started(purpose: str = "check") -> Row:
    return "started", {"purpose": purpose, "arm": "a", "limit_um": 50.0}


def begun(name: str = "Seat 1") -> Row:
    return "seat_begun", {"name": name}


def points(q_rad: np.ndarray) -> Row:
    return "points", {"q_rad": q_rad.tolist()}


def live_of(arm: Arm | None = ARM, **changes: Any) -> ArmLive:
    known: dict[str, Any] = {
        "library": DatasheetLibrary({}, {}, {}, ()),
        "arm": arm,
        "link": CONNECTED,
        "connected_joints": 6,
        "q_rad": None,
        "left_mm": None,
        "has_simulation": False,
        "simulation_running": False,
        "busy": None,
        "trouble": None,
    }
    return ArmLive(**{**known, **changes})


def swung(count: int, reach_rad: float = 1.2) -> np.ndarray:
    """Angles that hold the tip in one place while joints 4 to 6 turn."""
    centre = tip_centres(ARM, REST_RAD[None])[0]
    path, q = [], REST_RAD.copy()
    for share in np.linspace(-1, 1, count):
        q = q.copy()
        q[3:] = REST_RAD[3:] + reach_rad * share * np.array([0.4, 0.3, 1.0])
        q = reach_tip(ARM, centre, q)
        path.append(q)
    return np.array(path)


def test_points_make_no_view_stale_and_other_rows_do() -> None:
    before = state_after(started(), begun())
    more = state_after(started(), begun(), points(swung(5)))
    assert more.rev == before.rev
    assert len(more.seats[0].q_rad) == 5
    assert state_after(started(), begun(), SEAT_ENDED).rev > before.rev


def test_the_fold_goes_from_seat_to_swing_to_result() -> None:
    assert state_after(started()).step == "seat"
    assert state_after(started(), begun()).step == "swing"
    assert state_after(started(), begun(), SEAT_ENDED).step == "seat"
    assert state_after(started(), begun(), SEAT_ENDED, ("checked", {})).step == "result"
    dropped = state_after(started(), begun(), ("seat_dropped", {"name": "Seat 1"}))
    assert (dropped.step, dropped.seats) == ("seat", ())
    solved = state_after(
        started("identify"), begun(), SEAT_ENDED, ("solved", {"x": 1}), ("reopened", {})
    )
    assert (solved.step, solved.solved) == ("seat", None)
    with pytest.raises(ValueError, match="unknown"):
        state_after(("danced", {}))


def window(q_rad: np.ndarray, step_ns: int = MS) -> ReadingWindow:
    return ReadingWindow("joints", np.arange(len(q_rad), dtype=np.int64) * step_ns, q_rad)


def test_a_point_is_taken_whenever_a_joint_has_turned_enough() -> None:
    q = swung(400)
    picked = sample_points(ARM, (), window(q), 0, 400 * MS)
    taken = np.array(picked.q_rad)
    assert np.all(np.abs(np.diff(taken, axis=0)).max(axis=1) >= TURN_RAD)
    assert len(taken) == pytest.approx(np.ptp(q[:, 5]) / TURN_RAD, rel=0.25)
    # what comes later goes on from the last point
    assert sample_points(ARM, picked.q_rad, window(q[-1:]), 0, MS).q_rad == ()
    resting = window(np.repeat(q[:1], 50, axis=0))
    assert sample_points(ARM, (), resting, 0, 50 * MS).q_rad == (tuple(q[0]),)


def test_no_point_counts_near_the_moment_when_the_tip_leaves() -> None:
    q = swung(300)
    out = q[-1] + np.array([0.05, 0, 0, 0, 0, 0])
    step = 10 * MS
    samples = window(np.vstack([q, out]), step)
    picked = sample_points(ARM, (), samples, 0, 300 * step)
    assert present(picked.left_mm) > 3
    kept = [int(np.argmin(np.abs(q - p).max(axis=1))) for p in np.array(picked.q_rad)]
    assert max(kept) * step <= 300 * step - HOLD_NS
    back = sample_points(ARM, picked.q_rad, window(q[:1]), 0, step)
    assert back.left_mm is None


def why_not(
    state: ArmState, name: str, args: Mapping[str, object] | None = None, **live: Any
) -> str:
    """Why a command is rejected in a state; empty if it is not."""
    return str(RULES.rejection_reason(state, live_of(**live), name, args or {}))


def test_a_swing_is_finished_only_with_points_and_swing() -> None:
    def reason(q: np.ndarray) -> str:
        return why_not(state_after(started(), begun(), points(q)), "finish")

    assert f"{LEAST} points" in reason(swung(5))
    assert "Swing further" in reason(swung(60, 0.3))
    assert reason(swung(60)) == ""


def test_commands_belong_to_their_step() -> None:
    state = state_after(started())
    assert why_not(state, "begin") == ""
    assert "another step" in why_not(state, "finish")
    assert "no command" in why_not(state, "fly")
    assert "one seat" in why_not(state, "fit")
    assert "Choose the arm" in why_not(state, "begin", arm=None)
    assert "7 joints" in why_not(state, "begin", connected_joints=7)
    assert why_not(state, "begin", busy=Busy("At work", None)) == "Wait: At work."
    assert "simulated operator" in why_not(state, "run_simulation")
    assert why_not(state, "set_limit", {"limit_um": 40}) == ""
    for wrong in (0, -3, "40", True):
        said = why_not(state, "set_limit", {"limit_um": wrong})
        assert "must be 1 to 100 000 micrometres" in said
    assert "closed" in why_not(state_after(started(), ("ended", {})), "begin")
    few = state_after(started("identify"), begun(), SEAT_ENDED)
    assert "1 of at least" in why_not(few, "fit")


def seat(kind: str, size_mm: float | None, name: str, q_rad: np.ndarray) -> list[Any]:
    artefact = {"kind": kind, "size_mm": size_mm, "standard_uncertainty_mm": 0.001}
    return [
        ("artefact_chosen", artefact),
        ("seat_begun", {"name": name, "artefact": artefact}),
        points(q_rad),
    ]


def test_a_bar_has_two_ends_and_half_of_one_is_not_used(tmp_path: Path) -> None:
    q = swung(40)
    one = [started("identify"), *seat("bar", 300.0, "Bar 1, end A", q), SEAT_ENDED]
    state = state_after(*one)
    live = live_of()
    assert state.half_bar
    assert "other end" in why_not(state, "choose_artefact", {"kind": "seat"})
    assert "other end" in str(build_view(state, live).title)
    assert collect_observations(state).bars == ()
    away = tip_centres(ARM, q[:1])[0] + np.array([0.0, 60.0, 80.0])
    other = np.array([reach_tip(ARM, away, one) for one in q])
    state = state_after(*one, *seat("bar", 100.05, "Bar 1, end B", other), SEAT_ENDED)
    assert not state.half_bar
    (bar,) = collect_observations(state).bars
    assert bar.length_mm == 300.0
    write_observations(tmp_path, collect_observations(state))
    (back,) = read_bars(tmp_path / "ballbars.csv", ARM)
    np.testing.assert_allclose(back.q_rad[1], other, atol=1e-12)
    # to the fit it is one place, and so it counts
    assert why_not(state, "fit") == "1 of at least 4 places are taken."
    progress = present(build_view(state, live).progress)
    assert str(progress.text) == "1 of 6 places"
    # 60 mm and 80 mm are 100 mm, of a bar that is said to have 100.05
    assert str(build_view(state, live).picture.seats[1].note) == "length −50 µm"


def test_a_sphere_is_touched_by_the_button_and_fitted_by_its_distances() -> None:
    ball = tip_centres(ARM, REST_RAD[None])[0] - np.array([0.0, 0.0, 30.0])
    radius_mm = (20.0 + ARM.tip.diameter_mm) / 2
    rng = np.random.default_rng(2)
    outward = rng.normal(size=(12, 3))
    outward[:, 2] = np.abs(outward[:, 2])
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    outward[0] *= (radius_mm + 0.02) / radius_mm
    q = np.array([reach_tip(ARM, ball + radius_mm * n, REST_RAD) for n in outward])
    rows = [started("identify"), *seat("sphere", 20.0, "Sphere 1", q)]
    state, live = state_after(*rows), live_of()
    assert state.touching
    assert why_not(state, "touch") == ""
    assert why_not(state, "finish") == ""
    few = state_after(*rows[:-1], points(q[:5]))
    assert "of at least 8" in why_not(few, "finish")
    view = build_view(state, live)
    assert action(view, "touch").primary
    off_um = np.linalg.norm(view.picture.tips_um, axis=1)
    assert 8 < off_um[0] < 20
    assert off_um[1:].max() < off_um[0]
    (sphere,) = collect_observations(state).spheres
    assert sphere.diameter_mm == 20.0


def test_an_artefact_needs_its_size() -> None:
    state = state_after(started("identify"), ("artefact_chosen", {"kind": "bar"}))
    assert "bar's certificate" in why_not(state, "begin")
    for wrong in ({"size_mm": 1}, {"size_mm": True}, {"standard_uncertainty_mm": 2}):
        assert why_not(state, "choose_artefact", {"kind": "bar", **wrong})
    assert why_not(state, "choose_artefact", {"kind": "bar", "size_mm": 300}) == ""
    assert why_not(state, "choose_artefact", {"kind": "spoon"})
    assert why_not(state_after(started()), "choose_artefact", {"kind": "bar"})


def test_the_view_shows_each_axis_against_the_limit() -> None:
    q = swung(60)
    q[30] += 2e-4
    state = state_after(started(), begun(), points(q))
    view = build_view(state, live_of(left_mm=7.0))
    tips_um = tip_centres(ARM, q) * 1e3
    assert view.picture.half_range_um == pytest.approx(np.ptp(tips_um, axis=0) / 2)
    assert present(view.number).quality == "bad"
    assert any("7 mm away from the seat" in str(finding.text) for finding in view.findings)
    assert [step.state for step in view.steps] == ["done", "current", "todo"]
    assert len(view.picture.tips_um) == 60
    assert view.picture.joints[5].highest_deg is not None
