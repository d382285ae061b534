"""What is drawn of a verification: touches, clouds, figures. Pure."""

from dataclasses import asdict

import numpy as np

from crenel.errors import OperationError, sentence
from crenel.formats.results.decision_rule import RulePart
from crenel.gauges.quick.evaluate_gauge import filters_of
from crenel.gauges.quick.guide.rules import VerifyLive
from crenel.gauges.quick.guide.state import VerificationCloud, VerifyState
from crenel.gauges.quick.guide.view import (
    CloudLine,
    CloudState,
    FigureLine,
    TouchLine,
    VerdictLine,
    VerifyPicture,
)
from crenel.gauges.quick.maths.probed_gauge import ProbedPlane, ProbedSphere
from crenel.guide.common.journal import error_from_payload
from crenel.messages.message import Text
from crenel.metrology.arm.kinematics import tip_centres
from crenel.metrology.fitting.deviation_map import flat_places
from crenel.metrology.transforms import Floats


def build_picture(state: VerifyState, live: VerifyLive) -> VerifyPicture:
    """The picture."""
    verdict = live.judged.verdict if state.step == "review" else None
    return VerifyPicture(
        shape=live.gauge.shape if live.gauge else None,
        radius_mm=live.gauge.radius_mm if live.gauge else None,
        touches=_touches(state, live),
        touch_rms_um=touch_rms_um(live),
        scanning=state.open_cloud is not None,
        clouds=[_cloud(state, live, cloud) for cloud in state.listed],
        figures=[
            FigureLine(
                figure.name,
                figure.title,
                figure.unit,
                figure.value,
                figure.expanded_uncertainty,
                figure.budget,
                figure.test_uncertainty,
                figure.judged_by,
                figure.limit,
                figure.decision,
                figure.reason,
                figure.clouds,
                figure.spread,
            )
            for figure in live.judged.figures
        ],
        verdict=VerdictLine(verdict.result, verdict.text) if verdict else None,
        rule=RulePart.of(live.rule),
        filters=filters_of(live.gauge.shape) if live.gauge else None,
    )


def touch_rms_um(live: VerifyLive) -> float | None:
    """How well the touches agree with the gauge's shape."""
    touched = live.touched
    return None if touched is None or isinstance(touched, OperationError) else touched.rms_mm * 1e3


def _touches(state: VerifyState, live: VerifyLive) -> list[TouchLine]:
    touched, counted = live.touched, state.counted
    if live.arm is None or not isinstance(touched, ProbedPlane | ProbedSphere):
        return [TouchLine(touch.index, None, None, None) for touch in counted]
    tips = tip_centres(live.arm, np.array([touch.reading for touch in counted]))
    places = _flat(touched, tips)
    return [
        TouchLine(touch.index, float(x), float(y), float(residual) * 1e3, bool(outlier))
        for touch, (x, y), residual, outlier in zip(
            counted, places, touched.residuals_mm, touched.outliers, strict=True
        )
    ]


def _flat(touched: ProbedPlane | ProbedSphere, tips: Floats) -> Floats:
    """(N, 2) as seen from above the gauge, about its middle."""
    if isinstance(touched, ProbedPlane):
        return flat_places(tips - touched.nominal.point_mm, touched.nominal.normal)
    away = tips - touched.nominal.centre_mm
    on_it = away / np.linalg.norm(away, axis=1)[:, None] * touched.nominal.radius_mm
    return flat_places(on_it, np.array([0.0, 0.0, 1.0]))


def _cloud(state: VerifyState, live: VerifyLive, cloud: VerificationCloud) -> CloudLine:
    fit = live.judged.fits.get(cloud.number)
    shown: CloudState = "good"
    text: Text = ""
    if cloud.voided:
        shown = "aside"
    elif not cloud.ended:
        return CloudLine(cloud.number, "scanning", "", live.scan_points, 0)
    elif cloud.refused is not None:
        return CloudLine(cloud.number, "refused", error_from_payload(cloud.refused).reason, 0, 0)
    elif fit is None:
        return CloudLine(cloud.number, "measuring", "", 0, 0)
    if fit is None:
        return CloudLine(cloud.number, shown, text, 0, 0)
    if fit.warnings:
        text = sentence(fit.warnings[0])
    return CloudLine(
        cloud.number,
        shown,
        text,
        fit.points,
        fit.used,
        fit.rms_um,
        fit.form_um,
        in_gate=fit.in_gate,
        form_all_um=fit.form_all_um,
        range_all_um=fit.range_all_um,
        **asdict(live.judged.errors[cloud.number]),
        map_url=f"/api/verifications/{state.session_id}/cloud/{cloud.number}/map",
    )
