"""``arm-check.json``: what a daily check of the arm found, beside the points it was taken from."""

from typing import ClassVar, Literal

from app.files.calibration import Input
from app.files.documents import Document, NotNegative, Number, Vector3
from app.files.software import Software

ARM_CHECK = "arm-check.json"


class ArmCheckFile(Document):
    """Of the tip's centre in one seat, along x, y and z of the arm's frame."""

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
    limit_um: NotNegative | None = None
    """Of (max - min)/2 along any axis."""
    verdict: Literal["good", "attention", "bad", "neutral"]
    temperature_c: Number | None = None
    inputs: tuple[Input, ...] = ()
    software: Software
