"""How sentences are put together."""

import pytest

from app.findings import figures, format_signed


@pytest.mark.parametrize(
    ("value", "decimals", "plain", "with_sign"),
    [
        (-0.81, 1, "−0.8", "−0.8"),
        (0.81, 1, "0.8", "+0.8"),
        (-0.04, 1, "0.0", "0.0"),
        (0.04, 1, "0.0", "0.0"),
        (-12.0, 0, "−12", "−12"),
        (0.0, 0, "0", "0"),
    ],
)
def test_numbers_have_a_true_minus_and_nothing_has_no_sign(
    value: float, decimals: int, plain: str, with_sign: str
) -> None:
    assert figures(value, decimals) == plain
    assert format_signed(value, decimals) == with_sign
