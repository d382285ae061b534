"""The Digital Calibration Certificate of a sphere, read as an artefact of a performance test."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

from app.errors import OperationError
from app.formats.datasheets.gauge import GaugeFile
from app.formats.exchange.certificate_values import DCC, CertifiedLength, result_lengths
from app.formats.exchange.xml_text import local_name, read_xml
from app.formats.file_names import display_path
from app.formats.performance.plan import SpherePart
from app.messages.message import join, message

DIAMETER = re.compile("diameter|durchmesser")
RADIUS = re.compile("radius")
SIZE = re.compile(f"{DIAMETER.pattern}|{RADIUS.pattern}")
FORM = re.compile("(?<![a-z])form|kugelform|roundness|sphericity|rundheit")
OF_RESULT = "basic_measuredvalue"
LARGEST_NAME, LARGEST_SERIAL, LARGEST_CERTIFICATE = 120, 80, 200


@dataclass(frozen=True)
class CertifiedSphere:
    """What a certificate says of a sphere."""

    sphere: SpherePart
    laboratory: str
    calibrated_on: str
    """ISO 8601 date; empty: not stated."""
    schema_version: str

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
    root = read_xml(path)
    if local_name(root) != "digitalCalibrationCertificate" or not str(root.tag).startswith(
        f"{{{DCC}}}"
    ):
        raise OperationError("no-certificate", display_path(path), message("no-dcc"))
    version = root.get("schemaVersion", "")
    if version.split(".")[0] != "3":
        raise OperationError(
            "certificate-version",
            display_path(path),
            message("dcc-version-unknown", version=version or "–"),
            message("dcc-version-needed"),
        )
    lengths = result_lengths(root)
    diameter = _choose(path, lengths, SIZE, diameter_name, "diameter")
    form = _choose(path, lengths, FORM, form_name, "form", diameter)
    assert diameter is not None
    if diameter.value_mm <= 0:
        raise OperationError(
            "certificate-incomplete",
            display_path(path),
            message("certified-diameter-not-positive", name=diameter.label),
            message("enter-artefact-by-hand"),
        )
    if diameter.standard_uncertainty_mm is None:
        raise OperationError(
            "certificate-without-uncertainty",
            display_path(path),
            message("certified-diameter-without-uncertainty", name=diameter.label),
            message("enter-artefact-by-hand"),
        )
    twice = 2.0 if _is_named(diameter, RADIUS) and not _is_named(diameter, DIAMETER) else 1.0
    form_sd_mm = None if form is None else form.standard_uncertainty_mm
    sphere = SpherePart(
        name=_item_name(root)[:LARGEST_NAME],
        serial_number=_serial_number(root)[:LARGEST_SERIAL],
        certificate=_text(root, "uniqueIdentifier")[:LARGEST_CERTIFICATE],
        valid_until=_recalibration_date(root),
        diameter_mm=twice * diameter.value_mm,
        diameter_sd_um=1e3 * twice * diameter.standard_uncertainty_mm,
        form_um=0.0 if form is None else 1e3 * abs(form.value_mm),
        form_sd_um=1e3 * (form_sd_mm or 0.0),
    )
    return CertifiedSphere(sphere, _laboratory(root), _text(root, "endPerformanceDate"), version)


def _choose(
    path: Path,
    lengths: Sequence[CertifiedLength],
    kind: re.Pattern[str],
    name: str,
    what: str,
    other: CertifiedLength | None = None,
) -> CertifiedLength | None:
    """The one quantity of a kind; a form may be missing."""
    known = [one for one in lengths if one is not other]
    if name:
        known = [one for one in known if _is_named(one, re.compile(re.escape(name.lower())))]
    else:
        known = [one for one in known if _is_named(one, kind)]
        measured = [one for one in known if OF_RESULT in map(str.lower, one.kinds)]
        known = measured or known
    if len(known) == 1:
        return known[0]
    if not known and not name and what == "form":
        return None
    there = message("certificate-has-lengths", names=join([one.label for one in known or lengths]))
    raise OperationError(
        "certificate-ambiguous" if known else "certificate-incomplete",
        message("certificate-needs-one", path=display_path(path), what=what, count=len(known)),
        there if known or lengths else message("certificate-has-no-length"),
        message("name-quantity", option=f"--{what}"),
    )


def _is_named(one: CertifiedLength, kind: re.Pattern[str]) -> bool:
    return any(kind.search(text.lower()) for text in (*one.names, *one.kinds))


def _text(root: ET.Element, name: str) -> str:
    found = root.find(f"{{{DCC}}}administrativeData/{{{DCC}}}coreData/{{{DCC}}}{name}")
    return "" if found is None else (found.text or "").strip()


def _content(element: ET.Element | None) -> str:
    """The text of a name, in English if it has that language."""
    if element is None:
        return ""
    contents = element.findall(f"{{{DCC}}}content")
    english = [one for one in contents if one.get("lang") == "en"]
    chosen = next(iter([*english, *contents]), None)
    return "" if chosen is None else (chosen.text or "").strip()


def _item(root: ET.Element) -> ET.Element | None:
    return root.find(f".//{{{DCC}}}items/{{{DCC}}}item")


def _item_name(root: ET.Element) -> str:
    item = _item(root)
    return _content(None if item is None else item.find(f"{{{DCC}}}name")) or "sphere"


def _serial_number(root: ET.Element) -> str:
    """The manufacturer's number of the first item; without one, any number of it."""
    item = _item(root)
    if item is None:
        return ""
    numbers = {
        (one.findtext(f"{{{DCC}}}issuer") or "").strip(): (
            one.findtext(f"{{{DCC}}}value") or ""
        ).strip()
        for one in item.findall(f"{{{DCC}}}identifications/{{{DCC}}}identification")
    }
    return numbers.get("manufacturer") or next(iter(numbers.values()), "")


def _recalibration_date(root: ET.Element) -> str:
    """Until when the certificate is valid, if a statement says so."""
    for statement in root.iter(f"{{{DCC}}}statement"):
        if "recalibration" in statement.get("refType", "").lower():
            return (statement.findtext(f"{{{DCC}}}date") or "").strip()
    return ""


def _laboratory(root: ET.Element) -> str:
    return _content(
        root.find(
            f"{{{DCC}}}administrativeData/{{{DCC}}}calibrationLaboratory/{{{DCC}}}contact/{{{DCC}}}name"
        )
    )
