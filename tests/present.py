"""Values that may be missing, where a test needs them."""

from typing import TypeVar

Value = TypeVar("Value")


def present(value: Value | None) -> Value:
    """The value, which is asserted to be there."""
    assert value is not None
    return value
