"""Fetching memory before it is needed."""

from collections.abc import Callable
from typing import Any, cast

import numpy as np
from numba import types
from numba.core import cgutils
from numba.core.cgutils import ir  # type: ignore[attr-defined]
from numba.extending import intrinsic
from numpy.typing import NDArray


def _prefetch(context: Any, row: Any, index: Any) -> Any:
    """Asks the memory for the cache line of ``row[index]`` without waiting for it."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        array = context.make_array(signature.args[0])(context, builder, arguments[0])
        byte, whole = ir.IntType(8).as_pointer(), ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [byte, whole, whole, whole])
        declare = cast(Callable[..., Any], cgutils.get_or_insert_function)
        function = declare(builder.module, kind, "llvm.prefetch.p0")
        address = builder.bitcast(builder.gep(array.data, [arguments[1]]), byte)
        reading, keep, data = (ir.Constant(whole, value) for value in (0, 3, 1))
        builder.call(function, [address, reading, keep, data])
        return context.get_dummy_value()

    return types.void(row, types.intp), generate


prefetch = cast(Callable[[NDArray[np.generic], int], None], intrinsic(_prefetch))
