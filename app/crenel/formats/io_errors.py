"""Errors of files and their explanation as refusals."""

import errno
import logging
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pydantic import ValidationError

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.messages.message import Text, join, message
from crenel.messages.validation import validation_text

log = logging.getLogger(__name__)
LONGEST_VALUE = 60

_BY_ERRNO: dict[int, tuple[str, Text, Text]] = {
    errno.ENOENT: ("file-missing", message("no-such-file-or-folder"), message("check-path")),
    errno.EACCES: (
        "file-forbidden",
        message("permission-denied"),
        message("change-permissions-place"),
    ),
    errno.EPERM: ("file-forbidden", message("operation-not-permitted"), message("change-place")),
    errno.EROFS: ("folder-read-only", message("disk-read-only"), message("choose-another-place")),
    errno.ENOSPC: ("disk-full", message("disk-full"), message("free-some-space-try-again")),
    errno.EDQUOT: (
        "disk-full",
        message("disk-quota-used-up"),
        message("free-some-space-try-again"),
    ),
    errno.EISDIR: ("file-is-folder", message("it-is-a-folder"), message("name-a-file")),
    errno.ENXIO: (
        "file-not-ordinary",
        message("it-is-no-ordinary-file"),
        message("put-file-place"),
    ),
    errno.EOVERFLOW: (
        "file-too-large",
        message("file-larger-than-any-read"),
        message("check-path"),
    ),
    errno.ENOTDIR: (
        "file-is-no-folder",
        message("part-of-path-is-no-folder"),
        message("check-path"),
    ),
    errno.EEXIST: (
        "file-is-no-folder",
        message("file-has-name-folder-needed"),
        message("move-away"),
    ),
    errno.ELOOP: ("file-error", message("link-leads-itself"), message("remove")),
    errno.ENAMETOOLONG: ("name-too-long", message("name-too-long"), message("choose-shorter-one")),
    errno.EFBIG: (
        "file-too-large",
        message("disks-largest-file-size-reached"),
        message("choose-another"),
    ),
}


def error_from_os(error: OSError, path: Path | str | None = None) -> OperationError:
    """The meaning of an operating system's error on a file for its user.

    ``path`` is the file as the user knows it, if known.
    """
    named = path if path is not None else error.filename
    what = display_path(named) if named is not None else message("file")
    code, why, remedy = _BY_ERRNO.get(
        error.errno or 0, ("file-error", error.strerror or str(error), "")
    )
    return OperationError(code, what, why, remedy)


@contextmanager
def convert_io_errors(path: Path | str) -> Iterator[None]:
    """Turns any ``OSError`` of the block into an ``OperationError`` naming the file."""
    try:
        yield
    except OSError as error:
        raise error_from_os(error, path) from error


@contextmanager
def convert_all_errors(path: Path | str) -> Iterator[None]:
    """Turns whatever the block raises into an ``OperationError`` naming the file.

    For files that others wrote, of which each is evaluated alone: no content of one, and no fault
    of the program that it brings about, may harm what does not depend on it.
    """
    try:
        yield
    except OperationError:
        raise
    except OSError as error:
        raise error_from_os(error, path) from error
    except ValidationError as error:
        raise error_from_validation(path, error) from error
    except Exception as error:
        log.warning("%s cannot be evaluated", display_path(path), exc_info=error)
        raise OperationError(
            "file-not-evaluated",
            display_path(path),
            message("file-cannot-be-evaluated", error=type(error).__name__),
        ) from error


@contextmanager
def prefix_errors(path: Path | str) -> Iterator[None]:
    """Adds the name of a file to errors that the mathematics raises for its content."""
    try:
        yield
    except OperationError as error:
        named = join([display_path(path), error.what], ": ")
        raise OperationError(error.code, named, error.why, error.remedy) from error


def error_from_validation(path: Path | str, error: ValidationError) -> OperationError:
    """The error for a document whose fields are not as described in docs/formats.md."""
    problems = error.errors(include_url=False)
    first, more = problems[0], len(problems) - 1
    place = "".join(
        f"[{part}]" if isinstance(part, int) else f".{part}" for part in first["loc"]
    ).lstrip(".")
    if first["type"] == "json_invalid":
        return OperationError(
            "file-not-json",
            display_path(path),
            validation_text(first),
            message("restore-file-source"),
        )
    if first["type"] == "missing":
        what = message("field-missing", path=display_path(path), place=place, more=more)
        return OperationError("field-missing", what)
    why = validation_text(first)
    return OperationError(
        "field-invalid",
        _invalid_field(path, place, first["input"]),
        message("reason-and-more", reason=why, more=more) if more else why,
    )


def _invalid_field(path: Path | str, place: str, value: object) -> Text:
    """A field with its value, unless that is an object."""
    if not place:
        return display_path(path)
    if isinstance(value, dict):
        return f"{display_path(path)}: {place}"
    shown = repr(value)
    if len(shown) > LONGEST_VALUE:
        shown = shown[: LONGEST_VALUE - 3] + "..."
    return message("field-is", path=display_path(path), place=place, value=shown)
