"""Which program and version writes the files."""

from importlib.metadata import PackageNotFoundError, version

from app.formats.json_document import DocumentPart


class Software(DocumentPart):
    name: str
    version: str


def _version() -> str:
    try:
        return version("crenel")
    except PackageNotFoundError:  # run from a source tree that was not installed
        return "uninstalled"


SOFTWARE = Software(name="crenel", version=_version())
