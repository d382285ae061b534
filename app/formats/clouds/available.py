"""Which formats of clouds this installation can write."""

from dataclasses import dataclass
from importlib.util import find_spec

from app.formats.clouds.files import COPC, SUFFIXES
from app.messages.message import Text, message

FORMS = (*(suffix.lstrip(".") for suffix in SUFFIXES), COPC.lstrip("."))
"""Of the name of a cloud: what stands behind its first point."""
LAS = ("laspy", "lazrs")
LIBRARIES = {"e57": ("pye57",), "las": LAS, "laz": LAS, "copc.laz": (*LAS, "copclib")}


@dataclass(frozen=True)
class WritableFormat:
    """A format, by the end of a file's name."""

    form: str
    why_not: Text
    """What to install for it; empty: it can be written."""


def cloud_formats() -> list[WritableFormat]:
    """All formats, with what keeps this installation from writing them."""
    return [WritableFormat(form, _why_not(form)) for form in FORMS]


def _why_not(form: str) -> Text:
    if all(find_spec(name) is not None for name in LIBRARIES.get(form, ())):
        return ""
    extra = "copc" if form == "copc.laz" else "clouds"
    return message("cloud-install-package", command=f"pip install 'crenel[{extra}]'")
