"""What calls are refused with."""

from collections.abc import Callable
from typing import ParamSpec

import pytest

from crenel.errors import OperationError
from crenel.metrology.detection.failure_evidence import DetectionError

Given = ParamSpec("Given")


def refusal_of(
    call: Callable[Given, object], *given: Given.args, **named: Given.kwargs
) -> OperationError:
    with pytest.raises(OperationError) as refused:
        call(*given, **named)
    return refused.value


def detection_refusal_of(
    call: Callable[Given, object], *given: Given.args, **named: Given.kwargs
) -> DetectionError:
    """That of a picture, with the cause and the evidence."""
    refusal = refusal_of(call, *given, **named)
    assert isinstance(refusal, DetectionError)
    return refusal
