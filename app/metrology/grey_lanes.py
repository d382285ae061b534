# mypy: allow-untyped-calls, allow-untyped-decorators
"""Sixty-four grey levels side by side, for loops over whole rows of an image.

What is done to sixty-four at once is done to a single one by the same function, so that
the end of a row, which is no multiple of sixty-four, is told in the same words.
"""

from collections.abc import Callable
from typing import Any, Protocol, TypeVar, cast

import numpy as np
from numba import types
from numba.core import cgutils
from numba.core.cgutils import ir  # type: ignore[attr-defined]
from numba.extending import intrinsic, models, register_model
from numpy.typing import NDArray

from app.metrology.vectors import picked, place, spread

GREYS = 64


class Greys(Protocol):
    """Sixty-four grey levels of 8 or 16 bits."""


class Which(Protocol):
    """Sixty-four answers, yes or no."""


Grey = NDArray[np.uint8] | NDArray[np.uint16]
Level = TypeVar("Level", Greys, np.uint8, np.uint16, np.uint8 | np.uint16)


class _GreysType(types.Type):
    """What the compiler calls ``Greys``, of so many bits."""

    def __init__(self, bits: int) -> None:
        super().__init__(f"Greys{bits}")
        self.bits = bits


class _WhichType(types.Type):
    """What the compiler calls ``Which``."""


_GREYS = {types.uint8: _GreysType(8), types.uint16: _GreysType(16)}
_WHICH = _WhichType("Which")
_LEVELS = {*_GREYS, *_GREYS.values()}


@register_model(_GreysType)
class _GreysModel(models.PrimitiveModel):
    """How the compiler holds them: in one vector."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, ir.VectorType(ir.IntType(kind.bits), GREYS))


@register_model(_WhichType)
class _WhichModel(models.PrimitiveModel):
    """How the compiler holds them: in one vector of bits."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, ir.VectorType(ir.IntType(1), GREYS))


def _same(value: Any, kind: Any) -> Any:
    """A number in all lanes of a vector, or as it is."""
    if not isinstance(kind, ir.VectorType):
        return ir.Constant(kind, value)
    return ir.Constant(kind, [value] * GREYS)


def _wider(kind: Any) -> Any:
    if not isinstance(kind, ir.VectorType):
        return ir.IntType(32)
    return ir.VectorType(ir.IntType(2 * kind.element.width), GREYS)


def _of_two(generate: Callable[[Any, Any, Any], Any], answers: bool = False) -> Any:
    """A function of two levels, or of sixty-four and sixty-four, of the same bits."""

    def typed(context: Any, a: Any, b: Any) -> Any:
        if a != b or a not in _LEVELS:
            return None
        yes_or_no = types.boolean if a in _GREYS else _WHICH

        def lowered(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return generate(builder, *arguments)

        return (yes_or_no if answers else a)(a, b), lowered

    return intrinsic(typed)


def _mean(builder: Any, a: Any, b: Any) -> Any:
    wide = _wider(a.type)
    total = builder.add(builder.zext(a, wide), builder.zext(b, wide))
    rounded = builder.lshr(builder.add(total, _same(1, wide)), _same(1, wide))
    return builder.trunc(rounded, a.type)


def _built_in(name: str) -> Callable[[Any, Any, Any], Any]:
    """An operation that processors have for vectors of whole numbers."""

    def generate(builder: Any, a: Any, b: Any) -> Any:
        element = getattr(a.type, "element", a.type)
        kind = f"v{GREYS}i{element.width}" if element is not a.type else f"i{element.width}"
        declare = cast(Callable[..., Any], cgutils.get_or_insert_function)
        function = ir.FunctionType(a.type, [a.type, a.type])
        return builder.call(declare(builder.module, function, f"llvm.{name}.{kind}"), [a, b])

    return generate


def _over(builder: Any, a: Any, b: Any) -> Any:
    return builder.icmp_unsigned(">", a, b)


def _load_greys(context: Any, array: Any, index: Any) -> Any:
    """The sixty-four grey levels of an array from ``index`` on."""
    greys = _GREYS[array.dtype]

    def lowered(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        vector = context.get_value_type(greys)
        begin = place(context, builder, vector, signature.args[0], *arguments)
        return builder.load(begin, align=1)

    return greys(array, types.uintp), lowered


def _store_greys(context: Any, array: Any, index: Any, value: Any) -> Any:
    """Puts sixty-four grey levels into an array from ``index`` on."""

    def lowered(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        levels = arguments[2]
        begin = place(context, builder, levels.type, signature.args[0], *arguments[:2])
        builder.store(levels, begin, align=1)
        return context.get_dummy_value()

    return types.void(array, types.uintp, _GREYS[array.dtype]), lowered


def _all_greys(context: Any, value: Any) -> Any:
    """One grey level sixty-four times."""
    greys = _GREYS[value]

    def lowered(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return spread(builder, arguments[0], context.get_value_type(greys))

    return greys(value), lowered


def _pick(context: Any, which: Any, one: Any, other: Any) -> Any:
    """``one`` where the answer is yes, ``other`` elsewhere."""
    return one(which, one, other), picked


def _bits(context: Any, which: Any) -> Any:
    """Sixty-four answers as a number's bits, the first the lowest."""

    def lowered(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.bitcast(arguments[0], ir.IntType(GREYS))

    return types.uint64(which), lowered


def _first_bit(context: Any, bits: Any) -> Any:
    """Which is the lowest bit of a number, not 0, that is set."""

    def lowered(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.cttz(arguments[0], ir.Constant(ir.IntType(1), 1))

    return types.uint64(types.uint64), lowered


mean = cast(Callable[[Level, Level], Level], _of_two(_mean))
"""Rounded up."""
plus = cast(Callable[[Level, Level], Level], _of_two(lambda builder, a, b: builder.add(a, b)))
lower = cast(Callable[[Level, Level], Level], _of_two(_built_in("umin")))
higher = cast(Callable[[Level, Level], Level], _of_two(_built_in("umax")))
excess = cast(Callable[[Level, Level], Level], _of_two(_built_in("usub.sat")))
"""By how much the first is over the second, or 0."""
over = cast(Callable[[Level, Level], Any], _of_two(_over, answers=True))
"""Where the first is over the second."""
pick = cast(Callable[[Any, Level, Level], Level], intrinsic(_pick))
load_greys = cast(Callable[[Grey, np.uintp], Greys], intrinsic(_load_greys))
store_greys = cast(Callable[[Grey, np.uintp, Greys], None], intrinsic(_store_greys))
all_greys = cast(Callable[[np.uint8 | np.uint16], Greys], intrinsic(_all_greys))
bits = cast(Callable[[Which], np.uint64], intrinsic(_bits))
first_bit = cast(Callable[[np.uint64], np.uint64], intrinsic(_first_bit))
