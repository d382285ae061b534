"""JSON documents of the program: one format name, one version, fields checked strictly."""

import hashlib
import json
import re
from collections.abc import Sequence
from importlib import metadata
from itertools import combinations
from pathlib import Path
from typing import Annotated, Any, ClassVar, Self

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.file_names import display_path
from crenel.formats.io_errors import convert_io_errors, error_from_validation
from crenel.formats.open_file import LARGEST_DOCUMENT, open_file, read_bounded
from crenel.messages.message import Message, message
from crenel.messages.stored import RENDERED, SUFFIX, restore_texts
from crenel.timestamps import is_date

# no line break can stand within a text of JSON
_NUMBERS = re.compile(r"\[\n\s+([-+.eE\d,\s]+?)\n\s+\]")


_HALF = re.compile(r"\\u[dD][89a-fA-F]")
"""An escape that may be half of a character."""
LARGEST = 1e9
DEEPEST = 64
"""Objects and lists within each other; a document of the program has fewer than ten."""
BLOCK_BYTES, MOST_PACKED = 512, 100
"""Unit of ``st_blocks``, and how much file systems compress at most."""


def _as_number(value: object) -> object:
    """Keeps text, truth values and sizes that no quantity here has from passing as numbers."""
    if isinstance(value, str | bool):
        raise ValueError(message("number-expected-here"))
    if isinstance(value, int | float) and LARGEST < abs(value) < float("inf"):
        raise ValueError(message("number-too-large"))
    return value


def _check_date(value: str) -> str:
    if value and not is_date(value):
        raise ValueError(message("value-must-be-iso-date"))
    return value


Number = Annotated[float, BeforeValidator(_as_number)]
"""A finite number of a sensible size; text and true/false are no numbers."""
Positive = Annotated[Number, Field(gt=0)]
NotNegative = Annotated[Number, Field(ge=0)]
SizeMm = Annotated[Number, Field(ge=1e-3)]
"""The size of an artefact in mm; a smaller one is in another unit."""
Name = Annotated[str, Field(max_length=120)]
"""What a datasheet calls its thing: one line of a screen."""
SerialNumber = Annotated[str, Field(max_length=80)]
IssueDate = Annotated[str, AfterValidator(_check_date)]
"""The date of a certificate, YYYY-MM-DD; empty: not stated."""
CertifiedUm = Annotated[NotNegative, Field(le=1e6)]
"""A form deviation or an uncertainty in a certificate, µm; a larger one is in another unit."""
Vector3 = tuple[Number, Number, Number]
Row4 = tuple[Number, Number, Number, Number]
Matrix3 = tuple[Vector3, Vector3, Vector3]
Matrix34 = tuple[Row4, Row4, Row4]
Matrix4 = tuple[Row4, Row4, Row4, Row4]
SYMMETRY_TOLERANCE = 1e-6
"""Of a covariance, as a share of the two standard deviations."""


def require_covariance(matrix: Sequence[Sequence[float]], count: int) -> None:
    """Raises ``ValueError`` unless a matrix is a covariance of so many parameters: symmetric but
    for rounding, with variances that are not negative."""
    if not _is_covariance(matrix, count):
        raise ValueError(message("covariance-must-be-symmetric-over-parameters", count=count))


def _is_covariance(matrix: Sequence[Sequence[float]], count: int) -> bool:
    if len(matrix) != count or any(len(row) != count for row in matrix):
        return False
    if any(matrix[k][k] < 0 for k in range(count)):
        return False
    allowed = [SYMMETRY_TOLERANCE * matrix[k][k] ** 0.5 for k in range(count)]
    return all(
        abs(matrix[i][j] - matrix[j][i]) <= allowed[i] * matrix[j][j] ** 0.5
        for i, j in combinations(range(count), 2)
    )


def field_name(name: str) -> Message:
    """A field in a text about a document: as in the file, or as a form calls it that shows the
    text."""
    return message("field-name", name=name)


class DocumentPart(BaseModel):
    """A piece of a document. Fields that the program does not know are ignored."""

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)


class Software(DocumentPart):
    """Which program and version wrote a file."""

    name: str
    version: str


def _own_version() -> str:
    try:
        return metadata.version("crenel")
    except metadata.PackageNotFoundError:  # run from a source tree that was not installed
        return "uninstalled"


SOFTWARE = Software(name="crenel", version=_own_version())


