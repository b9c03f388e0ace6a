"""Compiling small loops with Numba, wherever the package is installed."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, Final, ParamSpec, TypeVar, cast

from numba import boolean, float32, float64, intp, njit
from numba import typeof as kind_of

P = ParamSpec("P")
R = TypeVar("R")

FLOAT, INDEX, TRUTH = float64, intp, boolean
FLOATS, INDICES, MASK = float64[:], intp[:], boolean[:]
FLOATS_2D, INDICES_2D, MASK_2D = float64[:, :], intp[:, :], boolean[:, :]
FLOATS_3D, SINGLES_2D = float64[:, :, :], float32[:, :]
"""Kinds of arguments, for `bind`; of arrays, those with gaps, too."""

PACKAGES = Path(__file__).parent, Path(__file__).parent.parent / "policies"
"""Where there are compiled functions, which call each other."""

RULES: Final = "numpy"
"""For divisions; Python's own check for zeros, which keeps loops from running several
at a time."""


def forget_outdated(packages: Sequence[Path]) -> None:
    """Forgets what was compiled before the last change of any source.

    Numba compiles a function anew when its own file has changed, but not when one that
    it calls has: it would silently go on with what that was before.
    """
    files = [file for package in packages for file in package.rglob("*.py")]
    changed = max((file.stat().st_mtime_ns for file in files), default=0)
    for package in packages:
        for index in package.rglob("__pycache__/*.nbi"):
            # Another process may have been faster, or the folder be for reading only.
            with suppress(OSError):
                if index.stat().st_mtime_ns < changed:
                    index.unlink()


forget_outdated(PACKAGES)


def compiled(function: Callable[P, R]) -> Callable[P, R]:
    """Compiles a function, and keeps the result on disk if there is a place for it.

    Numba refuses to compile at all where neither the package's folder nor the user's
    home can be written; then every process compiles for itself.
    """
    try:
        return cast("Callable[P, R]", njit(cache=True, error_model=RULES)(function))
    except RuntimeError:
        return cast("Callable[P, R]", njit(error_model=RULES)(function))


def bind(
    function: Callable[..., R], *first: object, then: Sequence[Any] = ()
) -> Callable[..., R]:
    """Fixes the first arguments of a compiled function, and the kinds of the others.

    Numba finds out at each call of what kind every argument is, and that takes as long
    as many of our loops do. Here it finds out once, so that only arrays of our own may
    be handed over: nobody checks any more whether they hold what they should.

    Args:
        function: From `compiled`.
        first: The same at every call.
        then: Kinds of all that follow.
    """
    compile_for = getattr(function, "compile", None)
    if compile_for is None:  # NUMBA_DISABLE_JIT
        return partial(function, *first)
    return partial(compile_for((*map(kind_of, first), *then)), *first)
