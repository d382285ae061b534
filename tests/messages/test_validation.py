"""What pydantic refuses, in the program's words."""

from enum import StrEnum
from typing import Annotated, Any, Literal

import pytest
from pydantic import AnyUrl, BaseModel, ConfigDict, Field, ValidationError, field_validator
from pydantic_core import ErrorDetails

from crenel.messages.catalogue import renderer
from crenel.messages.message import Message, message
from crenel.messages.validation import exception_text, validation_text


class Colour(StrEnum):
    RED = "red"
    BLUE = "blue"


class Part(BaseModel):
    number: int = 0


class Values(BaseModel):
    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)

    whole: int = 0
    real: Annotated[float, Field(gt=0, lt=10)] = 1.0
    size: Annotated[int, Field(ge=2, le=5)] = 3
    name: Annotated[str, Field(min_length=2, max_length=4, pattern="^[a-z]*$")] = "ab"
    items: Annotated[list[int], Field(min_length=1, max_length=2)] = [1]
    pair: tuple[int, int] = (1, 2)
    flag: bool = False
    part: Part = Part()
    axis: Literal["u", "v"] = "u"
    only: Literal["one"] = "one"
    colour: Colour = Colour.RED
    checked: str = ""
    url: AnyUrl | None = None

    @field_validator("checked")
    @classmethod
    def _check(cls, value: str) -> str:
        if value == "words":
            raise ValueError("it is refused in words")
        if value:
            raise ValueError(message("cloud-name-proposal", name=value))
        return value


def error_of(values: dict[str, Any]) -> ErrorDetails:
    with pytest.raises(ValidationError) as caught:
        Values.model_validate(values)
    (error,) = caught.value.errors()
    return error


@pytest.mark.parametrize(
    ("values", "english"),
    [
        ({"whole": 1.5}, "it must be a whole number"),
        ({"whole": "x"}, "it must be a whole number"),
        ({"whole": []}, "it must be a whole number"),
        ({"real": "x"}, "it must be a number"),
        ({"real": None}, "it must be a number"),
        ({"real": float("nan")}, "it must be a finite number"),
        ({"real": 0}, "it must be greater than 0"),
        ({"real": 10.5}, "it must be less than 10"),
        ({"size": 1}, "it must be at least 2"),
        ({"size": 6}, "it must be at most 5"),
        ({"name": 1}, "it must be text"),
        ({"name": "a"}, "it must have at least 2 characters"),
        ({"name": "abcde"}, "it must have at most 4 characters"),
        ({"name": "ABC"}, "it must match the pattern ^[a-z]*$"),
        ({"items": 1}, "it must be a list"),
        ({"items": []}, "the list must have at least 1 entry"),
        ({"items": [1, 2, 3]}, "the list must have at most 2 entries"),
        ({"pair": 1}, "it must be a list"),
        ({"pair": [1]}, "it is missing"),
        ({"flag": "maybe"}, "it must be true or false"),
        ({"flag": []}, "it must be true or false"),
        ({"part": 1}, "it must be an object with fields"),
        ({"axis": "w"}, "it must be one of 'u', 'v'"),
        ({"only": "two"}, "it must be 'one'"),
        ({"colour": "green"}, "it must be one of 'red', 'blue'"),
        ({"other": 1}, "it is unknown"),
        ({"checked": "a.ply"}, "Name it a.ply"),
    ],
)
def test_every_usual_error_has_a_message(values: dict[str, Any], english: str) -> None:
    text = validation_text(error_of(values))
    assert isinstance(text, Message)
    assert str(text) == english
    assert renderer("de")(text) not in (english, text.message_id)


def test_what_is_no_json_says_where() -> None:
    with pytest.raises(ValidationError) as caught:
        Values.model_validate_json("{")
    assert "it is not JSON, or is incomplete: EOF" in str(validation_text(caught.value.errors()[0]))


def test_what_is_not_known_is_in_pydantics_words() -> None:
    error = error_of({"url": "no address"})
    assert validation_text(error) == error["msg"]


def test_an_error_raised_with_a_plain_text_keeps_it() -> None:
    assert validation_text(error_of({"checked": "words"})) == "it is refused in words"
    assert exception_text(ValueError()) == ""
