"""Files of the data folder, sent as they are."""

from pathlib import Path

from starlette.responses import FileResponse, Response

from app.api.problems import NotFoundError
from app.formats.io_errors import convert_io_errors
from app.formats.open_file import open_file
from app.messages.message import Text


def send_file(
    path: Path | None, missing: Text, media_type: str, name: str = "", cached: bool = False
) -> Response:
    """A file to look at, or where it is named to download.

    Args:
        missing: the text where there is no ordinary file.

    Raises:
        NotFound: there is none.
        OperationError: it cannot be read.
    """
    if path is None or not path.is_file():
        raise NotFoundError(missing)
    with convert_io_errors(path):
        open_file(path).close()
    headers = {"Cache-Control": "private"} if cached else None
    return FileResponse(path, media_type=media_type, filename=name or None, headers=headers)
