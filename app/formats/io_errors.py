"""What went wrong with a file, said as a refusal."""

import errno
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pydantic import ValidationError

from app.errors import OperationError
from app.formats.file_names import display_path

_BY_ERRNO: dict[int, tuple[str, str, str]] = {
    errno.ENOENT: ("file-missing", "there is no such file or folder", "Check the path"),
    errno.EACCES: ("file-forbidden", "permission denied", "Change its permissions or the place"),
    errno.EPERM: ("file-forbidden", "the operation is not permitted", "Change the place"),
    errno.EROFS: ("folder-read-only", "the disk is read-only", "Choose another place"),
    errno.ENOSPC: ("disk-full", "the disk is full", "Free some space and try again"),
    errno.EDQUOT: ("disk-full", "the disk quota is used up", "Free some space and try again"),
    errno.EISDIR: ("file-is-folder", "it is a folder", "Name a file"),
    errno.ENXIO: (
        "file-not-ordinary",
        "it is a pipe, a socket or a device",
        "Put a file in its place",
    ),
    errno.EOVERFLOW: ("file-too-large", "nothing that is read here is as large", "Check the path"),
    errno.ENOTDIR: ("file-is-no-folder", "a part of the path is not a folder", "Check the path"),
    errno.EEXIST: (
        "file-is-no-folder",
        "a file has the name of a folder that is needed",
        "Move it away",
    ),
    errno.ELOOP: ("file-error", "it is a link that leads to itself", "Remove it"),
    errno.ENAMETOOLONG: ("name-too-long", "the name is too long", "Choose a shorter one"),
    errno.EFBIG: ("file-too-large", "the disk's largest file size is reached", "Choose another"),
}


def error_from_os(error: OSError, path: Path | str | None = None) -> OperationError:
    """The refusal that an operating system's error on a file amounts to.

    ``path`` is the file as whoever asked for it knows it, where that is known.
    """
    named = path if path is not None else error.filename
    what = display_path(named) if named is not None else "a file"
    code, why, remedy = _BY_ERRNO.get(
        error.errno or 0, ("file-error", error.strerror or str(error), "")
    )
    return OperationError(code, what, why, remedy)


@contextmanager
def convert_io_errors(path: Path | str) -> Iterator[None]:
    """Turns any ``OSError`` of the block into a ``OperationError`` naming the file."""
    try:
        yield
    except OSError as error:
        raise error_from_os(error, path) from error


@contextmanager
def prefix_errors(path: Path | str) -> Iterator[None]:
    """Puts a file's name before what the mathematics refuses of its content."""
    try:
        yield
    except OperationError as refusal:
        named = f"{display_path(path)}: {refusal.what}"
        raise OperationError(refusal.code, named, refusal.why, refusal.remedy) from refusal


def error_from_validation(path: Path | str, error: ValidationError) -> OperationError:
    """The refusal for a document whose fields are not as described in docs/formats.md."""
    problems = error.errors(include_url=False)
    first = problems[0]
    place = "".join(
        f"[{part}]" if isinstance(part, int) else f".{part}" for part in first["loc"]
    ).lstrip(".")
    more = f" (and {len(problems) - 1} more)" if len(problems) > 1 else ""
    message = first["msg"].removeprefix("Value error, ")
    if first["type"] == "json_invalid":
        return OperationError(
            "file-not-json",
            display_path(path),
            f"it is not JSON, or was cut off: {first.get('ctx', {}).get('error', message)}",
            "Restore the file from its source",
        )
    if first["type"] == "missing":
        return OperationError("field-missing", f"{display_path(path)}: {place} is missing{more}")
    value = repr(first["input"])
    if len(value) > 60:
        value = value[:57] + "..."
    shown = f" is {value}" if place and not isinstance(first["input"], dict) else ""
    return OperationError(
        "field-invalid",
        f"{display_path(path)}: {place}{shown}".rstrip(": "),
        f"{_lower_first(message)}{more}",
    )


def _lower_first(text: str) -> str:
    return text[:1].lower() + text[1:] if text[1:2].islower() else text
