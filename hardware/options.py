"""Options of drivers from station.toml, checked."""

from collections.abc import Mapping
from difflib import get_close_matches
from typing import TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError

from app.messages.message import join, message
from app.messages.validation import validation_text
from hardware.errors import DeviceError


class Options(BaseModel):
    """Base class of driver options: unknown keys are refused, values are not converted, options are
    immutable."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


OptionsT = TypeVar("OptionsT", bound=Options)


def read_options(model: type[OptionsT], options: Mapping[str, object], table: str) -> OptionsT:
    """The options in one table of station.toml.

    Args:
        model: the options of the driver.
        options: keys and values, without ``driver``.
        table: "arm" or "sensor", for the message.

    Raises:
        DeviceError: names a wrong key and the problem with it.
    """
    try:
        return model.model_validate(dict(options))
    except ValidationError as error:
        # A misspelt key appears as one unknown and one missing key: the unknown one is more
        # helpful.
        first = min(error.errors(), key=lambda each: each["type"] != "extra_forbidden")
    key = ".".join(str(part) for part in first["loc"][:1])
    known = sorted(model.model_fields)
    if first["type"] == "extra_forbidden":
        near = get_close_matches(key, known, 1)
        takes = message("driver-takes", names=", ".join(known))
        raise DeviceError(
            message("station-toml-driver-has-no-option", table=table, key=repr(key)),
            join([message("did-you-mean", name=near[0]), takes], " ") if near else takes,
        )
    if first["type"] == "missing":
        raise DeviceError(
            message("station-toml-option-missing", table=table, key=repr(key)),
            message("add-line", key=key),
        )
    raise DeviceError(
        message(
            "station-toml-value-unusable",
            table=table,
            key=key,
            value=repr(first["input"]),
            reason=validation_text(first),
        ),
        message("correct-option", key=key),
    )
