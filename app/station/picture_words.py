"""What is wrong with the live picture, as findings."""

from app.metrology.detection.picture import Image, PictureMeasures, findings_of, measured
from app.metrology.refusal import Refusal
from app.station.findings import Finding, capital
from app.station.stillness import Stillness


def picture_words(image: Image) -> list[Finding]:
    """Exposure, saturation and sharpness in words; empty when all is well."""
    return measured_words(image)[1]


def measured_words(image: Image) -> tuple[PictureMeasures | None, list[Finding]]:
    """The same with the measures, which a picture that is not grey has none of."""
    try:
        measures = measured(image)
    except Refusal as refusal:
        return None, [refused(refusal)]
    return measures, [
        Finding("attention", capital(f.text), capital(f.remedy)) for f in findings_of(measures)
    ]


def refused(refusal: Refusal) -> Finding:
    """A refusal as a finding."""
    text = refusal.what if not refusal.why else f"{refusal.what}: {refusal.why}"
    return Finding("attention", capital(text), capital(refusal.remedy))


def still_words(stillness: Stillness) -> list[Finding]:
    """Asks to hold still when the arm moves; empty when it is still."""
    return [] if stillness.still else [Finding("attention", stillness.text, "Hold still")]
