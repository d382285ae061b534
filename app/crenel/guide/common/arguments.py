"""What the commands of the guided flows take, checked before anything is done with it."""

from collections.abc import Mapping
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from crenel.errors import OperationError
from crenel.messages.message import join, message
from crenel.messages.validation import validation_text

Args = Mapping[str, object]
ShortText = Annotated[str, Field(max_length=200)]
"""Valid Unicode: pydantic takes no lone surrogates."""
Number = Annotated[int, Field(ge=0, le=1_000_000)]


class Arguments(BaseModel):
    """What a command takes: nothing beyond its fields, and no value of another type."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class IdArguments(Arguments):
    id: ShortText


class IndexArguments(Arguments):
    index: Number


class NumberArguments(Arguments):
    number: Number


class BackArguments(Arguments):
    to: ShortText | None = None


class OperatorArguments(Arguments):
    """The arguments of the simulated operator: one step, or all that follow."""

    all: bool = False


def check_arguments(model: type[Arguments], args: Args) -> Args:
    """A command's arguments, each of its type; null is as if it were not given.

    Raises:
        OperationError: ``bad-request``: one is missing, of another type, or not known.
    """
    given = {field: value for field, value in args.items() if value is not None}
    try:
        return model.model_validate(given).model_dump(exclude_unset=True)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        place = ".".join(str(part) for part in ("args", *first["loc"]))
        raise OperationError(
            "bad-request",
            message("request-invalid"),
            join([place, validation_text(first)], ": "),
        ) from error
