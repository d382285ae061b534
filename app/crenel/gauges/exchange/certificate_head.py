"""Who issued a Digital Calibration Certificate, for which artefact, and until when it is valid."""

from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.xml_text import local_name, read_xml
from crenel.gauges.exchange.certificate_values import DCC
from crenel.messages.message import message
from crenel.timestamps import is_date

LARGEST_NAME, LARGEST_SERIAL, LARGEST_CERTIFICATE, LARGEST_DATE = 120, 80, 200, 20


@dataclass(frozen=True)
class CertificateHead:
    """What a certificate says besides its values; empty where it says nothing."""

    name: str
    """The name of the first artefact."""
    serial_number: str
    certificate: str
    """Its own number."""
    valid_until: str
    """ISO 8601 date."""
    calibrated_on: str
    """ISO 8601 date."""
    issued_on: str
    """YYYY-MM-DD: of its issue, or where it does not say, of the end of the calibration."""
    laboratory: str


def open_certificate(path: Path) -> ET.Element:
    """The root of a DCC 3.x.

    Raises:
        OperationError: unreadable, no DCC, or another major version.
    """
    return check_certificate(read_xml(path), path)


def check_certificate(root: ET.Element, path: Path) -> ET.Element:
    """The root, if it is that of a DCC 3.x; raises ``OperationError`` naming the file if not."""
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
    return root


def certificate_head(root: ET.Element) -> CertificateHead:
    """Everything but the values; long texts are cut to what the program's own files hold."""
    return CertificateHead(
        name=_item_name(root)[:LARGEST_NAME],
        serial_number=_serial_number(root)[:LARGEST_SERIAL],
        certificate=_text(root, "uniqueIdentifier")[:LARGEST_CERTIFICATE],
        valid_until=_recalibration_date(root)[:LARGEST_DATE],
        calibrated_on=_text(root, "endPerformanceDate"),
        issued_on=_issue_date(root),
        laboratory=_laboratory(root),
    )


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
    return _content(None if item is None else item.find(f"{{{DCC}}}name")) or "–"


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


def _issue_date(root: ET.Element) -> str:
    # an xs:date may be followed by a time zone
    dates = (_text(root, name)[:10] for name in ("issueDate", "endPerformanceDate"))
    return next((one for one in dates if is_date(one)), "")


def _laboratory(root: ET.Element) -> str:
    return _content(
        root.find(
            f"{{{DCC}}}administrativeData/{{{DCC}}}calibrationLaboratory/{{{DCC}}}contact/{{{DCC}}}name"
        )
    )
