"""One decision rule: the guard band, who bears it, and limits that lie close together."""

from dataclasses import replace

import pytest

from crenel.metrology.decision import EXPANDED_K2, GUARDED_95, SIMPLE, Bearer, decide


@pytest.mark.parametrize(
    ("value", "decision"),
    [(79.9, "pass"), (-80.0, "pass"), (80.1, "uncertain"), (120.0, "uncertain"), (-120.1, "fail")],
)
def test_a_limit_is_kept_or_passed_by_more_than_the_guard_band(value: float, decision: str) -> None:
    assert decide(value, 100.0, 10.0, EXPANDED_K2) == decision
    assert decide(value, None, 10.0, EXPANDED_K2) == "none"


def test_the_guard_band_is_that_of_the_rule() -> None:
    assert decide(83.0, 100.0, 10.0, GUARDED_95) == "pass"
    assert decide(83.0, 100.0, 10.0, EXPANDED_K2) == "uncertain"
    assert decide(99.9, 100.0, 10.0, SIMPLE) == "pass"
    assert decide(100.1, 100.0, 10.0, SIMPLE) == "fail"


@pytest.mark.parametrize(
    ("bearer", "decision"), [("prover", "uncertain"), ("supplier", "fail"), ("user", "pass")]
)
def test_in_between_who_bears_the_uncertainty_decides(bearer: Bearer, decision: str) -> None:
    rule = replace(GUARDED_95, bearer=bearer)
    assert [decide(value, 100.0, 10.0, rule) for value in (90.0, 110.0)] == [decision] * 2
    assert decide(0.0, 100.0, 10.0, rule) == "pass"
    assert decide(200.0, 100.0, 10.0, rule) == "fail"


def test_both_limits_count_where_they_lie_close_together() -> None:
    # at the middle of limits of 1.7 u, the probability between them is 91 %, not 95 %
    assert decide(0.0, 17.0, 10.0, GUARDED_95) == "pass"
    assert decide(0.0, 17.0, 10.0, GUARDED_95, signed=True) == "uncertain"
