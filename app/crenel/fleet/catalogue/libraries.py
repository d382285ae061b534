"""The libraries of the extra ``fleet``, which a station alone does not need."""

from importlib.util import find_spec

from crenel.errors import OperationError
from crenel.messages.message import message

OF_CATALOGUE = ("sqlalchemy", "alembic")


def check_libraries(names: tuple[str, ...] = OF_CATALOGUE) -> None:
    """Raises ``OperationError`` that says what to install, if a library is missing."""
    missing = [name for name in names if find_spec(name) is None]
    if missing:
        raise OperationError(
            "fleet-library",
            message("fleet-library-missing", libraries=", ".join(missing)),
            remedy=message("archive-install-library", library="crenel[fleet]"),
        )
