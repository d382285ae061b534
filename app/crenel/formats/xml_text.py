"""XML of other programs: read without entities, written with one element a line."""

import re
from pathlib import Path
from xml.etree import ElementTree as ET

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.json_document import read_text
from crenel.messages.message import message

FORBIDDEN = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML 1.0 cannot hold."""
DEEPEST = 100
"""Elements within each other; a certificate has fewer than thirty."""


def read_xml(path: Path) -> ET.Element:
    """The root of an XML file.

    Raises:
        OperationError: unreadable; not well formed; nested too deeply; or with a document type,
            which could pull in other files or grow without limit.
    """
    return parse_xml(read_text(path), path)


def parse_xml(text: str, path: Path) -> ET.Element:
    """The root of the text of an XML file of this name; raises as ``read_xml``."""
    # by the text, before the parser sees an entity; a certificate never needs one
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise OperationError(
            "xml-with-document-type", display_path(path), message("xml-document-type-refused")
        )
    try:
        root = ET.fromstring(text)
    except (ET.ParseError, ValueError) as error:
        raise OperationError(
            "xml-malformed", display_path(path), message("xml-not-well-formed", error=str(error))
        ) from error
    level = [root]
    for _ in range(DEEPEST):
        level = [child for element in level for child in element]
    if level:
        raise OperationError("xml-too-deep", display_path(path), message("nested-too-deeply"))
    return root


def xml_bytes(root: ET.Element) -> bytes:
    """The file of a tree, UTF-8 and indented."""
    ET.indent(root)
    text = ET.tostring(root, encoding="unicode", short_empty_elements=True)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()


def add(parent: ET.Element, name: str, text: str | None = None, **attributes: str) -> ET.Element:
    """A new last child; ``name`` with its namespace in braces."""
    child = ET.SubElement(parent, name, attributes)
    if text is not None:
        child.text = FORBIDDEN.sub("\ufffd", text)
    return child


def local_name(element: ET.Element) -> str:
    """The name without its namespace."""
    return str(element.tag).rpartition("}")[2]
