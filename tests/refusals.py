"""What is asserted of an operation that is refused."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from crenel.errors import OperationError


@contextmanager
def refused(code: str) -> Iterator[pytest.ExceptionInfo[OperationError]]:
    """What is done within ends in an error of this code."""
    with pytest.raises(OperationError) as caught:
        yield caught
    assert caught.value.code == code


@contextmanager
def refused_as(code: str, *words: str, where: object = "") -> Iterator[None]:
    """What is done within ends in this error, whose line has these words; ``where``: its first
    part's."""
    with refused(code) as caught:
        yield
    assert str(where) in str(caught.value.what)
    for said in words:
        assert said in caught.value.line
