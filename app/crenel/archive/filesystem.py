"""Opens the address of a store with the fsspec family of libraries."""

import logging
from asyncio import AbstractEventLoop
from typing import Any

from crenel.archive.archive_settings import ArchiveSettings
from crenel.errors import OperationError
from crenel.messages.message import message

log = logging.getLogger(__name__)
CONNECT_S, READ_S = 10, 60
RETRIES = 2
"""Within a call; the station itself tries again with growing pauses."""


def open_filesystem(settings: ArchiveSettings) -> tuple[Any, str]:
    """The file system of an address, and the path of the archive in it.

    Raises:
        OperationError: the library for the address is missing, or the secret cannot be read.
    """
    protocol = settings.url.split("://", 1)[0]
    options: dict[str, Any] = {"skip_instance_cache": True, "use_listings_cache": False}
    if protocol == "s3":
        options |= {
            "key": settings.access_key,
            "secret": settings.secret(),
            "endpoint_url": settings.endpoint,
            "config_kwargs": {
                "connect_timeout": CONNECT_S,
                "read_timeout": READ_S,
                "retries": {"max_attempts": 1},  # s3fs tries again
                # many compatible stores do not know the newer checksums; the content is read back
                "request_checksum_calculation": "when_required",
                "response_checksum_validation": "when_required",
            },
        }
    try:
        from fsspec.core import url_to_fs

        files, root = url_to_fs(settings.url, **options)
    except (ImportError, ValueError) as error:
        extra = "crenel[s3]" if protocol == "s3" else f"fsspec, {protocol}"
        raise OperationError(
            "archive-library",
            message("archive-library-missing", place=settings.place),
            str(error),
            message("archive-install-library", library=extra),
        ) from error
    if protocol == "s3":
        files.retries = RETRIES
    if (loop := getattr(files, "loop", None)) is not None:
        # connections that are cut leave such exceptions behind; each call reports its own error
        loop.call_soon_threadsafe(loop.set_exception_handler, _note_exception)
    return files, str(root)


def _note_exception(loop: AbstractEventLoop, context: dict[str, Any]) -> None:
    log.debug("%s", context.get("message"), exc_info=context.get("exception"))
