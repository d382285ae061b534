"""The state of a performance test, as its journal gives it; each kind adds what it has of its own.
Pure."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar, Literal, Self

from crenel.gauges.plan.document import Kind
from crenel.gauges.plan.document_symbols import DEFAULT_EDITION, Quantity
from crenel.gauges.plan.maths_temperature import (
    MeanTemperature,
    TemperatureSpan,
    mean_temperature,
)
from crenel.gauges.session.changes import Payload
from crenel.gauges.session.entries import (
    NOT_MEASURED,
    DatasheetLimit,
    SphereContact,
    Temperatures,
    TestScan,
)

ArtefactShape = Literal["sphere", "plane", "length"]


@dataclass(frozen=True)
class PerformanceState(ABC):
    """Where a performance test stands."""

    test: ClassVar[Kind]
    between: ClassVar[tuple[str, ...]]
    """The steps between the choice of the artefact and the temperatures at the end."""
    first: ClassVar[tuple[str, ...]]
    """Those that can be the first of them, until whose first touch or scan the artefact can be
    changed."""
    touching: ClassVar[tuple[str, ...]] = ()
    """Steps in which places are touched."""
    scanning: ClassVar[tuple[str, ...]] = ()
    """Steps in which only scans are made."""
    by_touch: ClassVar[bool] = False
    """Whether the test can be done without a calibrated sensor."""
    touched_and_scanned: ClassVar[tuple[str, ...]] = ()
    """Steps of touches in which scans can be made, too, as the operator chooses."""
    scans_most: ClassVar[int] = 60
    shape: ClassVar[ArtefactShape]
    """What the gauges of the test are."""
    with_bar: ClassVar[bool] = False
    """Whether a ball bar is chosen beside the gauge; the test can be done without one of them."""
    limits_grow: ClassVar[bool] = False
    """Whether limits may grow with the length: A + L/K, up to B."""
    quantities: ClassVar[tuple[Quantity, ...]]
    """What it measures, on all artefacts that it can be done with."""
    edition: ClassVar[str] = DEFAULT_EDITION
    """The edition of the standards that it follows."""

    session_id: str = ""
    rev: int = 0
    started_at: str = ""
    calibration_id: str = ""
    """Empty if a test by touch is done without one."""
    arm: str = ""
    """Without a calibration: of the data folder's arms, by the name of its file."""
    step: str = "artefact"
    reached: str = "artefact"
    gauge: str = ""
    """The gauge of the data folder, by the name of its file; in a contact test the sphere, empty if
    it is done without one."""
    bar: str = ""
    """The bar of the contact test; empty if it is done without one. Kept for the next such test, as
    are ``positions`` and ``by_scan``."""
    positions: int = 1
    """Of the sphere."""
    by_scan: bool = False
    """Whether the lengths of a ball bar are measured by scan, too."""
    position: int = 1
    """Of the sphere, now."""
    confirmed: int = 0
    """Touches that are not taken back any more."""
    limits: Mapping[str, DatasheetLimit] = field(default_factory=dict)
    """Maximum permissible errors by the quantity."""
    at_begin: Temperatures = NOT_MEASURED
    at_end: Temperatures | None = None
    """None until they are set or confirmed at the end."""
    expanded_c: float = 0.0
    """Uncertainty of the artefact's temperature, k = 2."""
    plan_sha256: str = ""
    """The hash of the plan's file, from the first touch on."""
    setup: Payload = field(default_factory=dict)
    """The station's settings of scans at the first touch."""
    touches: tuple[SphereContact, ...] = ()
    undone: tuple[int, ...] = ()
    """Touches that were taken back since the last one was taken; they can be put back."""
    scans: tuple[TestScan, ...] = ()
    result: str = ""
    """The result of the evaluation; empty until it was evaluated."""
    failed: Payload | None = None
    """Why it could not be evaluated."""
    ended: str = ""
    """accepted or abandoned; empty while the session is open."""

    @property
    def frozen(self) -> bool:
        """Whether the plan stands."""
        return bool(self.plan_sha256)

    @property
    def steps(self) -> tuple[str, ...]:
        """The steps of this test."""
        return self.all_steps

    @property
    def all_steps(self) -> tuple[str, ...]:
        """The steps of this kind of test, also those that this test is done without."""
        return ("artefact", *self.between, "temperatures", "review")

    def plan_fields(self, by_scan: bool) -> Mapping[str, object]:
        """The fields of the plan that only this kind of test has.

        Args:
            by_scan: whether lengths are scanned, too.
        """
        return {}

    def list_quantities(self, by_scan: bool) -> tuple[Quantity, ...]:
        """What this test measures.

        Args:
            by_scan: whether lengths are scanned, too.
        """
        return self.quantities

    @property
    def temperatures(self) -> Temperatures:
        """Those that are asked for now: at the end, first those of the beginning."""
        return self.at_begin if self.step == "artefact" else self.at_end or self.at_begin

    @property
    def artefact(self) -> MeanTemperature | None:
        """The temperature of the artefact, as far as it is known; None: not measured."""
        end_c = None if self.at_end is None else self.at_end.artefact_c
        return mean_temperature(
            TemperatureSpan(self.at_begin.artefact_c, end_c), self.expanded_c / 2
        )

    @property
    def counted(self) -> tuple[SphereContact, ...]:
        """Touches that count."""
        return tuple(touch for touch in self.touches if not touch.voided)

    def of(self, feature: str) -> tuple[SphereContact, ...]:
        """Touches that count of a part of the test."""
        return tuple(touch for touch in self.counted if touch.feature == feature)

    @property
    @abstractmethod
    def feature(self) -> str:
        """The part of the test that is touched now; empty while none is."""

    @property
    @abstractmethod
    def of_step(self) -> tuple[SphereContact, ...]:
        """Touches of the present step, in their order."""

    @property
    @abstractmethod
    def wanted(self) -> int:
        """How many touches the present step takes."""

    @property
    def in_scan(self) -> bool:
        """Whether scans are made now, not touches."""
        return self.step in self.scanning

    @property
    def whole_place(self) -> int:
        """The place of a bar that was touched last, if it has all its touches; else 0."""
        return 0

    @property
    def due(self) -> object:
        """The scan that is to be made next in a step of touches and scans; None without any."""
        return None

    @property
    def open_scan(self) -> TestScan | None:
        """The one that is under way."""
        last = self.scans[-1] if self.scans else None
        return last if last is not None and not last.ended and not last.aside else None

    # -- what a row changes ------------------------------------------------------

    def scan_of_row(self, payload: Payload, number: int) -> TestScan:
        """The scan that a row begins."""
        raise ValueError("a test by touch alone has no scans")

    def scan_values(self, payload: Payload) -> Mapping[str, object]:
        """What a row says that a scan shows, by the scan's fields."""
        return {}

    def count_confirmed_at_touch(self) -> int:
        """Touches that one more confirms."""
        return self.confirmed

    def count_confirmed_at_scan(self) -> int:
        """Touches that a scan confirms."""
        return self.confirmed

    def begin(self, payload: Payload) -> Self:
        """Takes what is known of the artefact once it is confirmed."""
        return self

    def next_step(self) -> Self:
        """Goes on once a step is confirmed."""
        steps = self.steps
        return replace(self, step=steps[steps.index(self.step) + 1])
