"""What the view of a verification depends on beside its journal. Pure."""

from collections.abc import Mapping
from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.gauges.plan.document_gauge import GaugeFile, VerificationLimits
from crenel.gauges.quick.document import FigurePart, VerificationVerdict
from crenel.gauges.quick.evaluate import CloudErrors
from crenel.gauges.quick.evaluate_gauge import GaugeFit
from crenel.gauges.quick.maths.probed_gauge import ProbedGauge
from crenel.gauges.session.acts import GaugeLive
from crenel.guide.common.datasheet_library import Gauges
from crenel.metrology.decision import DecisionRule


@dataclass(frozen=True)
class CloudResults:
    """What the clouds that count show."""

    fits: Mapping[int, GaugeFit]
    """The fits of every cloud that was measured, by its number."""
    errors: Mapping[int, CloudErrors]
    figures: tuple[FigurePart, ...]
    verdict: VerificationVerdict | None


@dataclass(frozen=True, eq=False, kw_only=True)
class VerifyLive(GaugeLive):
    """The station as the verification sees it."""

    gauges: Gauges[GaugeFile]
    gauge: GaugeFile | None
    """The chosen one; from the touches on the session's own copy."""
    limits: VerificationLimits
    touched: ProbedGauge | OperationError | None
    """The gauge by the touches, or why they do not fix it; None without touches."""
    judged: CloudResults
    rule: DecisionRule
