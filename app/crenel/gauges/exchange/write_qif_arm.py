"""The contact test of ASME B89.4.22 as the accuracy of an articulated arm in QIF 3.0."""

from collections.abc import Callable, Sequence
from statistics import fmean, stdev
from xml.etree import ElementTree as ET

from crenel.formats.exchange.qif import qif_name
from crenel.formats.xml_text import add
from crenel.gauges.contact.maths import PLACEMENTS, SEATS, SPHERES
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.plan.document_symbols import Quantity


def in_mm(value_um: float) -> str:
    """Micrometres in mm, to the nanometre."""
    return f"{value_um / 1e3:.6f}"


def air_temperatures_c(document: PerformanceFile) -> list[float]:
    """The air temperatures that were noted during the test, in °C."""
    return [value for value in document.temperature_c if value is not None]


SEAT_ORDER = (("Near", 0), ("Far", 2), ("Middle", 1))
"""As QIF lists the seats, and their place among the values of a figure."""

Part = Callable[[ET.Element], None]


def arm_test_parts(document: PerformanceFile) -> list[Part]:
    """Writers of the parts of ``AACMMB89Test`` that the result is complete for, in their order."""
    parts = (_diameter_part(document), _seats_part(document), _volume_part(document))
    return [one for one in parts if one is not None]


def add_arm(
    root: ET.Element, document: PerformanceFile, parts: Sequence[Part], number: int
) -> None:
    """The arm as a measurement device whose accuracy is the contact test.

    Args:
        number: the QIF id of the device.

    Source:
        ANSI/DMSC Quality Information Framework 3.0, measurement resources: ``AACMM``.
    """
    devices = add(
        add(root, qif_name("MeasurementResources")), qif_name("MeasurementDevices"), n="1"
    )
    arm = add(devices, qif_name("AACMM"), id=str(number))
    add(arm, qif_name("Name"), "Articulated arm")
    if document.serial_numbers.arm:
        add(arm, qif_name("SerialNumber"), document.serial_numbers.arm)
    accuracy = add(add(arm, qif_name("Accuracies"), n="1"), qif_name("AACMMAccuracy"))
    # required even if nothing is known of the conditions
    conditions = add(accuracy, qif_name("EnvironmentalRange"))
    temperatures = air_temperatures_c(document)
    if temperatures:
        add(conditions, qif_name("MaxAmbientTemperature"), f"{max(temperatures):.2f}")
        add(conditions, qif_name("MinAmbientTemperature"), f"{min(temperatures):.2f}")
    test = add(accuracy, qif_name("AACMMB89Test"))
    for part in parts:
        part(test)
    source = f"{document.software.name} {document.software.version}, {document.id}"
    add(add(accuracy, qif_name("AccuracySource")), qif_name("OtherAccuracySource"), source)


def _values(document: PerformanceFile, quantity: Quantity, count: int) -> list[float]:
    """The values of a figure in µm; empty unless it has exactly that many."""
    for figure in document.figures:
        if figure.quantity == quantity and figure.value is not None:
            known = [value for value in figure.values if value is not None]
            return known if len(known) == len(figure.values) == count else []
    return []


def _diameter_part(document: PerformanceFile) -> Part | None:
    errors = _values(document, "effective-diameter", SPHERES)
    sphere = document.sphere
    if not errors or sphere is None:
        return None

    def write(test: ET.Element) -> None:
        part = add(test, qif_name("EffectiveDiameterPerformanceTest"))
        # decimals without a unit, and so in the file's unit of length
        add(part, qif_name("AverageDiameter"), in_mm(1e3 * sphere.diameter_mm + fmean(errors)))
        add(part, qif_name("StandardDeviation"), in_mm(stdev(errors)))

    return write


def _seats_part(document: PerformanceFile) -> Part | None:
    largest = _values(document, "articulation-largest", SEATS)
    two_s = _values(document, "articulation-two-s", SEATS)
    if not largest or not two_s:
        return None

    def write(test: ET.Element) -> None:
        part = add(test, qif_name("SinglePointArticulationPerformanceTest"))
        for name, values in (
            ("MaxDeviationFromAverage", largest),
            ("TwiceStandardDeviation", two_s),
        ):
            for seat, place in SEAT_ORDER:
                add(part, qif_name(f"{name}{seat}"), in_mm(values[place]))

    return write


def _volume_part(document: PerformanceFile) -> Part | None:
    deviations = _values(document, "volumetric-largest", PLACEMENTS)
    if not deviations:
        return None

    def write(test: ET.Element) -> None:
        part = add(test, qif_name("VolumetricPerformanceTest"))
        listed = add(part, qif_name("DeviationsFromCalibration"), n=str(PLACEMENTS))
        for value in deviations:
            add(listed, qif_name("LinearValue"), in_mm(value))
        # about their mean, as QIF defines it: not the 2 RMS of the standard, a characteristic
        add(part, qif_name("TwiceStandardDeviation"), in_mm(2 * stdev(deviations)))

    return write
