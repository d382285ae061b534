"""``arm-check.json``: what a daily check of the arm found, beside the points it was taken from."""

from typing import ClassVar, Literal

from crenel.formats.json_document import Document, NotNegative, Number, Positive, Software, Vector3
from crenel.formats.results.calibration import Input
from crenel.formats.results.decision_rule import FORMER_ARM_RULE, FORMER_CHECK_RULE, RulePart
from crenel.messages.message import Text
from crenel.metrology.decision import Decision

ARM_CHECK = "arm-check.json"


class ArmCheckFile(Document):
    """A check of the tip's centre in one seat, along x, y and z of the arm's frame, and in
    space."""

    FORMAT: ClassVar[str] = "crenel/arm-check"

    checked_at: str
    operator: str = ""
    station: str = ""
    simulated: bool = False
    arm_name: str
    arm_serial: str
    points: int
    half_range_um: Vector3
    """(max - min)/2."""
    two_sigma_um: Vector3
    encoders_two_sigma_um: Vector3
    """What the encoders' noise alone would give."""
    largest_um: NotNegative | None = None
    """Largest distance of a point from the mean of all; None, like the next, in older files."""
    two_s_um: NotNegative | None = None
    """Twice the standard deviation of these distances."""
    limit_um: NotNegative | None = None
    """The limit of (max - min)/2 along any axis."""
    rule: RulePart = FORMER_ARM_RULE
    """The uncertainty it is applied to is zero: that of seat and tip is not stated."""
    verdict: Literal["good", "attention", "bad", "neutral"]
    temperature_c: Number | None = None
    inputs: tuple[Input, ...] = ()
    software: Software


TIP_CHECK = "tip-check.json"


class TipCheckFile(Document):
    """A check of the tip by touches of a sphere of known size."""

    FORMAT: ClassVar[str] = "crenel/tip-check"

    checked_at: str
    operator: str = ""
    station: str = ""
    simulated: bool = False
    arm_name: str
    arm_serial: str
    sphere_mm: Positive
    sphere_standard_uncertainty_mm: NotNegative = 0.0
    touches: int
    diameter_mm: Positive
    expected_mm: Positive
    error_um: Number
    expanded_uncertainty_um: NotNegative
    """The expanded uncertainty of the error, k = 2."""
    scatter_um: NotNegative
    bend_um: NotNegative | None = None
    limit_um: NotNegative | None = None
    rule: RulePart = FORMER_CHECK_RULE
    """For the error; the scatter is compared with the limit directly."""
    decision: Decision
    words: Text
    """What was found, in a sentence."""
    temperature_c: Number | None = None
    inputs: tuple[Input, ...] = ()
    software: Software
