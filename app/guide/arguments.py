"""What the commands of the guided flows take, checked before anything is done with it."""

from collections.abc import Mapping
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from app.guide.arm.state import Kind
from app.metrology.refusal import Refusal

Args = Mapping[str, object]
Text = Annotated[str, Field(max_length=200)]
"""Valid Unicode: pydantic takes no lone surrogates."""
Number = Annotated[int, Field(ge=0, le=1_000_000)]


class Arguments(BaseModel):
    """What a command takes: nothing beyond its fields, and no value of another type."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class _Choice(Arguments):
    field: Literal["arm", "object", "sensor"]
    id: Text


class _Id(Arguments):
    id: Text


class _Face(Arguments):
    face: Text


class _Index(Arguments):
    index: Number


class _Numbered(Arguments):
    number: Number


class _Back(Arguments):
    to: Text | None = None


class _Hand(Arguments):
    all: bool = False


class _Limit(Arguments):
    limit_um: float | None = None


class _Artefact(Arguments):
    kind: Kind
    size_mm: float | None = None
    standard_uncertainty_mm: float = 0.0


ArgumentTable = Mapping[str, type[Arguments]]
"""By the command's name; one that is not named takes nothing."""
CALIBRATION: ArgumentTable = {
    "choose": _Choice,
    "select_face": _Face,
    "void_point": _Index,
    "void_pose": _Numbered,
    "restore_pose": _Numbered,
    "back": _Back,
    "let_hand": _Hand,
}
ARM: ArgumentTable = {
    "choose_arm": _Id,
    "set_limit": _Limit,
    "choose_artefact": _Artefact,
    "let_hand": _Hand,
}
VERIFICATION: ArgumentTable = {
    "choose_gauge": _Id,
    "void_touch": _Index,
    "void_cloud": _Numbered,
    "restore_cloud": _Numbered,
    "back": _Back,
    "let_hand": _Hand,
}


def checked(table: ArgumentTable, name: str, args: Args) -> Args:
    """A command's arguments, each of its type; null is as if it were not given.

    Raises:
        Refusal: ``bad-request``: one is missing, of another type, or not known.
    """
    given = {field: value for field, value in args.items() if value is not None}
    try:
        return table.get(name, Arguments).model_validate(given).model_dump(exclude_unset=True)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        place = ".".join(str(part) for part in ("args", *first["loc"]))
        raise Refusal(
            "bad-request", "The request is not understood", f"{place}: {first['msg']}"
        ) from error
