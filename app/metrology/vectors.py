"""Vectors as the compiler writes them: what loops over numbers and over grey levels share."""

from typing import Any

from numba.core.cgutils import ir  # type: ignore[attr-defined]

_PLACE = ir.IntType(32)


def spread(builder: Any, value: Any, vector: Any) -> Any:
    """One number in all lanes of a vector's type."""
    empty = ir.Constant(vector, ir.Undefined)
    first = builder.insert_element(empty, value, ir.Constant(_PLACE, 0))
    nowhere = ir.Constant(ir.VectorType(_PLACE, vector.count), [0] * vector.count)
    return builder.shuffle_vector(first, empty, nowhere)


def place(context: Any, builder: Any, vector: Any, kind: Any, array: Any, index: Any) -> Any:
    """Where a vector begins in an array of a kind."""
    data = context.make_array(kind)(context, builder, array).data
    return builder.bitcast(builder.gep(data, [index]), vector.as_pointer())


def picked(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
    """Of two vectors the first's lanes where the answers, the first argument, are yes."""
    return builder.select(*arguments)
