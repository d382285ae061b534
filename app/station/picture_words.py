"""What is wrong with the live picture, as findings."""

import numpy as np

from app.metrology.detection.picture import Image, picture_findings
from app.metrology.refusal import Refusal
from app.metrology.stripe import saturation_level
from app.station.findings import Finding
from app.station.stillness import Stillness


def picture_words(image: Image) -> list[Finding]:
    """Exposure, saturation and sharpness in words; empty when all is well."""
    try:
        return [Finding("attention", f.text, f.remedy) for f in picture_findings(image)]
    except Refusal as refusal:
        return [refused(refusal)]


def refused(refusal: Refusal) -> Finding:
    """A refusal as a finding."""
    text = refusal.what if not refusal.why else f"{refusal.what}: {refusal.why}"
    return Finding("attention", _sentence(text), _sentence(refusal.remedy))


def still_words(stillness: Stillness) -> list[Finding]:
    """Asks to hold still when the arm moves; empty when it is still."""
    return [] if stillness.still else [Finding("attention", stillness.text, "Hold still")]


def saturated_percent(image: Image) -> float:
    """Share of the pixels at full scale, in percent."""
    clipped = np.count_nonzero(image >= saturation_level(image))
    return 100.0 * float(clipped) / image.size


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]
