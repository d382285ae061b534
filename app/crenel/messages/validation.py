"""What is wrong with a value, from pydantic's error: by its type and limits, not its sentence."""

from collections.abc import Callable, Mapping
from typing import Any

from pydantic_core import ErrorDetails

from crenel.messages.message import Message, Text, message

Context = Mapping[str, Any]

_FIXED: dict[str, Message] = {
    "missing": message("value-missing"),
    "extra_forbidden": message("value-not-known"),
    "finite_number": message("value-must-be-finite"),
    "bool_type": message("value-must-be-true-or-false"),
    "bool_parsing": message("value-must-be-true-or-false"),
    "dict_type": message("value-must-be-object"),
    "model_type": message("value-must-be-object"),
    "model_attributes_type": message("value-must-be-object"),
    "dataclass_type": message("value-must-be-object"),
    "int_type": message("value-must-be-whole-number"),
    "int_parsing": message("value-must-be-whole-number"),
    "int_from_float": message("value-must-be-whole-number"),
    "float_type": message("value-must-be-number"),
    "float_parsing": message("value-must-be-number"),
    "string_type": message("value-must-be-text"),
    "list_type": message("value-must-be-list"),
    "tuple_type": message("value-must-be-list"),
}


def validation_text(error: ErrorDetails) -> Text:
    """What a value must be, in half a sentence: "it must be a whole number".

    Errors of other types than those here are shown in pydantic's own words.
    """
    kind, context = error["type"], error.get("ctx", {})
    if kind in _FIXED:
        return _FIXED[kind]
    return _BY_LIMIT[kind](context) if kind in _BY_LIMIT else error["msg"]


def _limit(value: object) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _choice_text(context: Context) -> Text:
    expected = str(context["expected"])
    if " or " not in expected:
        return message("value-must-be", expected=expected)
    return message("value-must-be-one-of", expected=expected.replace(" or ", ", "))


def exception_text(error: Exception) -> Text:
    """What an exception says, as a message where it was raised with one."""
    first = error.args[0] if error.args else ""
    return first if isinstance(first, Text) else str(error)


_BY_LIMIT: dict[str, Callable[[Context], Text]] = {
    "greater_than": lambda given: message("value-must-be-greater", limit=_limit(given["gt"])),
    "greater_than_equal": lambda given: message(
        "value-must-be-at-least", limit=_limit(given["ge"])
    ),
    "less_than": lambda given: message("value-must-be-less", limit=_limit(given["lt"])),
    "less_than_equal": lambda given: message("value-must-be-at-most", limit=_limit(given["le"])),
    "string_too_short": lambda given: message("value-too-short-text", count=given["min_length"]),
    "string_too_long": lambda given: message("value-too-long-text", count=given["max_length"]),
    "too_short": lambda given: message("value-too-short-list", count=given["min_length"]),
    "too_long": lambda given: message("value-too-long-list", count=given["max_length"]),
    "string_pattern_mismatch": lambda given: message(
        "value-must-match-pattern", pattern=str(given["pattern"])
    ),
    "literal_error": _choice_text,
    "enum": _choice_text,
    "value_error": lambda given: exception_text(given["error"]),
    "assertion_error": lambda given: exception_text(given["error"]),
    "json_invalid": lambda given: message("json-cut-off", reason=str(given["error"])),
}