class Document(DocumentPart):
    """A whole file: names its format and version next to its fields."""

    FORMAT: ClassVar[str]
    VERSION: ClassVar[int] = 1

    @classmethod
    def read(cls, path: Path) -> Self:
        """Reads and checks a file.

        Raises:
            OperationError: missing, unreadable, not JSON, of another format or of a newer
                version, or a field that is missing or wrong.
        """
        return cls.parse_text(read_text(path), path)

    @classmethod
    def parse_text(cls, text: str, path: Path) -> Self:
        """Checks the text of a file of this name; as ``read``."""
        fields = _parse_object(text, path)
        cls._check_format(path, fields)
        try:
            return cls.model_validate(fields)
        except ValidationError as error:
            raise error_from_validation(path, error) from error

    def write(self, path: Path) -> None:
        """Writes the file atomically; raises ``OperationError`` where it cannot."""
        write_atomically(path, self.text().encode())

    def text(self) -> str:
        """The document as JSON text, ``format`` and ``version`` first."""
        text = json.dumps(self.fields(), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
        # rows of numbers on one line each, for human readers
        return _NUMBERS.sub(lambda row: f"[{', '.join(row[1].replace(',', ' ').split())}]", text)

    def fields(self) -> dict[str, Any]:
        """The document as plain values, ``format`` and ``version`` first."""
        fields = self.model_dump(mode="json", exclude_none=True)
        return {"format": self.FORMAT, "version": self.VERSION, **_with_english(self, fields)}

    @classmethod
    def _check_format(cls, path: Path, fields: dict[str, Any]) -> None:
        found, version = fields.get("format"), fields.get("version")
        if found != cls.FORMAT:
            raise OperationError(
                "file-of-another-format",
                state_format(path, found),
                message("format-expected", format=repr(cls.FORMAT)),
                message("give-right-file"),
            )
        if version != cls.VERSION or isinstance(version, bool):
            raise OperationError(
                "file-of-another-version",
                message("document-version", path=display_path(path), version=repr(version)),
                message("program-reads-version", version=cls.VERSION, format=cls.FORMAT),
            )


def state_format(path: Path, found: object) -> Message:
    """What the file says of its format."""
    name = display_path(path)
    if found is None:
        return message("document-states-no-format", path=name)
    return message("document-format", path=name, format=repr(found))


def parse_format(text: str, path: Path) -> object:
    """The format that the text of a file of this name states; raises ``OperationError`` if it is no
    document."""
    return _parse_object(text, path).get("format")


def _with_english(part: DocumentPart, fields: dict[str, Any]) -> dict[str, Any]:
    """The plain values of a part, with the English of each text before its data."""
    written: dict[str, Any] = {}
    for name, plain in fields.items():
        value = getattr(part, name)
        if isinstance(value, DocumentPart):
            written[name] = _with_english(value, plain)
        elif isinstance(value, RENDERED):
            written |= {name: str(value), f"{name}{SUFFIX}": plain}
        elif isinstance(value, tuple) and any(isinstance(item, RENDERED) for item in value):
            written |= {name: [str(item) for item in value], f"{name}{SUFFIX}": plain}
        elif isinstance(value, tuple) and value and isinstance(value[0], DocumentPart):
            written[name] = [
                _with_english(item, one) for item, one in zip(value, plain, strict=True)
            ]
        else:
            written[name] = plain
    return written


def _parse_object(text: str, path: Path) -> dict[str, Any]:
    try:
        plain = json.loads(text)
        if is_deep(plain):
            raise RecursionError
        fields = restore_texts(plain)
    except (ValueError, RecursionError) as error:
        if not text.strip():
            why = message("empty")
        elif isinstance(error, json.JSONDecodeError):
            why = message("json-cut-off-line", reason=error.msg, line=error.lineno)
        elif isinstance(error, RecursionError):
            why = message("nested-too-deeply")
        else:
            why = message("one-numbers-has-too-many-digits")
        raise OperationError(
            "file-not-json", display_path(path), why, message("restore-file-source")
        ) from error
    if _HALF.search(text):
        _check_characters(path, fields)
    if not isinstance(fields, dict):
        raise OperationError("file-not-json", display_path(path), message("json-object-expected"))
    return fields


def is_deep(plain: object) -> bool:
    """Whether more objects and lists are within each other than in any document."""
    level = [plain] if isinstance(plain, dict | list) else []
    for _ in range(DEEPEST):
        inner = (one.values() if isinstance(one, dict) else one for one in level)
        level = [one for some in inner for one in some if isinstance(one, dict | list)]
        if not level:
            return False
    return True


def is_valid_unicode(plain: object) -> bool:
    """Whether plain values of JSON have no half of a character, which nothing can store."""
    try:
        json.dumps(plain, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        return False
    return True


def _check_characters(path: Path, fields: object) -> None:
    if not is_valid_unicode(fields):
        raise OperationError(
            "file-not-text",
            display_path(path),
            message("text-has-half-character"),
            message("save-utf-8"),
        )


def read_text(path: Path) -> str:
    """A UTF-8 text file, a byte-order mark taken off; raises ``OperationError`` where it cannot."""
    with convert_io_errors(path):
        content = read_bounded(path)
    return decode_text(content, path)


def decode_text(content: bytes, path: Path) -> str:
    """The text that a file of this name holds; as ``read_text``."""
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise OperationError(
            "file-not-text",
            display_path(path),
            message("byte-is-not-utf-8", byte=error.start),
            message("save-utf-8"),
        ) from error


def file_sha256(path: Path) -> str:
    """The file's SHA-256 in hexadecimal; raises ``OperationError`` where it cannot be read."""
    with convert_io_errors(path), open_file(path) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def has_sha256(path: Path, sha256: str) -> bool:
    """Whether a file has this SHA-256.

    A large file that takes almost no disk space has been extended since, and would take hours to
    read; raises ``OperationError`` where it cannot be read.
    """
    with convert_io_errors(path):
        state = path.stat()
    on_disk = state.st_blocks * BLOCK_BYTES * MOST_PACKED
    if state.st_size > LARGEST_DOCUMENT and on_disk < state.st_size:
        return False
    return file_sha256(path) == sha256
