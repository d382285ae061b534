"""Declaration of C functions, and checks of their arguments.

The C code trusts its callers: pointers, types, shapes and contiguity are checked only here. A
function's parameters are declared in the order of its C prototype, which begins
with the symbolic sizes of its arrays, as ``int64_t``, in the order in which they first appear::

    # EXPORT(void, spread)(int64_t n, const double *points, const double *sigma, double along, ...
    spread = Function(CRENEL, "spread", Array(F64, "n", 3), Array(F64, "n"), Real(), ...)
    spread(points, sigma, 0.5)
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from crenel.native.library import NativeLibrary

F64, F32 = np.dtype(np.float64), np.dtype(np.float32)
I64, I32, I8 = np.dtype(np.int64), np.dtype(np.int32), np.dtype(np.int8)
U8, U16, BOOL = np.dtype(np.uint8), np.dtype(np.uint16), np.dtype(np.bool_)


class ArgumentError(TypeError):
    """A C function is called with an array whose type, shape or layout differs from its
    declaration."""


@dataclass(frozen=True, init=False)
class Array:
    """A C-contiguous array parameter.

    ``sizes``: whole numbers, or names that stand for one size throughout a call.
    ``written``: whether the function writes to it. ``optional``: None is passed as NULL.
    """

    dtype: np.dtype[Any]
    sizes: tuple[int | str, ...]
    written: bool
    optional: bool
    symbols: tuple[str, ...]

    def __init__(
        self,
        dtype: np.dtype[Any],
        *sizes: int | str,
        written: bool = False,
        optional: bool = False,
    ) -> None:
        object.__setattr__(self, "dtype", dtype)
        object.__setattr__(self, "sizes", sizes)
        object.__setattr__(self, "written", written)
        object.__setattr__(self, "optional", optional)
        symbols = dict.fromkeys(size for size in sizes if isinstance(size, str))
        object.__setattr__(self, "symbols", tuple(symbols))


@dataclass(frozen=True)
class Integer:
    """An integer, ``int64_t`` in C."""


@dataclass(frozen=True)
class Real:
    """A number, ``double`` in C."""


@dataclass(frozen=True)
class Record:
    """A pointer to a structure."""

    kind: type[ctypes.Structure]


Parameter = Array | Integer | Real | Record
RESULTS: dict[Any, Any] = {int: ctypes.c_int64, float: ctypes.c_double}


class Function:
    """A function of a library; calls the variant that the library has selected.

    Python's lock is released while it runs.
    """

    def __init__(
        self,
        library: NativeLibrary,
        name: str,
        *parameters: Parameter,
        returns: type[int] | type[float] | None = None,
    ) -> None:
        """Declares the function; the library is loaded at the first call.

        Args:
            returns: ``int`` for ``int64_t``, ``float`` for ``double``; otherwise nothing.
        """
        self._library, self.name = library, name
        self._parameters = parameters
        self._returns = returns
        self._sizes = _symbols(parameters)
        self._variants: dict[str, Callable[..., Any]] = {}

    def __call__(self, *arguments: Any) -> Any:
        """Checks the arguments and calls the function; returns a number of the declared type.

        Raises:
            ArgumentError: an array differs from its declaration.
        """
        if len(arguments) != len(self._parameters):
            raise ArgumentError(f"{self.name} takes {len(self._parameters)} arguments")
        sizes = dict.fromkeys(self._sizes, -1)
        passed: list[Any] = []
        for at, (parameter, value) in enumerate(zip(self._parameters, arguments, strict=True)):
            if type(parameter) is Array:
                if value is None and parameter.optional:
                    passed.append(None)
                    continue
                trouble = _mismatch(parameter, value, sizes)
                if trouble:
                    raise ArgumentError(f"Argument {at + 1} of {self.name}: {trouble}")
                passed.append(_address(value))
            elif type(parameter) is Record:
                passed.append(ctypes.byref(value))
            else:
                passed.append(value)
        call = self._variants.get(self._library.variant) or self._bind()
        return call(*sizes.values(), *passed)

    def _bind(self) -> Callable[..., Any]:
        variant = self._library.variant
        found = self._library.symbol(self.name, variant)
        kinds: list[Any] = [ctypes.c_int64] * len(self._sizes)
        kinds += [_ctype(one) for one in self._parameters]
        found.argtypes = kinds
        found.restype = RESULTS.get(self._returns)
        self._variants[variant] = found
        return found


def _ctype(parameter: Parameter) -> Any:
    if isinstance(parameter, Record):
        return ctypes.POINTER(parameter.kind)
    return {Array: ctypes.c_void_p, Integer: ctypes.c_int64, Real: ctypes.c_double}[type(parameter)]


def pointer(array: NDArray[Any], parameter: Array) -> int:
    """The address of an array for the field of a structure, whose owner must keep the array alive.

    Raises:
        ArgumentError: it differs from its declaration; symbolic sizes are not checked.
    """
    trouble = _mismatch(parameter, array, dict.fromkeys(parameter.symbols, -1))
    if trouble:
        raise ArgumentError(trouble)
    return _address(array)


def _address(array: NDArray[Any]) -> int:
    """The address of a contiguous array; faster than ctypes by a factor of three."""
    if array.flags.writeable and array.size:
        return ctypes.addressof(ctypes.c_char.from_buffer(array.data))
    return int(array.ctypes.data)


def _symbols(parameters: tuple[Parameter, ...]) -> tuple[str, ...]:
    """The symbolic sizes, in the order in which they first appear."""
    arrays = [one for one in parameters if isinstance(one, Array)]
    return tuple(dict.fromkeys(symbol for one in arrays for symbol in one.symbols))


def _mismatch(parameter: Array, value: object, sizes: dict[str, int]) -> str:
    """The problem of an array, or nothing; records the values of symbolic sizes."""
    if not isinstance(value, np.ndarray):
        return f"an array is needed, not {type(value).__name__}"
    if value.dtype != parameter.dtype:
        return f"{parameter.dtype} is needed, not {value.dtype}"
    if value.ndim != len(parameter.sizes):
        return f"{len(parameter.sizes)} axes are needed, not {value.ndim}"
    for found, wanted in zip(value.shape, parameter.sizes, strict=True):
        if isinstance(wanted, str):
            if sizes[wanted] < 0:
                sizes[wanted] = found
            wanted = sizes[wanted]
        if found != wanted:
            return f"shape {parameter.sizes} is needed, not {value.shape} (sizes: {sizes})"
    flags = value.flags
    if not flags.c_contiguous:
        return "a C-contiguous array is needed"
    if parameter.written and not flags.writeable:
        return "a writable array is needed"
    return ""
