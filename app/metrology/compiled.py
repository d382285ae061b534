"""Compiling the inner loops."""

import hashlib
import linecache
import re
import sys
import uuid
from collections.abc import Callable
from functools import cache
from typing import TypeVar, cast

from numba import njit
from numba.core.dispatcher import Dispatcher

F = TypeVar("F", bound=Callable[..., object])

PROCESS = uuid.uuid4().hex[:8]
"""Names this process, wherever the kernels are kept."""
ROOM = __name__.split(".")[0]
IMPORTED = re.compile(rf"^from ({ROOM}\.[\w.]+) import ", re.MULTILINE)
HAS_KERNELS = re.compile(r"^from (numba|.*\.compiled)\b", re.MULTILINE)


def kernel(function: F) -> F:
    """Compiles a loop over arrays to machine code that runs without Python's lock.

    The result is cached on disk, so that a later process starts at once. Many
    threads may call a kernel at a time.
    """
    return cast(F, renewed(njit(nogil=True, cache=True)(function), function))


def compiled_here(function: Callable[..., object]) -> bool:
    """Whether a kernel had to be compiled in this process, since none was kept on disk."""
    return isinstance(function, Dispatcher) and bool(function.stats.cache_misses)


def renewed(compiled: object, function: Callable[..., object]) -> object:
    """The kernel, compiled anew once any file has changed whose code or constants are in it.

    numba by itself looks only at the file that the kernel stands in. It also numbers what it
    keeps before it writes it, so that of two processes one may read the other's code in place
    of its own, and crash: here each names its files its own way.
    """
    kept = getattr(getattr(compiled, "_cache", None), "_cache_file", None)
    if kept is not None:  # as it is where numba is switched off
        kept._source_stamp = _stamp(function.__module__)
        name = kept._data_name_pattern.removesuffix(".nbc")
        kept._data_name_pattern = f"{name}-{PROCESS}.nbc"
    return compiled


@cache
def _stamp(module: str) -> str:
    """Names the text of a module and of all files of kernels that it imports."""
    seen: dict[str, str] = {}
    todo = [module]
    while todo:
        name = todo.pop()
        if name in seen:
            continue
        text = _text(name)
        if name == module or HAS_KERNELS.search(text):
            seen[name] = text
            todo += IMPORTED.findall(text)
    texts = "\0".join(seen[name] for name in sorted(seen))
    return hashlib.sha256(texts.encode()).hexdigest()


@cache
def _text(module: str) -> str:
    return "".join(linecache.getlines(str(sys.modules[module].__file__)))
