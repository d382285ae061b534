"""What is known of a part while it is inspected. It needs nothing that measures: a station without
an inspection loads none of that."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from crenel.errors import OperationError
from crenel.metrology.transforms import Floats

if TYPE_CHECKING:
    from crenel.parts.document_results import DimensionResult


@dataclass(frozen=True)
class FrameKnowledge:
    """The part frame, and what it is known to: k = 1; None where only scatter is known."""

    T_arm_part: Floats
    datums_um: float | None
    far_um: float | None
    """At the furthest corner of the nominal features."""


@dataclass(frozen=True)
class FoundSoFar:
    """What is known of the part; without a frame yet, residuals alone."""

    frame: FrameKnowledge | None = None
    is_full: bool = True
    dimensions: Mapping[str, "DimensionResult"] = field(default_factory=dict)
    residuals_um: Mapping[int, float] = field(default_factory=dict)
    """By the number of the touch, from 0."""
    refusal: OperationError | None = None
    """Why the frame or a feature cannot be stated."""
