"""A verification's fold, what is allowed when, and what goes stale."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crenel.gauges.judgement.maths_value_uncertainty import DIAMETER_BY_FORM
from crenel.gauges.plan.document_gauge import DEFAULT_LIMITS, GaugeFile, VerificationLimits
from crenel.gauges.quick.document import FigurePart
from crenel.gauges.quick.evaluate import cloud_errors, gauge_figures, verification_verdict
from crenel.gauges.quick.evaluate_gauge import GaugeFit
from crenel.gauges.quick.guide.flow import build_view
from crenel.gauges.quick.guide.rules import RULES, CloudResults, VerifyLive
from crenel.gauges.quick.guide.state import VerifyState, apply_row
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.gauges.quick.maths.probed_gauge import ProbedPlane, ProbedSphere
from crenel.guide.common.datasheet_library import DatasheetEntry, Gauges
from crenel.guide.common.journal import fold
from crenel.metrology.decision import EXPANDED_K2, GUARDED_95, SIMPLE, DecisionRule
from tests.guide.builders import CONNECTED, Row, journal_of
from tests.metrology.builders import six_axis_arm

PLANE = GaugeFile(shape="plane", name="Plate")
SPHERE = GaugeFile(shape="sphere", radius_mm=10.0, name="Sphere", standard_uncertainty_um=1.0)


def state_after(*rows: Row) -> VerifyState:
    return fold(journal_of(*rows), VerifyState(), apply_row)


STARTED: Row = ("started", {"calibration_id": "c1", "gauge": "plate"})
TOUCHED: Row = ("touched", {"q_rad": [0.0] * 6})


def fit(**changes: object) -> dict[str, object]:
    values: dict[str, object] = {
        "points": 1000,
        "used": 950,
        "frames": 60,
        "rms_um": 12.0,
        "form_um": 48.0,
        "centre_mm": [0.0, 0.0, 0.02],
        "normal": [0.0, 0.0, 1.0],
        "offset_mm": 0.02,
        "covariance": [[1e-6, 0, 0], [0, 1e-9, 0], [0, 0, 1e-9]],
    }
    return {**values, **changes}


def cloud(number: int, **changes: object) -> list[Row]:
    return [
        ("cloud_begun", {"number": number}),
        ("cloud_ended", {"number": number, "ended": True}),
        ("cloud_measured", {"number": number, "fit": fit(**changes), "seconds": 7.0}),
    ]


TO_SCAN: list[Row] = [STARTED, ("gauge_confirmed", {}), ("touch_skipped", {})]


def live_of(**changes: Any) -> VerifyLive:
    known = {
        name: DatasheetEntry(name, Path(f"{name}.json"), gauge)
        for name, gauge in (("plate", PLANE), ("sphere", SPHERE))
    }
    live = VerifyLive(
        active_id="c1",
        active_name="First",
        gauges=Gauges(known, ()),
        gauge=PLANE,
        limits=DEFAULT_LIMITS,
        arm=None,
        touched=None,
        judged=CloudResults({}, {}, (), None),
        rule=GUARDED_95,
        arm_link=CONNECTED,
        sensor_link=replace(CONNECTED, title="Sensor"),
        still=True,
        strain=None,
        scan_why_not="",
        scan_points=0,
        has_simulation=False,
        simulation_running=False,
        busy=None,
        trouble=None,
    )
    return replace(live, **changes)


def test_steps_go_on_and_back_and_what_comes_after_is_stale() -> None:
    rows = [*TO_SCAN, *cloud(1), ("clouds_confirmed", {}), ("went_back", {"to": "touch"})]
    state = state_after(*rows)
    view = build_view(state, live_of())
    assert [step.state for step in view.steps] == ["done", "current", "stale", "stale"]
    assert len(state.good) == 1


def test_another_gauge_keeps_what_was_taken_and_does_not_count_it() -> None:
    rows = [STARTED, ("gauge_confirmed", {}), TOUCHED, ("touch_confirmed", {}), *cloud(1)]
    rows += [("went_back", {"to": "gauge"}), ("gauge_chosen", {"id": "sphere"})]
    state = state_after(*rows)
    assert (state.counted, state.good) == ((), ())
    state = state_after(*rows, ("gauge_chosen", {"id": "plate"}))
    assert (len(state.counted), len(state.good)) == (1, 1)


def test_a_cloud_is_voided_and_taken_back() -> None:
    rows = [*TO_SCAN, *cloud(1), *cloud(2), ("cloud_voided", {"number": 1, "voided": True})]
    assert [c.number for c in state_after(*rows).good] == [2]
    state = state_after(*rows, ("cloud_restored", {"number": 1, "voided": False}))
    assert [c.number for c in state.good] == [1, 2]


def test_while_a_cloud_is_scanned_it_is_ended_or_dropped_first() -> None:
    begun, live = [*TO_SCAN, *cloud(1)[:1]], live_of()
    state = state_after(*begun)
    assert state.open_cloud is not None
    for name in ("begin_cloud", "confirm_clouds", "back", "abandon", "undo"):
        assert RULES.rejection_reason(state, live, name, {}), name
    assert RULES.rejection_reason(state, live, "finish_cloud", {}) == ""
    ended = state_after(*begun, ("cloud_ended", {"number": 1, "ended": True}))
    assert ended.clouds[0].waiting
    assert "not evaluated" in str(RULES.rejection_reason(ended, live, "begin_cloud", {}))


@pytest.mark.parametrize(
    ("changes", "name", "said"),
    [
        ({"active_id": "c2"}, "begin_cloud", "calibration in use has changed"),
        ({"active_id": ""}, "begin_cloud", "no calibration"),
        ({"scan_why_not": "The arm sends nothing."}, "begin_cloud", "sends nothing"),
        ({}, "confirm_clouds", "No cloud"),
        ({}, "touch", "another step"),
        ({}, "fly", "no command"),
        ({}, "stop_simulation", "not moving"),
        ({}, "run_simulation", "no simulated operator"),
    ],
)
def test_what_cannot_be_done_says_why(changes: dict[str, object], name: str, said: str) -> None:
    assert said in str(RULES.rejection_reason(state_after(*TO_SCAN), live_of(**changes), name, {}))


def test_a_lost_arm_is_said_and_nothing_is_lost() -> None:
    state = state_after(*TO_SCAN, *cloud(1))
    lost = replace(CONNECTED, state="lost", text="No data for 3 s")
    view = build_view(state, live_of(arm_link=lost))
    assert any("No data for 3 s" in str(f.text) and "kept" in str(f.remedy) for f in view.findings)
    assert view.progress is not None
    assert view.progress.done == 1


def touched_plane(height_mm: float = 0.0) -> ProbedPlane:
    nominal = NominalPlane(np.array([0.0, 0.0, height_mm]), np.array([0.0, 0.0, 1.0]))
    none = np.zeros(6, np.bool_)
    return ProbedPlane(nominal, np.zeros(6), np.diag([4e-6, 1e-9, 1e-9]), none)


def touched_sphere(radius_sd_mm: float) -> ProbedSphere:
    nominal, none = NominalSphere(np.zeros(3), 10.0), np.zeros(7, np.bool_)
    return ProbedSphere(nominal, np.zeros(7), 9e-6 * np.eye(3), 10.0, radius_sd_mm, none)


def test_an_outlier_is_named_and_can_be_removed() -> None:
    one = replace(touched_plane(), residuals_mm=2.0 * np.arange(6.0), outliers=np.arange(6) == 4)
    view = build_view(
        state_after(STARTED, ("gauge_confirmed", {}), *[TOUCHED] * 6), live_of(touched=one)
    )
    assert "Point 5 is 8.0 mm off the surface of the others." in str(view.findings[0].text)
    assert [a.args for a in view.actions if a.name == "void_touch"] == [{"index": 4}]


def test_touches_in_doubt_are_named_and_drawn() -> None:
    live = live_of(
        arm=six_axis_arm(1e-5), touched=replace(touched_plane(), doubtful=np.arange(6) < 2)
    )
    state = state_after(STARTED, ("gauge_confirmed", {}), *[TOUCHED] * 6)
    view = build_view(state, live)
    assert "one of the points 1, 2 is off" in str(view.findings[0].text)
    assert "cannot tell which" in str(RULES.rejection_reason(state, live, "confirm_touch", {}))
    assert all(touch.x_mm is not None for touch in view.picture.touches)


FLAT = GaugeFit.model_validate(fit())


def figures_of(
    fits: Sequence[GaugeFit],
    gauge: GaugeFile,
    touched: ProbedPlane | ProbedSphere | None,
    limits: VerificationLimits = DEFAULT_LIMITS,
    rule: DecisionRule = GUARDED_95,
) -> dict[str, FigurePart]:
    return {one.name: one for one in gauge_figures(fits, gauge, touched, limits, rule)}


def sphere_fit(centre_mm: list[float], variances: list[float], **changes: object) -> GaugeFit:
    """A sphere of 9.98 mm, 0.02 mm less than the gauge's radius."""
    values = fit(radius_mm=9.98, centre_mm=centre_mm, covariance=np.diag(variances).tolist())
    return GaugeFit.model_validate({**values, "normal": None, "offset_mm": None, **changes})


