"""The check of the tip, in words. Pure."""

from collections.abc import Mapping
from typing import Any

from app.findings import Finding, Quality
from app.guide.arm.view import TipResult
from app.metrology.gauges.tip_check import TipCheck

LIMIT_UM = 150.0
"""Of the diameter's error and of the scatter, until the operator sets another: an arm of the
paper's class touches to no better."""
QUALITY: dict[str, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "none": "neutral",
}


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
        "decision": found.decision,
        "cause": found.cause,
    }


RESULT = (
    "diameter_mm",
    "expected_mm",
    "error_um",
    "expanded_uncertainty_um",
    "scatter_um",
    "bend_um",
    "limit_um",
    "decision",
)


def tip_result(payload: Mapping[str, Any]) -> TipResult:
    """What was found, as it is shown."""
    return TipResult(**{name: payload[name] for name in RESULT})


def tip_check_finding(payload: Mapping[str, Any]) -> Finding:
    """What was found in one sentence, and what to do."""
    diameter, expected = payload["diameter_mm"], payload["expected_mm"]
    scatter, limit = payload["scatter_um"], payload["limit_um"]
    seems = f"The tip seems to be {diameter:.3f} mm, {expected:.3f} mm by the arm's papers"
    bound = "" if limit is None else f" (limit {limit:.0f} µm)"
    off = f"{abs(payload['error_um']):.0f} µm"
    texts = {
        "sound": (
            f"The tip is sound: its diameter is off by {off}, its touches agree to "
            f"{scatter:.0f} µm{bound}.",
            "",
        ),
        "unsure": (
            f"The tip's diameter is off by {off}, known to {payload['expanded_uncertainty_um']:.0f}"
            f" µm only (k = 2){bound}.",
            "Touch the sphere more, spread over all its upper half.",
        ),
        "other-tip": (
            f"{seems}: another tip is mounted, or another sphere was touched.",
            "Mount the tip of the papers, or give the sphere's own diameter.",
        ),
        "small": (f"{seems}: it is worn, or has a flat{bound}.", "Look at it, and change it."),
        "large": (
            f"{seems}: there is dirt on the tip or on the sphere{bound}.",
            "Clean both, and check again.",
        ),
        "bent": (
            f"The tip sits {payload['bend_um'] or 0.0:.0f} µm from where the papers have it: the "
            f"stylus is bent or not screwed home{bound}.",
            "Screw it home and check again; change it if it stays.",
        ),
        "scatter": (
            f"The touches disagree by up to {scatter:.0f} µm{bound}: the tip or the sphere is "
            "loose, or the arm slipped.",
            "Screw the tip home, clamp the sphere, and check again.",
        ),
    }
    text, remedy = texts[payload["cause"]]
    return Finding(QUALITY[payload["decision"]], text, remedy)
