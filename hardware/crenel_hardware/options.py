"""Options of drivers from station.toml, checked; with what a form shows of them."""

from collections.abc import Callable, Mapping
from contextvars import ContextVar
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import ClassVar, TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError

from crenel.messages.message import Text, join, message
from crenel.messages.validation import validation_text
from crenel_hardware.errors import DeviceError


class Options(BaseModel):
    """Base class of driver options: unknown keys are refused, values are not converted, options are
    immutable."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)
    title: ClassVar[Text] = ""
    """What the driver is for, in the list of drivers; empty: its name."""
    usual: ClassVar[bool] = False
    """Whether it is offered before the others."""


@dataclass(frozen=True, slots=True)
class Shown:
    """What a form shows of an option: metadata of its field, in ``Annotated``. An option without it
    has the words of its key; a unit is the ending of the key."""

    label: Text
    help: Text = ""
    """How it is filled in, where the label does not say it."""
    choices: Mapping[str, Text] = field(default_factory=dict)
    """Values in words; the others are shown as they are."""


OptionsT = TypeVar("OptionsT", bound=Options)


class _ModelAsked(Exception):  # noqa: N818 - an answer, not an error
    def __init__(self, model: type[Options]) -> None:
        self.model = model


_asking: ContextVar[bool] = ContextVar("asking for the model of a driver's options", default=False)


def options_model(factory: Callable[[Mapping[str, object]], object]) -> type[Options] | None:
    """The model by which a driver reads its options; None if it does not use ``read_options``.

    Args:
        factory: as the registry has it; it is asked for its model and creates no driver.
    """
    token = _asking.set(True)
    try:
        factory({})
    except _ModelAsked as answer:
        return answer.model
    except Exception:  # of a driver that reads its options in a way of its own
        return None
    finally:
        _asking.reset(token)
    return None


def read_options(model: type[OptionsT], options: Mapping[str, object], table: str) -> OptionsT:
    """The options in one table of station.toml.

    Args:
        model: the options of the driver.
        options: keys and values, without ``driver``.
        table: "arm" or "sensor", for the message.

    Raises:
        DeviceError: names a wrong key and the problem with it.
    """
    if _asking.get():
        raise _ModelAsked(model)
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
