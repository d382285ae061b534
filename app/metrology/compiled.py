"""Compiling the inner loops."""

from collections.abc import Callable
from typing import TypeVar, cast

from numba import njit
from numba.core.dispatcher import Dispatcher

F = TypeVar("F", bound=Callable[..., object])


def kernel(function: F) -> F:
    """Compiles a loop over arrays to machine code that runs without Python's lock.

    The result is cached on disk, so that a later process starts at once. Many
    threads may call a kernel at a time.
    """
    return cast(F, njit(nogil=True, cache=True)(function))


def vector_kernel(function: F) -> F:
    """As ``kernel``, for loops that a processor takes many elements at a time of.

    A division by zero gives inf or NaN, as in numpy, since a branch would keep the loop
    from being vectorised; a product and a sum may be rounded once together. NaN stays NaN.
    """
    compiled = njit(nogil=True, cache=True, error_model="numpy", fastmath={"contract"})
    return cast(F, compiled(function))


def compiled_here(function: Callable[..., object]) -> bool:
    """Whether a kernel had to be compiled in this process, since none was kept on disk."""
    return isinstance(function, Dispatcher) and bool(function.stats.cache_misses)
