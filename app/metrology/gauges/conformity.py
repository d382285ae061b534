"""Whether a measured value keeps its limit, by the decision rule of ISO 14253-1."""

from typing import Literal

Decision = Literal["pass", "fail", "uncertain", "none"]


def decide(value: float, limit: float | None, expanded_uncertainty: float) -> Decision:
    """Passed only inside the limit by more than the uncertainty (k = 2), failed only beyond
    it by more than that; ``none`` without a limit, which is one of the absolute value."""
    if limit is None:
        return "none"
    if abs(value) + expanded_uncertainty <= limit:
        return "pass"
    return "fail" if abs(value) - expanded_uncertainty > limit else "uncertain"
