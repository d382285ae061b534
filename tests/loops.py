"""Which inner loops have been compiled, or read from the cache, in this process."""

import sys

from numba.core.registry import CPUDispatcher


def loops() -> dict[str, set[str]]:
    """The kinds of arguments of every loop of the software that has been called, by its name."""
    modules = [m for name, m in sys.modules.items() if name.startswith(("app.", "hardware."))]
    found = {
        f"{loop.py_func.__module__}.{loop.py_func.__name__}": {str(s) for s in loop.signatures}
        for module in modules
        for loop in vars(module).values()
        if isinstance(loop, CPUDispatcher)
    }
    return {name: kinds for name, kinds in found.items() if kinds}
