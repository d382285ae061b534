# mypy: allow-untyped-calls, allow-untyped-decorators
"""Sixteen numbers side by side in a processor's registers, for the innermost loops.

A compiled loop over an array keeps its sums in memory; sums of this kind stay in registers
from the loop's first turn to its last. On a processor with narrower vectors the compiler
takes two or four of them for one.
"""

import operator
from collections.abc import Callable
from typing import Any, ClassVar, Protocol, cast

import numpy as np
from numba import types
from numba.core.cgutils import ir  # type: ignore[attr-defined]
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, models, register_model
from numpy.typing import NDArray

from app.metrology.vectors import picked, place, spread

WIDTH = np.uintp(16)
_FAST = ("contract", "nsz")


class Mask(Protocol):
    """Sixteen answers, yes or no."""

    def __and__(self, other: "Mask") -> "Mask": ...


class Lanes(Protocol):
    """Sixteen numbers of single precision; every operation is one of each with its like."""

    def __add__(self, other: "Lanes | np.float32") -> "Lanes": ...
    def __sub__(self, other: "Lanes | np.float32") -> "Lanes": ...
    def __mul__(self, other: "Lanes | np.float32") -> "Lanes": ...
    def __truediv__(self, other: "Lanes | np.float32") -> "Lanes": ...
    def __lt__(self, other: "Lanes | np.float32") -> Mask: ...
    def __le__(self, other: "Lanes | np.float32") -> Mask: ...
    def __gt__(self, other: "Lanes | np.float32") -> Mask: ...
    def __ge__(self, other: "Lanes | np.float32") -> Mask: ...


class _LanesType(types.Type):
    """What the compiler calls ``Lanes``."""


class _MaskType(types.Type):
    """What the compiler calls ``Mask``."""


_LANES, _MASK, _SINGLE = _LanesType("Lanes"), _MaskType("Mask"), types.float32
_LANES_IR = ir.VectorType(ir.FloatType(), int(WIDTH))
_MASK_IR = ir.VectorType(ir.IntType(1), int(WIDTH))
_PLACE = ir.IntType(32)


@register_model(_LanesType)
class _LanesModel(models.PrimitiveModel):
    """How the compiler holds them: in one vector."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _LANES_IR)


@register_model(_MaskType)
class _MaskModel(models.PrimitiveModel):
    """How the compiler holds them: in one vector of bits."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _MASK_IR)


def _spread(builder: Any, value: Any) -> Any:
    """Lanes as they are; a number in all lanes."""
    return value if value.type == _LANES_IR else spread(builder, value, _LANES_IR)


def _offer(function: Callable[..., Any], result: Any, generate: Callable[..., Any]) -> None:
    """Lets compiled code use an operator on lanes, and on lanes and a number."""
    pairs = [(_LANES, _LANES), (_LANES, _SINGLE)]

    class _Operator(ConcreteTemplate):
        cases: ClassVar = [signature(result, *pair) for pair in pairs]

    def lower(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return generate(builder, *(_spread(builder, value) for value in arguments))

    infer_global(function)(_Operator)
    for pair in pairs:
        lower_builtin(function, *pair)(lower)


_offer(operator.add, _LANES, lambda builder, a, b: builder.fadd(a, b, flags=_FAST))
_offer(operator.sub, _LANES, lambda builder, a, b: builder.fsub(a, b, flags=_FAST))
_offer(operator.mul, _LANES, lambda builder, a, b: builder.fmul(a, b, flags=_FAST))
_offer(operator.truediv, _LANES, lambda builder, a, b: builder.fdiv(a, b, flags=_FAST))
_offer(operator.lt, _MASK, lambda builder, a, b: builder.fcmp_ordered("<", a, b))
_offer(operator.le, _MASK, lambda builder, a, b: builder.fcmp_ordered("<=", a, b))
_offer(operator.gt, _MASK, lambda builder, a, b: builder.fcmp_ordered(">", a, b))
_offer(operator.ge, _MASK, lambda builder, a, b: builder.fcmp_ordered(">=", a, b))


@infer_global(operator.and_)
class _Both(ConcreteTemplate):
    cases: ClassVar = [signature(_MASK, _MASK, _MASK)]


@lower_builtin(operator.and_, _MASK, _MASK)
def _both(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
    return builder.and_(*arguments)


def _load(context: Any, array: Any, index: Any) -> Any:
    """The sixteen numbers of an array of single precision from ``index`` on."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        begin = place(context, builder, _LANES_IR, signature.args[0], *arguments)
        return builder.load(begin, align=4)

    return _LANES(array, types.uintp), generate


def _load_whole(context: Any, array: Any, index: Any) -> Any:
    """The sixteen whole numbers of an array from ``index`` on, none below zero."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        whole = ir.VectorType(context.get_data_type(signature.args[0].dtype), int(WIDTH))
        begin = place(context, builder, whole, signature.args[0], *arguments)
        return builder.uitofp(builder.load(begin, align=1), _LANES_IR)

    return _LANES(array, types.uintp), generate


def _store(context: Any, array: Any, index: Any, value: Any) -> Any:
    """Puts sixteen numbers into an array of single precision from ``index`` on."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        begin = place(context, builder, _LANES_IR, signature.args[0], *arguments[:2])
        builder.store(arguments[2], begin, align=4)
        return context.get_dummy_value()

    return types.void(array, types.uintp, _LANES), generate


def _all_lanes(context: Any, value: Any) -> Any:
    """One number in all lanes."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _spread(builder, arguments[0])

    return _LANES(_SINGLE), generate


def _where(context: Any, which: Any, one: Any, other: Any) -> Any:
    """``one`` in the lanes where the mask says yes, ``other`` elsewhere."""
    return _LANES(_MASK, _LANES, _LANES), picked


def _highest(context: Any, lanes: Any) -> Any:
    """The largest of sixteen numbers: the larger of two halves, again and again."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        (lanes,) = arguments
        for half in (8, 4, 2, 1):
            places = [(i + half) % int(WIDTH) for i in range(int(WIDTH))]
            order = ir.Constant(ir.VectorType(_PLACE, int(WIDTH)), places)
            turned = builder.shuffle_vector(lanes, lanes, order)
            lanes = builder.select(builder.fcmp_ordered(">", lanes, turned), lanes, turned)
        return builder.extract_element(lanes, ir.Constant(_PLACE, 0))

    return _SINGLE(_LANES), generate


load = cast(Callable[[NDArray[np.float32], np.uintp], Lanes], intrinsic(_load))
load_whole = cast(
    Callable[[NDArray[np.uint8] | NDArray[np.uint16], np.uintp], Lanes], intrinsic(_load_whole)
)
store = cast(Callable[[NDArray[np.float32], np.uintp, Lanes], None], intrinsic(_store))
all_lanes = cast(Callable[[np.float32], Lanes], intrinsic(_all_lanes))
where = cast(Callable[[Mask, Lanes, Lanes], Lanes], intrinsic(_where))
highest = cast(Callable[[Lanes], np.float32], intrinsic(_highest))