def test_a_plane_is_compared_with_the_probe_only_where_it_was_touched() -> None:
    fits = [FLAT, GaugeFit.model_validate(fit(offset_mm=0.05, centre_mm=[0, 0, 0.05]))]
    assert set(figures_of(fits, PLANE, None)) == {"form", "rms", "angle_range", "offset_range"}
    figures = figures_of(fits, PLANE, touched_plane())
    assert figures["offset"].value == pytest.approx(50.0)
    assert figures["offset"].clouds == pytest.approx((20.0, 50.0))
    assert figures["offset"].expanded_uncertainty == pytest.approx(2e3 * np.sqrt(5e-6), rel=1e-6)
    assert figures["z_error"].value == pytest.approx(-50.0)
    assert (figures["z_error"].limit, figures["z_error"].decision) == (None, "none")
    assert figures["offset_range"].value == pytest.approx(30.0)
    verdict = verification_verdict(list(figures.values()), True)
    assert verdict.result == "pass"


def test_a_figure_fails_or_stays_undecided_by_its_uncertainty() -> None:
    limits = DEFAULT_LIMITS.model_copy(update={"offset": 20.0})
    figures = gauge_figures([FLAT], PLANE, touched_plane(), limits)
    assert verification_verdict(figures, True).result == "uncertain"
    far = gauge_figures([FLAT], PLANE, touched_plane(-0.5), limits)
    verdict = verification_verdict(far, True)
    assert verdict.result == "fail"
    assert "520 µm, beyond the limit of 20 µm" in str(verdict.reasons[0])


