"""The symbols of performance tests by edition, as data: the standards change their spelling."""

from functools import lru_cache
from importlib import resources
from typing import Literal, get_args

from pydantic import TypeAdapter

from crenel.errors import OperationError
from crenel.formats.json_document import DocumentPart
from crenel.messages.message import Text, message

SphereQuantity = Literal[
    "size-touch",
    "form-touch",
    "location-touch",
    "size-scan",
    "size-all-scan",
    "form-scan",
    "dispersion-scan",
    "location-scan",
    "size-both",
    "form-both",
    "location-both",
]
"""What the one-sphere test measures."""
Quantity = Literal[
    SphereQuantity,
    "length-touch",
    "length-scan",
    "plane-scan",
    "effective-diameter",
    "articulation-largest",
    "articulation-two-s",
    "volumetric-largest",
    "volumetric-two-rms",
]
"""What is measured, whatever a standard calls it."""
SPHERE_QUANTITIES: tuple[SphereQuantity, ...] = get_args(SphereQuantity)
DEFAULT_EDITION, CONTACT_EDITION = "2016", "B89.4.22"

TITLES: dict[Quantity, Text] = {
    "size-touch": message("performance-size-touch"),
    "form-touch": message("performance-form-touch"),
    "location-touch": message("performance-location-touch"),
    "size-scan": message("performance-size-scan"),
    "size-all-scan": message("performance-size-all-scan"),
    "form-scan": message("performance-form-scan"),
    "dispersion-scan": message("performance-dispersion-scan"),
    "location-scan": message("performance-location-scan"),
    "size-both": message("performance-size-both"),
    "form-both": message("performance-form-both"),
    "location-both": message("performance-location-both"),
    "length-touch": message("performance-length-touch"),
    "length-scan": message("performance-length-scan"),
    "plane-scan": message("performance-plane-scan"),
    "effective-diameter": message("performance-effective-diameter"),
    "articulation-largest": message("performance-articulation-largest"),
    "articulation-two-s": message("performance-articulation-two-s"),
    "volumetric-largest": message("performance-volumetric-largest"),
    "volumetric-two-rms": message("performance-volumetric-two-rms"),
}
"""In plain words."""


class Symbol(DocumentPart):
    """One symbol of an edition."""

    symbol: str
    unit: Literal["µm"]
    signed: bool
    value_of: str = ""
    """What the single values are of, such as a seat; empty if the symbol has none, or those of the
    positions of a sphere."""


class Edition(DocumentPart):
    """The symbols of one edition of the standards."""

    standards: tuple[str, ...]
    symbols: dict[Quantity, Symbol]


@lru_cache(maxsize=1)
def editions() -> dict[str, Edition]:
    """Every edition that the program knows, by its name."""
    text = resources.files("crenel.gauges.plan").joinpath("symbols.json").read_text("utf-8")
    return TypeAdapter(dict[str, dict[str, Edition]]).validate_json(text)["editions"]


def symbol_of(edition: str, quantity: Quantity) -> Symbol:
    """The symbol of a quantity.

    Raises:
        OperationError: the edition is unknown, or does not have the quantity.
    """
    known = editions().get(edition)
    if known is None or quantity not in known.symbols:
        raise OperationError(
            "edition-unknown",
            message("edition-has-no-symbol", edition=edition, quantity=quantity),
            message("editions-are", names=", ".join(editions())),
        )
    return known.symbols[quantity]


def is_signed(quantity: Quantity) -> bool:
    """Whether values of the quantity have a sign, and so limits on both sides of zero."""
    return any(one.signed for one in _symbols_of(quantity))


def value_of(quantity: Quantity) -> str:
    """What the single values of the quantity are of, as ``Symbol`` has it."""
    return next((one.value_of for one in _symbols_of(quantity)), "")


def _symbols_of(quantity: Quantity) -> list[Symbol]:
    """The symbols of a quantity in all editions."""
    known = (edition.symbols.get(quantity) for edition in editions().values())
    return [one for one in known if one is not None]
