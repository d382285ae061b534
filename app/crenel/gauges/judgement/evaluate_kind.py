"""How a kind of performance test is evaluated: what it needs of a plan, and what it makes of the
data."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from crenel.errors import OperationError
from crenel.formats.results.calibration import Calibration
from crenel.gauges.judgement.document import ImpliedOffsetPart, LengthPoint, SphereMeasurement
from crenel.gauges.judgement.evaluate import Measured
from crenel.gauges.judgement.evaluate_measured_data import MeasuredData
from crenel.gauges.plan.document import PerformancePlan
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.plan.evaluate_artefacts import Artefact, problems_of_artefact
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm


@dataclass(frozen=True)
class Evaluated:
    """What the data of a test gave: its quantities, and the fields that only some kinds have."""

    measured: tuple[Measured, ...]
    spheres: tuple[SphereMeasurement, ...] = ()
    offset: ImpliedOffsetPart | None = None
    lengths: tuple[LengthPoint, ...] = ()
    notes: tuple[Text, ...] = ()
    undecided: tuple[Text, ...] = ()
    """Why values that are stated are not decided."""


class Evaluation(ABC):
    """The evaluation of a kind of test."""

    has_size: ClassVar[bool] = True
    """Whether its artefact has a size or a length, which is brought to 20 °C."""

    @abstractmethod
    def artefact(self, plan: PerformancePlan) -> Artefact | None:
        """What the test is done on; None if the plan has none of this kind."""

    def check(self, plan: PerformancePlan) -> None:
        """Checks that a plan can be evaluated.

        Raises:
            OperationError: it has no artefact of this kind.
        """
        if self.artefact(plan) is None:
            raise OperationError(
                "plan-without-artefact", message("plan-without-artefact", which=plan.kind)
            )

    def list_problems(
        self, plan: PerformancePlan, calibration: Calibration | None, arm: AnyArm | None
    ) -> list[Text]:
        """Why no figure of a plan can be stated by its artefact; empty if they can.

        Args:
            arm: by which lengths are measured.
        """
        artefact = self.artefact(plan)
        if artefact is None:
            return [message("artefact-missing")]
        return problems_of_artefact(artefact, plan, calibration, arm)

    def features(self, plan: PerformancePlan) -> list[str]:
        """The groups of touches, in their order."""
        return []

    @abstractmethod
    def measure(self, data: MeasuredData, problems: list[Text]) -> Evaluated:
        """Computes the quantities. ``problems`` of the artefact, for which no figure is stated, may
        grow."""

    def unknown(self, plan: PerformancePlan) -> Mapping[Quantity, Text]:
        """Quantities that are not decided by what the certificate does not state, with why."""
        return {}

    def notes(self, plan: PerformancePlan, filtered: bool) -> list[Text]:
        """What should be known of the procedure.

        Args:
            filtered: whether the scans were filtered.
        """
        return []
