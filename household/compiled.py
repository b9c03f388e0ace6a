"""Compiling small loops with Numba, wherever the package is installed."""

from collections.abc import Callable
from typing import ParamSpec, TypeVar, cast

from numba import njit

P = ParamSpec("P")
R = TypeVar("R")


def compiled(function: Callable[P, R]) -> Callable[P, R]:
    """Compiles a function, and keeps the result on disk if there is a place for it.

    Numba refuses to compile at all where neither the package's folder nor the user's
    home can be written; then every process compiles for itself.
    """
    try:
        return cast("Callable[P, R]", njit(cache=True)(function))
    except RuntimeError:
        return cast("Callable[P, R]", njit(function))
