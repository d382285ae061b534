"""The check of the tip, in words. Pure."""

from collections.abc import Mapping
from typing import Any

from pydantic import TypeAdapter

from crenel.findings import Finding
from crenel.gauges.quick.maths.tip_check import TipCheck
from crenel.guide.arm.view import TipResult
from crenel.guide.common.flow import DECISION_QUALITY
from crenel.messages.message import Text, join, message, quantity
from crenel.messages.uncertainty import uncertainty_quantity

LIMIT_UM = 150.0
"""The limit of the diameter's error and of the scatter, until the operator sets another: an arm of
the article's class touches to no better."""
_RESULT = TypeAdapter(TipResult)


def to_payload(found: TipCheck, expected_mm: float, limit_um: float | None) -> dict[str, object]:
    """As the journal keeps it."""
    return {
        "touches": found.contact_count,
        "diameter_mm": found.diameter_mm,
        "expected_mm": expected_mm,
        "error_um": found.error_um,
        "expanded_uncertainty_um": found.expanded_uncertainty_um,
        "scatter_um": found.scatter_um,
        "bend_um": found.bend_um,
        "limit_um": limit_um,
        "error_decision": found.error_decision,
        "decision": found.decision,
        "cause": found.cause,
        "outliers": list(found.outliers),
    }


def tip_result(payload: Mapping[str, Any]) -> TipResult:
    """What was found, as it is shown."""
    return _RESULT.validate_python(payload)


def tip_check_finding(payload: Mapping[str, Any]) -> Finding:
    """What was found in one sentence, the limit, and what to do."""
    text, remedy = _cause(payload)
    limit_um = payload["limit_um"]
    if limit_um is not None:
        text = join([text, message("limit-is", limit=quantity(limit_um, "µm"))], " ")
    return Finding(DECISION_QUALITY[payload["decision"]], text, remedy)


def _cause(payload: Mapping[str, Any]) -> tuple[Text, Text]:
    """What is the matter with the tip, and what to do about it."""
    diameter = quantity(payload["diameter_mm"], "mm", 3)
    expected = quantity(payload["expected_mm"], "mm", 3)
    scatter = quantity(payload["scatter_um"], "µm")
    off = quantity(abs(payload["error_um"]), "µm")
    known = uncertainty_quantity(payload["expanded_uncertainty_um"], "µm")
    bend = quantity(payload["bend_um"] or 0.0, "µm")
    outliers = payload.get("outliers", ())
    causes: dict[str, tuple[Text, Text]] = {
        "sound": (
            message("tip-sound-diameter-off-touches-agree", off=off, scatter=scatter),
            "",
        ),
        "unsure": (
            message("tips-diameter-off-known-only-k", off=off, known=known),
            message("touch-sphere-more-spread-over-all"),
        ),
        "other-tip": (
            message(
                "another-tip-mounted-another-sphere-touched", diameter=diameter, expected=expected
            ),
            message("mount-tip-of-datasheet-or-give-diameter"),
        ),
        "small": (
            message("worn-has-flat", diameter=diameter, expected=expected),
            message("look-change"),
        ),
        "large": (
            message("there-dirt-tip-sphere", diameter=diameter, expected=expected),
            message("clean-both-check-again"),
        ),
        "bent": (
            message("tip-sits-off-its-place", off=bend),
            message("screw-home-check-again-change-if"),
        ),
        "outlier": (
            message(
                "tip-points-off-sphere-of-others",
                count=len(outliers),
                points=", ".join(str(i + 1) for i in outliers),
                scatter=scatter,
            ),
            message("check-tip-again-holding-still"),
        ),
        "scatter": (
            message("touches-disagree-up-tip-sphere-loose", scatter=scatter),
            message("screw-tip-home-clamp-sphere-check"),
        ),
    }
    return causes[payload["cause"]]
