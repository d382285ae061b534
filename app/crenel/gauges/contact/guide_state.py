"""The state of a contact test. Pure."""

from dataclasses import dataclass
from typing import ClassVar

from crenel.gauges.contact.guide_sequence import features_of, next_feature, touches_of
from crenel.gauges.plan.document import Kind
from crenel.gauges.session.entries import SphereContact
from crenel.gauges.session.state import PerformanceState

CONTACT_STEPS = ("diameter", "seats", "bar")


@dataclass(frozen=True)
class ContactState(PerformanceState):
    """Where a contact test stands."""

    test: ClassVar[Kind] = "contact"
    between: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    first: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    touching: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    by_touch: ClassVar[bool] = True

    @property
    def steps(self) -> tuple[str, ...]:
        """There is none for an artefact that the test is done without."""
        left_out = {"diameter": not self.gauge, "bar": not self.bar}
        return tuple(step for step in super().steps if not left_out.get(step, False))

    @property
    def feature(self) -> str:
        return next_feature(self.step, len(self.of_step)) if self.step in self.touching else ""

    @property
    def of_step(self) -> tuple[SphereContact, ...]:
        if self.step not in self.touching:
            return ()
        parts = set(features_of(self.step))
        return tuple(touch for touch in self.counted if touch.feature in parts)

    @property
    def wanted(self) -> int:
        return touches_of(self.step)
