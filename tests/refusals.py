"""What the program refuses, by the code of its reason."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from app.errors import OperationError


@contextmanager
def refused(code: str) -> Iterator[pytest.ExceptionInfo[OperationError]]:
    """The block ends with an error of this code."""
    with pytest.raises(OperationError) as failed:
        yield failed
    assert failed.value.code == code
