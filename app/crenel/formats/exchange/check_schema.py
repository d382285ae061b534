"""Validation of a written XML file by a schema (XSD) of the user's own.

Schemas are read from the disk alone. What they include or import by an address of the web must
stand beside them, under the last part of that address.
"""

import re
import tempfile
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.formats.optional_library import import_library
from crenel.messages.message import Text, join, message

LIBRARY, EXTRA = "lxml.etree", "schema"
XSD = "{http://www.w3.org/2001/XMLSchema}"
LINKS = [f"{XSD}{name}" for name in ("include", "import", "redefine")]
NAMESPACE = re.compile(r"\{[^{}\s]*:[^{}\s]*\}")
MOST_NAMED = 5
"""Errors that are named; of the others, the number is."""


def check_schema(content: bytes, schema: Path, output: Path) -> None:
    """Refuses a file that the schema does not allow.

    Args:
        content: the file, before it is written.
        output: its name, for messages.

    Raises:
        OperationError: ``schema-violated`` with line, element and reason of the first errors;
            ``schema-unusable`` or ``schema-incomplete`` if the schema, or what it includes or
            imports, cannot be read; ``extra-missing`` without the extra ``schema``.
    """
    needed, remedy = message("schema-package-missing"), message("install-extra", extra=EXTRA)
    library = import_library(schema, LIBRARY, needed, remedy)
    compiled = _compile(library, schema)
    if compiled.validate(library.fromstring(content)):
        return
    errors = list(compiled.error_log)
    named: list[Text] = [
        message("schema-error", line=str(one.line), error=_bare_text(one.message))
        for one in errors[:MOST_NAMED]
    ]
    if len(errors) > MOST_NAMED:
        named.append(message("schema-errors-more", count=len(errors) - MOST_NAMED))
    raise OperationError(
        "schema-violated",
        display_path(output),
        message("schema-not-complied-with", schema=display_path(schema), errors=join(named, "; ")),
        message("schema-nothing-written"),
    )


def _compile(library: Any, schema: Path) -> Any:
    """The schema, from copies whose links lead to each other only."""
    roots = {schema.resolve(): _read_schema(library, schema)}
    waiting = list(roots)
    with tempfile.TemporaryDirectory() as place:
        while waiting:
            path = waiting.pop()
            for link in roots[path].iterchildren(*LINKS):
                location = link.get("schemaLocation")
                if location is None:
                    continue
                found = _find_link(path, location).resolve()
                if found not in roots:
                    roots[found] = _read_schema(library, found)
                    waiting.append(found)
                link.set("schemaLocation", f"{list(roots).index(found)}.xsd")
        for number, root in enumerate(roots.values()):
            (Path(place) / f"{number}.xsd").write_bytes(library.tostring(root))
        try:
            return library.XMLSchema(file=str(Path(place) / "0.xsd"))
        except library.XMLSchemaParseError as error:
            raise _unusable_error(schema, _bare_text(error.error_log[0].message)) from error


def _find_link(path: Path, location: str) -> Path:
    """The file that a schema includes or imports; what is on the web stands beside it."""
    address = urlsplit(location)
    on_web = bool(address.netloc)
    named = unquote(address.path)
    found = path.parent / (Path(named).name if on_web else named)
    if found.is_file():
        return found
    raise OperationError(
        "schema-incomplete",
        display_path(path),
        message("schema-imports-missing", location=location),
        message("schema-fetch", name=found.name, folder=display_path(found.parent)),
    )


def _read_schema(library: Any, path: Path) -> Any:
    """The root of a schema; its own entities are resolved, others are not read."""
    with convert_io_errors(path):
        content = read_bounded(path)
    parser = library.XMLParser(resolve_entities="internal", no_network=True, load_dtd=False)
    try:
        root = library.fromstring(content, parser)
    except library.XMLSyntaxError as error:
        raise _unusable_error(path, message("xml-not-well-formed", error=error.msg)) from error
    if root.tag != f"{XSD}schema":
        raise _unusable_error(path, message("schema-is-none"))
    return root


def _unusable_error(path: Path, why: Text) -> OperationError:
    return OperationError(
        "schema-unusable", display_path(path), message("schema-unusable", error=why)
    )


def _bare_text(text: str) -> str:
    """An error of the library without namespaces and full stop."""
    return NAMESPACE.sub("", text).strip().rstrip(".")
