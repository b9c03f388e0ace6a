"""Packing: arguments that stay the same are handed to compiled functions in one piece.

At each call Numba takes every array apart anew, which takes as long as many of our
loops do. So what is fixed is taken apart once: the addresses, shapes and strides of
arrays and the values of numbers go into one block of words, and the address of that
block is all that is handed over at a call.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numba import intp, types
from numba.core import cgutils
from numba.core.datamodel import models
from numba.extending import NativeValue, intrinsic, register_model, unbox
from numba.np.arrayobj import populate_array

WORD = np.dtype(np.int64)
"""Of a block."""


class Packed(types.Type):
    """The type of the address of a block.

    Args:
        kinds: The Numba types of what is in it: numbers, arrays and tuples of such.
    """

    def __init__(self, kinds: Sequence[Any]) -> None:
        self.content = types.Tuple(kinds)
        super().__init__(f"Packed({self.content})")

    @property
    def key(self) -> Any:  # noqa: ANN401
        """What makes two types of addresses the same."""
        return self.content


@register_model(Packed)
class _PackedModel(models.PrimitiveModel):
    """An address is a number."""

    def __init__(self, manager: Any, kind: Any) -> None:  # noqa: ANN401
        super().__init__(manager, kind, manager.lookup(intp).get_value_type())


@unbox(Packed)  # type: ignore[untyped-decorator]
def _unbox(_kind: Any, address: Any, context: Any) -> NativeValue:  # noqa: ANN401
    return NativeValue(context.pyapi.long_as_longlong(address))


@intrinsic  # type: ignore[untyped-decorator]
def unpack(_typing: Any, packed: Any) -> Any:  # noqa: ANN401 - as Numba has it
    """In compiled functions: the tuple of what is in a block."""

    def generate(context: Any, builder: Any, _signature: Any, given: Any) -> Any:  # noqa: ANN401
        word = context.get_value_type(intp)
        block = builder.inttoptr(given[0], word.as_pointer())
        words = (
            builder.load(cgutils.gep_inbounds(builder, block, k))
            for k in range(_length(packed.content))
        )
        return _rebuild(packed.content, words, context, builder)

    return packed.content(packed), generate


def _rebuild(kind: Any, words: Iterator[Any], context: Any, builder: Any) -> Any:  # noqa: ANN401
    """Generates the code that makes a value of the next words."""
    if isinstance(kind, types.BaseTuple):
        parts = [_rebuild(part, words, context, builder) for part in kind]
        return context.make_tuple(builder, kind, parts)
    if not isinstance(kind, types.Array):
        bits = builder.trunc if kind == types.boolean else builder.bitcast
        return bits(next(words), context.get_value_type(kind))
    array = context.make_array(kind)(context, builder)
    item = context.get_data_type(kind.dtype)
    data = builder.inttoptr(next(words), item.as_pointer())
    size = context.get_constant(intp, context.get_abi_sizeof(item))
    shape = [next(words) for _ in range(kind.ndim)]
    strides = [next(words) for _ in range(kind.ndim)]
    # Without `meminfo`: nobody counts references; whoever binds keeps the arrays alive.
    populate_array(array, data, shape, strides, size, meminfo=None)
    return array._getvalue()


def _length(kind: Any) -> int:  # noqa: ANN401
    """How many words a value takes."""
    if isinstance(kind, types.BaseTuple):
        return sum(map(_length, kind))
    return 1 + 2 * kind.ndim if isinstance(kind, types.Array) else 1


def layout_of(value: object) -> object:
    """What decides of what Numba type a value is: hashable, equal for one type.

    Args:
        value: A number, an array, or a tuple or list of such.
    """
    if isinstance(value, tuple | list):
        return type(value), *map(layout_of, value)
    if isinstance(value, np.ndarray):
        has = value.flags
        held = has.c_contiguous, has.f_contiguous, has.writeable, has.aligned
        return value.dtype, value.ndim, *held
    return type(value)


def words_of(values: Sequence[object]) -> np.ndarray[Any, np.dtype[np.int64]]:
    """The block of some values: numbers, arrays and tuples of such.

    Holds addresses of arrays, but does not keep them alive.
    """
    return np.fromiter(_words(values), WORD)


def _words(value: Any) -> Iterator[int]:  # noqa: ANN401
    if isinstance(value, tuple | list):
        for part in value:
            yield from _words(part)
    elif isinstance(value, np.ndarray):
        yield value.ctypes.data
        yield from value.shape
        yield from value.strides
    elif isinstance(value, float | np.floating):
        yield int(np.float64(value).view(WORD))
    else:
        yield int(value)
