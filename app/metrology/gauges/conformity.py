"""Whether a measured value keeps its limit, by the decision rule of ISO 14253-1."""

from typing import Literal

Decision = Literal["pass", "fail", "uncertain", "none"]


def decide(value: float, limit: float | None, expanded_uncertainty: float) -> Decision:
    """Whether a value keeps its limit, with its expanded uncertainty taken into account.

    Args:
        value: the measured error; its sign does not matter.
        limit: the largest permissible absolute value, in the same unit; None: no limit.
        expanded_uncertainty: k = 2, in the same unit.

    Returns:
        ``pass`` or ``fail`` where that holds in spite of the uncertainty, else ``uncertain``;
        ``none`` without a limit.

    Source:
        The decision rules of ISO 14253-1 for proving conformity and nonconformity.

    Example:
        >>> decide(-8.0, 10.0, 1.5), decide(9.0, 10.0, 1.5), decide(12.0, 10.0, 1.5)
        ('pass', 'uncertain', 'fail')
    """
    if limit is None:
        return "none"
    if abs(value) + expanded_uncertainty <= limit:
        return "pass"
    return "fail" if abs(value) - expanded_uncertainty > limit else "uncertain"
