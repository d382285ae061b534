"""Compiling the inner loops."""

from collections.abc import Callable
from typing import TypeVar, cast

from numba import njit

F = TypeVar("F", bound=Callable[..., object])


def kernel(function: F) -> F:
    """Compiles a loop over arrays to machine code that runs without Python's lock.

    The result is cached on disk, so that a later process starts at once. Many
    threads may call a kernel at a time.
    """
    return cast(F, njit(nogil=True, cache=True)(function))
