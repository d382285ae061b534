"""Numbers beside their limits: the sign and the numbers say the same."""

import ast
from collections.abc import Sequence
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.messages.catalogue import renderer
from app.messages.limits import MOST_DECIMALS, beside_limit, decimals_beside
from app.messages.message import Quantity
from tests.sources import name_of, python_files, reads_tree

LIMITS = {"limit", "good", "most", "least", "wanted", "noisy", "edge_rms_px"}
"""Names of the values of messages that are limits."""
NUMBERS = {"quantity", "rounded", "signed"}


def shown(number: Quantity) -> Decimal:
    """What a reader sees."""
    return Decimal(renderer("en")(number).replace(",", "").split()[0].replace("−", "-"))


@given(
    st.floats(0.001, 900),
    st.one_of(st.sampled_from([0.0, 0.004, -0.004, 0.06, -0.4, 1e-4]), st.floats(-9, 9)),
    st.integers(0, 3),
)
def test_a_number_is_never_rounded_to_the_other_side_of_its_limit(
    limit: float, off: float, decimals: int
) -> None:
    value = limit + off
    if 0 < abs(value - limit) < 10**-MOST_DECIMALS:
        return
    number, beside = beside_limit(value, limit, "", decimals)
    assert (shown(number) > shown(beside)) == (value > limit)
    assert (shown(number) < shown(beside)) == (value < limit)
    assert number.decimals >= decimals


def test_a_limit_that_somebody_set_is_shown_as_it_is() -> None:
    assert [one.value for one in beside_limit(1.5, 0.25, "s", 1)] == [1.5, 0.25]
    assert [one.value for one in beside_limit(13.0, 12.5, "µm")] == [13.0, 12.5]
    assert beside_limit(13.0, 12.3456, "µm")[1].value == 12.0


@pytest.mark.parametrize(
    ("value", "limits", "decimals", "enough"),
    [
        (0.31, [0.3], 2, 2),
        (0.3004, [0.3], 1, 4),
        (24.96, [25.0], 0, 2),
        (25.0, [25.0], 0, 0),
        (189.6, [120.0, 190.0], 0, 1),
    ],
)
def test_it_has_as_many_decimals_as_show_it(
    value: float, limits: list[float], decimals: int, enough: int
) -> None:
    assert decimals_beside(value, limits, decimals) == enough


@reads_tree
def rounded_alone(nodes: Sequence[ast.AST]) -> list[int]:
    """Lines of messages with a limit that is rounded without the number beside it."""
    found = []
    for node in nodes:
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "message":
            numbers = {
                one.arg
                for one in node.keywords
                if isinstance(one.value, ast.Call) and getattr(one.value.func, "id", "") in NUMBERS
            }
            if numbers & LIMITS and numbers - LIMITS:
                found.append(node.lineno)
    return found


def test_limits_are_rounded_with_the_numbers_beside_them() -> None:
    found = [
        f"{name_of(path)}:{line}" for path in python_files("app") for line in rounded_alone(path)
    ]
    assert not found
