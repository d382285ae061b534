"""What is wrong with an archive, in words that say what to do."""

import errno
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Literal

from crenel.errors import OperationError
from crenel.messages.message import Text, message

FULL = (errno.ENOSPC, errno.EDQUOT)
FULL_WORDS = ("quota", "storagefull", "insufficientstorage", "insufficient storage", "(507)")
"""In what S3-compatible stores answer when a bucket is full; S3 itself has no such error. The
number stands in brackets there; without them, it may be part of an address."""
FORBIDDEN_NAMES = {"NoCredentialsError", "PartialCredentialsError", "CredentialRetrievalError"}
"""Errors of the S3 library that are no ``PermissionError``."""
OF_FILES = {
    "disk-full": "archive-full",
    "file-forbidden": "archive-forbidden",
    "folder-forbidden": "archive-forbidden",
    "folder-read-only": "archive-forbidden",
    "folder-missing": "archive-missing",
    "file-missing": "archive-missing",
}
FOREIGN_KINDS = (errno.EISDIR, errno.ENXIO, errno.ELOOP, errno.ENOTDIR, errno.EEXIST)
CODES_OF_FOREIGN_KINDS = ("output-not-a-file", "file-not-ordinary", "file-is-no-folder")
LONGEST_REASON = 300

StorePurpose = Literal["archive", "records", "results"]
"""A station's own archive, which it tries again by itself; an archive that is only read; or the
place where results are written."""


class StoreError(OperationError):
    """The archive cannot do what it was asked for; the station tries again later."""


@contextmanager
def convert_store_errors(place: str, purpose: StorePurpose = "archive") -> Iterator[None]:
    """Turns whatever a store's library raises into a ``StoreError``; refusals of the station's own
    files and a store's own refusals pass."""
    try:
        yield
    except OperationError as error:
        if error.code in OF_FILES and not isinstance(error, SourceError):
            raise store_error(OF_FILES[error.code], place, str(error.why), purpose) from error
        raise
    except Exception as error:  # the libraries have errors of many families
        reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
        raise store_error(_code_of(error), place, str(reason), purpose) from error


class DamagedCopyError(StoreError):
    """What the archive has under a name is not what was written there. Other records are not
    concerned.

    Args:
        why: by default, that the archive does not hold what is written to it.
    """

    def __init__(self, name: str, why: Text = "") -> None:
        super().__init__(
            "archive-differs",
            message("archive-copy-differs", name=name),
            why or message("archive-loses-data"),
            message("archive-check-disk"),
        )


def is_of_whole_place(error: OperationError) -> bool:
    """Whether it concerns the store, and not one of its files alone."""
    return isinstance(error, StoreError) and not isinstance(error, DamagedCopyError)


@contextmanager
def convert_foreign_kinds(name: str) -> Iterator[None]:
    """Turns the errors for a folder, a pipe or a loop of links under the name of a file into a
    ``DamagedCopyError``."""
    try:
        yield
    except OSError as error:
        if error.errno in FOREIGN_KINDS:
            raise DamagedCopyError(name) from error
        raise
    except OperationError as error:
        if error.code in CODES_OF_FOREIGN_KINDS and not isinstance(error, SourceError):
            raise DamagedCopyError(name) from error
        raise


class SourceError(OperationError):
    """A file of the station cannot be read or has changed: no fault of the archive."""


def store_error(
    code: str, place: str, reason: str, purpose: StorePurpose = "archive"
) -> StoreError:
    """The error for one of the four ways in which a store fails."""
    about = _about_output if purpose == "results" else _about_archive
    why = " ".join(reason.split())[:LONGEST_REASON]
    return StoreError(code, about(place)[code], why, REMEDIES[purpose][code])


def _about_archive(place: str) -> Mapping[str, Text]:
    return {
        "archive-full": message("archive-full", place=place),
        "archive-forbidden": message("archive-forbidden", place=place),
        "archive-missing": message("archive-missing", place=place),
        "archive-away": message("archive-away", place=place),
    }


def _about_output(place: str) -> Mapping[str, Text]:
    return {
        "archive-full": message("output-full", place=place),
        "archive-forbidden": message("output-forbidden", place=place),
        "archive-missing": message("output-missing", place=place),
        "archive-away": message("output-away", place=place),
    }


REMEDIES: Mapping[StorePurpose, Mapping[str, Text]] = {
    "archive": {
        "archive-full": message("archive-make-room"),
        "archive-forbidden": message("archive-check-keys"),
        "archive-missing": message("archive-check-url"),
        "archive-away": message("archive-check-network"),
    },
    "records": {
        "archive-full": message("store-make-room"),
        "archive-forbidden": message("store-check-access"),
        "archive-missing": message("store-check-address"),
        "archive-away": message("store-check-network"),
    },
    "results": {
        "archive-full": message("output-make-room"),
        "archive-forbidden": message("output-check-access"),
        "archive-missing": message("output-create"),
        "archive-away": message("store-check-network"),
    },
}


def _code_of(error: Exception) -> str:
    number = error.errno if isinstance(error, OSError) else None
    text = f"{error} {error.__cause__ or ''}".lower()
    if number in FULL or any(word in text for word in FULL_WORDS):
        return "archive-full"
    if isinstance(error, PermissionError) or type(error).__name__ in FORBIDDEN_NAMES:
        return "archive-forbidden"
    if number == errno.EROFS:
        return "archive-forbidden"
    if isinstance(error, FileNotFoundError):
        return "archive-missing"
    return "archive-away"
