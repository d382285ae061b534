"""How numbers are written in English."""

import pytest

from crenel.messages.message import quantity, signed


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
    assert str(quantity(value, "", decimals)).strip() == plain
    assert str(signed(value, "", decimals)).strip() == with_sign
