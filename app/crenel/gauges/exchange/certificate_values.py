"""The numbers of a Digital Calibration Certificate: lengths with their uncertainty."""

import math
import re
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from crenel.formats.xml_text import local_name

DCC, SI = "https://ptb.de/dcc", "https://ptb.de/si"
PREFIXES = {
    "": 1.0, "kilo": 1e3, "deci": 1e-1, "centi": 1e-2, "milli": 1e-3, "micro": 1e-6, "nano": 1e-9,
}  # fmt: skip
UNIT = re.compile(r"(?:\\(kilo|deci|centi|milli|micro|nano))?\\met(?:re|er)")


@dataclass(frozen=True)
class CertifiedLength:
    """A length that a certificate states."""

    names: tuple[str, ...]
    """In every language of the certificate."""
    kinds: tuple[str, ...]
    """Its ``refType`` words, and those of the list and the result that it stands in."""
    value_mm: float
    standard_uncertainty_mm: float | None
    """k = 1; None if none is stated."""

    @property
    def label(self) -> str:
        return self.names[0] if self.names else " ".join(self.kinds)


def result_lengths(root: ET.Element) -> list[CertifiedLength]:
    """Every single length among the results of a certificate, in their order.

    Lists of values are lists of lengths. Quantities of the method, of the conditions and of
    metadata are no results.

    Source:
        PTB, DCC 3.x (``dcc:quantity``) and D-SI 1.x to 2.x (``si:real``, ``si:realListXMLList``).
    """
    found: list[CertifiedLength] = []
    for result in root.iter(f"{{{DCC}}}result"):
        _collect(result, (), found)
    return found


def _collect(element: ET.Element, kinds: tuple[str, ...], found: list[CertifiedLength]) -> None:
    own = (*kinds, *element.get("refType", "").split())
    for child in element:
        name = local_name(child)
        if name == "quantity":
            inner = (*own, *child.get("refType", "").split())
            found += _quantity_lengths(child, inner)
        elif name in ("data", "list"):
            _collect(child, own, found)


def _quantity_lengths(quantity: ET.Element, kinds: tuple[str, ...]) -> list[CertifiedLength]:
    names = tuple(
        text
        for content in quantity.findall(f"{{{DCC}}}name/{{{DCC}}}content")
        if (text := (content.text or "").strip())
    )
    reals = [*quantity.findall(f"{{{SI}}}real"), *quantity.findall(f"{{{SI}}}realListXMLList")]
    hybrid = quantity.find(f"{{{SI}}}hybrid")
    reals += [] if hybrid is None else list(hybrid)
    for real in reals:
        lengths = _real_lengths(real)
        if lengths:
            return [CertifiedLength(names, kinds, value, sd) for value, sd in lengths]
    return []


def _real_lengths(real: ET.Element) -> list[tuple[float, float | None]]:
    """Values in mm and their standard uncertainties; empty if they are no lengths,
    or none that a number can hold."""
    units = _texts(real, "unit", "unitXMLList")
    values = _numbers(_texts(real, "value", "valueXMLList"))
    scales = [scale for unit in units if (scale := _in_mm(unit)) is not None]
    if not values or not scales or len(scales) < len(units) or len(scales) not in (1, len(values)):
        return []
    spread = _standard_uncertainties(real, len(values))
    each = zip(values, _repeat(scales, len(values)), spread, strict=True)
    found = [(value * scale, None if sd is None else sd * scale) for value, scale, sd in each]
    finite = all(math.isfinite(value) and math.isfinite(sd or 0.0) for value, sd in found)
    return found if finite else []


def _standard_uncertainties(real: ET.Element, count: int) -> list[float | None]:
    """In the value's unit; of an expanded one, divided by its coverage factor."""
    parts = {
        local_name(one).removesuffix("XMLList"): (one.text or "").split() for one in real.iter()
    }
    expanded = _numbers(parts.get("valueExpandedMU") or parts.get("uncertainty") or [])
    factors = _numbers(parts.get("coverageFactor") or [])
    if len(expanded) in (1, count) and len(factors) in (1, count) and min(factors) > 0:
        pairs = zip(_repeat(expanded, count), _repeat(factors, count), strict=True)
        return [abs(value) / factor for value, factor in pairs]
    # the second of a coverage interval of D-SI 1 and 2
    standard = _numbers(parts.get("valueStandardMU") or parts.get("standardUnc") or [])
    if len(standard) in (1, count):
        return [abs(one) for one in _repeat(standard, count)]
    return [None] * count


def _repeat(values: list[float], count: int) -> list[float]:
    """One value for all, or one for each."""
    return values if len(values) == count else values[:1] * count


def _texts(element: ET.Element, *names: str) -> list[str]:
    for name in names:
        child = element.find(f"{{{SI}}}{name}")
        if child is not None and child.text:
            return child.text.split()
    return []


def _numbers(texts: list[str]) -> list[float]:
    """Finite numbers; none if one of them is not."""
    try:
        values = [float(text) for text in texts]
    except ValueError:
        return []
    return values if all(math.isfinite(value) for value in values) else []


def _in_mm(unit: str) -> float | None:
    """Millimetres of a D-SI unit; None if it is no length."""
    match = UNIT.fullmatch(unit)
    return None if match is None else 1e3 * PREFIXES[match[1] or ""]