def test_a_sphere_is_judged_by_its_nominal_and_its_touched_centre() -> None:
    one = sphere_fit([0.03, 0.0, 0.04], [1e-6, 1e-6, 4e-6, 1e-6])
    alone = figures_of([one], SPHERE, None)
    assert set(alone) == {"form", "rms", "radius_error"}
    assert alone["radius_error"].value == pytest.approx(20.0)
    assert alone["radius_error"].expanded_uncertainty == pytest.approx(2 * np.hypot(1.0, 1.0))
    errors = cloud_errors(one, SPHERE, touched_sphere(0.001))
    assert errors.centre_error_um == pytest.approx(50.0)
    assert errors.angle_arcsec is None


def test_performance_is_judged_by_the_test_uncertainty_and_places_by_the_measurement() -> None:
    gauge = SPHERE.model_copy(update={"form_um": 2.0})
    all_points = {"form_all_um": 90.0, "range_all_um": 200.0}
    one = sphere_fit([0.03, 0.0, 0.04], [1e-4] * 4, **all_points)
    touched = touched_sphere(0.1)
    limits = DEFAULT_LIMITS.model_copy(update={"radius_error": 25.0, "centre_error": 60.0})
    found = figures_of([one], gauge, touched, limits)
    by = {name: figure.judged_by for name, figure in found.items()}
    assert [name for name, which in by.items() if which == "measurement"] == ["centre_error"]
    assert found["form"].test_uncertainty == pytest.approx(1.0)  # half the sphere's own form
    radius = found["radius_error"]
    assert radius.test_uncertainty == pytest.approx(np.hypot(1.0, DIAMETER_BY_FORM))
    assert radius.expanded_uncertainty > 20.0  # by the scan, which is what is tested
    assert radius.value == pytest.approx(20.0)
    assert radius.decision == "pass"
    assert found["centre_error"].decision == "uncertain"
    # all points are stated, without a limit unless one is given
    assert (found["form_all"].value, found["form_all"].decision) == (90.0, "none")
    given = limits.model_copy(update={"form_all": 80.0})
    judged = figures_of([one], gauge, touched, given)
    assert (judged["form_all"].decision, judged["form"].decision) == ("fail", "pass")


def test_the_sentence_of_a_figure_is_that_of_its_rule() -> None:
    limits = DEFAULT_LIMITS.model_copy(update={"offset": 24.0})

    def offset(rule: DecisionRule) -> tuple[str, str]:
        """Of 20 µm, known to 2.2 µm, k = 1."""
        figure = figures_of([FLAT], PLANE, touched_plane(), limits, rule)["offset"]
        return figure.decision, str(figure.reason)

    decision, words = offset(GUARDED_95)
    assert (decision, "guard band of 3.7 µm" in words, "k = 2" in words) == ("pass", True, False)
    decision, words = offset(EXPANDED_K2)
    assert (decision, "uncertainty of 4.5 µm (k = 2)" in words) == ("uncertain", True)
    supplier = replace(EXPANDED_K2, bearer="supplier")
    assert offset(supplier) == ("fail", offset(supplier)[1])
    assert "the supplier bears the uncertainty" in offset(supplier)[1]
    decision, words = offset(SIMPLE)
    assert (decision, words.endswith("within the limit of 24 µm.")) == ("pass", True)


AT_GAUGE: list[Row] = [STARTED]
AT_TOUCH: list[Row] = [STARTED, ("gauge_confirmed", {}), TOUCHED]


@pytest.mark.parametrize(
    ("rows", "name", "args"),
    [
        (AT_GAUGE, "choose_gauge", {"id": ["plate"]}),
        (AT_GAUGE, "choose_gauge", {}),
        (AT_TOUCH, "void_touch", {"index": False}),
        ([*TO_SCAN, *cloud(1)], "void_cloud", {"number": True}),
        ([*TO_SCAN, *cloud(1)], "void_cloud", {"number": {}}),
        (TO_SCAN, "back", {"to": ["gauge"]}),
        (TO_SCAN, "back", {"to": "review"}),
    ],
)
def test_empty_arguments_are_declined(rows: list[Row], name: str, args: dict[str, object]) -> None:
    assert RULES.rejection_reason(state_after(*rows), live_of(), name, args)
