"""``tip-check.json``: what a check of the tip found, beside the touches it was taken from."""

from typing import ClassVar, Literal

from app.files.calibration import Input
from app.files.documents import Document, NotNegative, Number, Positive
from app.files.software import Software

TIP_CHECK = "tip-check.json"


class TipCheckFile(Document):
    """Of the tip, by touches of a sphere of known size."""

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
    """Of the error, k = 2."""
    scatter_um: NotNegative
    bend_um: NotNegative | None = None
    limit_um: NotNegative | None = None
    decision: Literal["pass", "fail", "uncertain", "none"]
    words: str
    """What was found, in a sentence."""
    temperature_c: Number | None = None
    inputs: tuple[Input, ...] = ()
    software: Software
