"""The Digital Calibration Certificate of an artefact: of a sphere, or of a length standard."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal
from xml.etree import ElementTree as ET

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_all_errors
from crenel.formats.xml_text import parse_xml
from crenel.gauges.exchange.certificate_head import (
    CertificateHead,
    certificate_head,
    check_certificate,
    open_certificate,
)
from crenel.gauges.exchange.certificate_values import CertifiedLength, result_lengths
from crenel.gauges.plan.document import SpherePart
from crenel.gauges.plan.document_gauge import LARGEST_RADIUS_MM, GaugeFile
from crenel.gauges.plan.document_length_standard import LengthPart, LengthStandardFile
from crenel.messages.message import join, message, rounded

DIAMETER = re.compile("diameter|durchmesser")
RADIUS = re.compile("radius")
SIZE = re.compile(f"{DIAMETER.pattern}|{RADIUS.pattern}")
FORM = re.compile("(?<![a-z])form|kugelform|roundness|sphericity|rundheit")
LENGTH = re.compile("length|länge|distance|abstand|spacing")
DEVIATION = re.compile("deviation|abweichung|error|difference")
"""Such a quantity is the difference from a nominal size, not the size."""
OF_RESULT = "basic_measuredvalue"
SMALLEST_MM, LONGEST_MM = 1e-2, 1e5


@dataclass(frozen=True)
class CertifiedSphere:
    """What a certificate says of a sphere."""

    sphere: SpherePart
    head: CertificateHead

    @property
    def gauge(self) -> GaugeFile:
        """The same as a gauge of verifications."""
        sphere = self.sphere
        return GaugeFile(
            shape="sphere",
            radius_mm=sphere.diameter_mm / 2,
            name=sphere.name,
            serial_number=sphere.serial_number,
            certificate=sphere.certificate,
            standard_uncertainty_um=sphere.diameter_sd_um / 2,
            form_um=sphere.form_um,
            form_sd_um=sphere.form_sd_um,
            valid_until=sphere.valid_until,
            issued_on=self.head.issued_on,
        )


def read_sphere_certificate(
    path: Path, diameter_name: str = "", form_name: str = ""
) -> CertifiedSphere:
    """Reads a DCC 3.x of a calibrated sphere.

    Args:
        diameter_name, form_name: part of the quantity's name or ``refType``, if the certificate
            states several diameters or forms.

    Raises:
        OperationError: unreadable, no DCC, another major version, no diameter or several, or a
            diameter without an uncertainty.

    Source:
        PTB, Digital Calibration Certificate, version 3.
    """
    root = open_certificate(path)
    with convert_all_errors(path):
        return _find_sphere(root, path, diameter_name, form_name)


def parse_sphere_certificate(text: str, path: Path) -> CertifiedSphere:
    """Reads the text of a file of this name; as ``read_sphere_certificate``."""
    root = check_certificate(parse_xml(text, path), path)
    with convert_all_errors(path):
        return _find_sphere(root, path)


def _find_sphere(
    root: ET.Element, path: Path, diameter_name: str = "", form_name: str = ""
) -> CertifiedSphere:
    lengths = result_lengths(root)
    diameter = _choose(path, lengths, SIZE, diameter_name, "diameter")
    form = _choose(path, lengths, FORM, form_name, "form", diameter)
    assert diameter is not None
    twice = 2.0 if _is_named(diameter, RADIUS) and not _is_named(diameter, DIAMETER) else 1.0
    sd_mm = _uncertainty_mm(path, diameter, 2 * LARGEST_RADIUS_MM / twice)
    form_mm = 0.0 if form is None else abs(form.value_mm)
    form_sd_mm = (0.0 if form is None else form.standard_uncertainty_mm) or 0.0
    if form is not None and max(form_mm, form_sd_mm) >= diameter.value_mm:
        raise _impossible_error(path, form)
    head = certificate_head(root)
    sphere = SpherePart(
        name=head.name,
        serial_number=head.serial_number,
        certificate=head.certificate,
        valid_until=head.valid_until,
        diameter_mm=twice * diameter.value_mm,
        diameter_sd_um=1e3 * twice * sd_mm,
        form_um=1e3 * form_mm,
        form_sd_um=1e3 * form_sd_mm,
    )
    return CertifiedSphere(sphere, head)


def read_length_certificate(
    path: Path, kind: Literal["ball-bar", "step-gauge"], length_name: str = ""
) -> LengthStandardFile:
    """Reads a DCC 3.x of a ball bar or step gauge; its expansion is not read.

    Args:
        length_name: part of the name or ``refType`` of the lengths, if others have such names too.

    Raises:
        OperationError: as ``read_sphere_certificate``; no length, or one without an uncertainty.
    """
    root = open_certificate(path)
    with convert_all_errors(path):
        return _find_lengths(root, path, kind, length_name)


def _find_lengths(
    root: ET.Element, path: Path, kind: Literal["ball-bar", "step-gauge"], length_name: str
) -> LengthStandardFile:
    found = result_lengths(root)
    wanted = re.compile(re.escape(length_name.lower())) if length_name else LENGTH
    known = [one for one in found if _is_named(one, wanted)]
    if not length_name:
        known = [one for one in known if not _is_named(one, DEVIATION)]
        known = [one for one in known if OF_RESULT in map(str.lower, one.kinds)] or known
    if not known:
        raise _selection_error(path, "length", known, found)
    head = certificate_head(root)
    spheres = {one.value_mm for one in found if _is_named(one, DIAMETER) and one not in known}
    return LengthStandardFile(
        name=head.name,
        serial_number=head.serial_number,
        certificate=head.certificate,
        valid_until=head.valid_until,
        issued_on=head.issued_on,
        kind=kind,
        sphere_diameter_mm=spheres.pop() if kind == "ball-bar" and len(spheres) == 1 else None,
        lengths=tuple(
            LengthPart(
                length_mm=one.value_mm,
                standard_uncertainty_um=1e3 * _uncertainty_mm(path, one, LONGEST_MM),
            )
            for one in sorted(known, key=lambda one: one.value_mm)
        ),
    )


def _uncertainty_mm(path: Path, one: CertifiedLength, largest_mm: float) -> float:
    """In mm, k = 1.

    Raises:
        OperationError: no artefact has such a size, or the certificate states no uncertainty.
    """
    if one.standard_uncertainty_mm is None and 0 < one.value_mm <= largest_mm:
        why = message("certified-size-without-uncertainty", name=one.label)
        advice = message("enter-artefact-by-hand")
        raise OperationError("certificate-without-uncertainty", display_path(path), why, advice)
    sd_mm = one.standard_uncertainty_mm or 0.0
    if not max(sd_mm, SMALLEST_MM) < one.value_mm <= largest_mm:
        raise _impossible_error(path, one)
    return sd_mm


def _impossible_error(path: Path, one: CertifiedLength) -> OperationError:
    size, known = rounded(one.value_mm, "mm"), rounded(one.standard_uncertainty_mm or 0.0, "mm")
    return OperationError(
        "certificate-implausible",
        display_path(path),
        message("certified-size-impossible", name=one.label, size=size, known=known),
        message("enter-artefact-by-hand"),
    )


def _choose(
    path: Path,
    lengths: Sequence[CertifiedLength],
    kind: re.Pattern[str],
    name: str,
    what: Literal["diameter", "form"],
    other: CertifiedLength | None = None,
) -> CertifiedLength | None:
    """The one quantity of a kind; a form may be missing."""
    known = [one for one in lengths if one is not other]
    if name:
        known = [one for one in known if _is_named(one, re.compile(re.escape(name.lower())))]
    else:
        known = [one for one in known if _is_named(one, kind)]
        if what == "diameter":
            known = [one for one in known if not _is_named(one, DEVIATION)]
        measured = [one for one in known if OF_RESULT in map(str.lower, one.kinds)]
        known = measured or known
    if len(known) == 1:
        return known[0]
    if not known and not name and what == "form":
        return None
    raise _selection_error(path, what, known, lengths)


def _selection_error(
    path: Path,
    what: Literal["diameter", "form", "length"],
    known: Sequence[CertifiedLength],
    lengths: Sequence[CertifiedLength],
) -> OperationError:
    there = message("certificate-has-lengths", names=join([one.label for one in known or lengths]))
    return OperationError(
        "certificate-ambiguous" if known else "certificate-incomplete",
        message("certificate-needs-one", path=display_path(path), what=what, count=len(known)),
        there if known or lengths else message("certificate-has-no-length"),
        message("name-quantity", option=f"--{what}")
        if known or lengths
        else message("enter-artefact-by-hand"),
    )


def _is_named(one: CertifiedLength, kind: re.Pattern[str]) -> bool:
    return any(kind.search(text.lower()) for text in (*one.names, *one.kinds))
