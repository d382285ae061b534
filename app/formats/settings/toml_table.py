"""What the tables of ``station.toml`` are made of."""

from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationInfo
from pydantic_core import PydanticKnownError


class TomlTable(BaseModel):
    """Its values are of their own kind, and keys that it does not know are refused."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


def _resolve(value: object, info: ValidationInfo) -> object:
    if not isinstance(value, str):
        return value
    if not value:
        raise PydanticKnownError("string_too_short", {"min_length": 1})
    assert isinstance(info.context, Path)
    return info.context.absolute().parent / Path(value).expanduser()


SettingsPath = Annotated[Path, BeforeValidator(_resolve)]
"""Relative ones are beside the file, whose own path is the context of the validation."""
NonEmpty = Annotated[str, Field(min_length=1)]
Limit = Annotated[float, Field(gt=0, le=10_000, allow_inf_nan=False)]
