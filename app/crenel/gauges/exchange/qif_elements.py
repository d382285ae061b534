"""Names and numbers of QIF 3.0 documents."""

from crenel.gauges.judgement.document import PerformanceFile

QIF = "http://qifstandards.org/xsd/qif3"


def qif_name(name: str) -> str:
    """An element's name with the namespace of QIF 3.0."""
    return f"{{{QIF}}}{name}"


def in_mm(value_um: float) -> str:
    """Micrometres in mm, to the nanometre."""
    return f"{value_um / 1e3:.6f}"


def air_temperatures_c(document: PerformanceFile) -> list[float]:
    """The air temperatures that were noted during the test, in °C."""
    return [value for value in document.temperature_c if value is not None]
