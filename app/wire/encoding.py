"""JSON for browsers that always comes about: what is no valid text in it is replaced."""

import re

from pydantic_core import PydanticSerializationError, to_json, to_jsonable_python

SURROGATES = re.compile("[\ud800-\udfff]")
REPLACEMENT = "\N{REPLACEMENT CHARACTER}"


def encode_json(value: object) -> bytes:
    """The value as JSON; not a number is null, half a character ``U+FFFD``."""
    try:
        return to_json(value, inf_nan_mode="null")
    except PydanticSerializationError:
        plain = to_jsonable_python(value, inf_nan_mode="null")
        return to_json(_valid(plain), inf_nan_mode="null")


def _valid(value: object) -> object:
    """Plain values with valid texts only."""
    if isinstance(value, str):
        return SURROGATES.sub(REPLACEMENT, value)
    if isinstance(value, dict):
        return {_valid(key): _valid(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_valid(inner) for inner in value]
    return value
