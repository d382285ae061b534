"""Driver options as station.toml gives them, checked."""

from collections.abc import Mapping
from difflib import get_close_matches
from typing import TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError

from hardware.errors import DeviceError


class Options(BaseModel):
    """Base of a driver's options: nothing unknown, nothing converted, nothing changed."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


OptionsT = TypeVar("OptionsT", bound=Options)


def read_options(model: type[OptionsT], options: Mapping[str, object], table: str) -> OptionsT:
    """The options of one table of station.toml.

    Args:
        model: what the driver takes.
        options: keys and values, without ``driver``.
        table: "arm" or "sensor", for the message.

    Raises:
        DeviceError: naming a wrong key and what is wrong with it.
    """
    try:
        return model.model_validate(dict(options))
    except ValidationError as error:
        # A misspelt key shows as an unknown and a missing one: the unknown one says more.
        first = min(error.errors(), key=lambda each: each["type"] != "extra_forbidden")
    key = ".".join(str(part) for part in first["loc"][:1])
    known = sorted(model.model_fields)
    if first["type"] == "extra_forbidden":
        near = get_close_matches(key, known, 1)
        meant = f"Did you mean {near[0]}? " if near else ""
        raise DeviceError(
            f"station.toml, [{table}]: the driver has no option {key!r}",
            f"{meant}It takes {', '.join(known)}.",
        )
    if first["type"] == "missing":
        raise DeviceError(
            f"station.toml, [{table}]: the option {key!r} is missing", f"Add a line {key} = …"
        )
    raise DeviceError(
        f"station.toml, [{table}]: {key} = {first['input']!r} cannot be used: {first['msg']}",
        f"Correct {key}.",
    )
