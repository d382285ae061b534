"""The state of a contact test. Pure."""

from dataclasses import dataclass
from typing import ClassVar

from crenel.gauges.contact.guide_sequence import features_of, next_feature, touches_of
from crenel.gauges.plan.document import Kind
from crenel.gauges.plan.document_symbols import CONTACT_EDITION, Quantity
from crenel.gauges.session.entries import SphereContact
from crenel.gauges.session.state import ArtefactShape, PerformanceState

CONTACT_STEPS = ("diameter", "seats", "bar")


@dataclass(frozen=True)
class ContactState(PerformanceState):
    """Where a contact test stands."""

    test: ClassVar[Kind] = "contact"
    shape: ClassVar[ArtefactShape] = "sphere"
    quantities: ClassVar[tuple[Quantity, ...]] = (
        "effective-diameter",
        "articulation-largest",
        "articulation-two-s",
        "volumetric-largest",
        "volumetric-two-rms",
    )
    edition: ClassVar[str] = CONTACT_EDITION
    between: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    first: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    touching: ClassVar[tuple[str, ...]] = CONTACT_STEPS
    by_touch: ClassVar[bool] = True

    @property
    def steps(self) -> tuple[str, ...]:
        """There is none for an artefact that the test is done without."""
        left_out = {"diameter": not self.gauge, "bar": not self.bar}
        return tuple(step for step in super().steps if not left_out.get(step, False))

    def list_quantities(self, by_scan: bool) -> tuple[Quantity, ...]:
        left_out = {"effective": not self.gauge, "volumetric": not self.bar}
        found = self.quantities
        return tuple(one for one in found if not left_out.get(one.partition("-")[0], False))

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
