"""Compiling small loops with Numba, wherever the package is installed."""

import inspect
import os
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache, partial
from pathlib import Path
from typing import Any, Final, ParamSpec, TypeVar, cast

from numba import njit

from household.compiled.packing import Packed, layout_of, unpack, words_of
from household.compiled.patience import PATIENCE
from household.compiled.sharing import Later, turn_at
from household.compiled.signature import (
    Sizes,
    check_of,
    kind_of,
    parameters_of,
    says_enough,
    typeof,
)

P = ParamSpec("P")
R = TypeVar("R")

HOUSEHOLD = Path(__file__).parents[1]

PACKAGES = HOUSEHOLD, HOUSEHOLD.with_name("policies")
"""Where there are compiled functions, which call each other."""

CHECKED: Final = "HOUSEHOLD_CHECKED"
"""Environment variable: 1 for `bind` to check arguments, at some cost."""

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
    return _compiled(function, alone=True)


def compiled_aside(function: Callable[P, R]) -> Callable[P, R]:
    """Compiles a function that takes long; other threads of Python run meanwhile."""
    return _compiled(function, alone=False)


def _compiled(function: Callable[P, R], *, alone: bool) -> Callable[P, R]:
    options: Any = {"error_model": RULES, "nogil": not alone}
    try:
        return cast("Callable[P, R]", njit(cache=True, **options)(function))
    except RuntimeError:
        return cast("Callable[P, R]", njit(**options)(function))


def bind(function: Callable[..., R], *first: object) -> Callable[..., R]:
    """Fixes the first arguments of a compiled function, and the kinds of the others.

    Numba finds out at each call of what kind every argument is, and takes every array
    apart; that takes as long as many of our loops do. Here it finds out once, from the
    annotations of the function, and what is fixed is taken apart once
    (`household.compiled.packing`). So only arrays of our own may be handed over: it no
    longer checks what they hold, and would read wrong memory. Where the environment
    variable `CHECKED` is 1 when a function is bound, as in the tests, every call is
    checked, whether Numba is switched off or not.

    Args:
        function: From `compiled`. All parameters but the first are annotated as
            `household.compiled.signature` says.
        first: The same at every call: numbers, arrays or records of arrays.

    Returns:
        A function of the other arguments, by position. In checked mode it raises a
        TypeError if one has another type, number of dimensions, shape or layout than
        it should have.

    Raises:
        TypeError: If an annotation does not say enough; in checked mode, if one of the
            first arguments is not what it should be.
    """
    parameters = parameters_of(function)
    bound: Callable[..., R] = partial(function, *first)
    if hasattr(function, "compile"):  # Not with NUMBA_DISABLE_JIT.
        bound = _bound(function, parameters, first)
    if os.environ.get(CHECKED) != "1":
        return bound
    return _checked(bound, function.__name__, parameters, first)


def _bound(
    function: Any,  # noqa: ANN401 - a dispatcher of Numba, which is not annotated
    parameters: Mapping[str, Any],
    first: Sequence[object],
) -> Callable[..., Any]:
    """A compiled function whose first arguments are handed over in one piece."""
    if not first:
        return compile_for(function, tuple(map(kind_of, parameters.values())))
    words = words_of(first)
    bound = partial(_found(function, parameters, first), words.ctypes.data)
    # The block and the arrays that it points to live as long as this function does; a
    # copy would share them unseen, so there is none: a memory view cannot be copied.
    bound.kept = words.data, first  # type: ignore[attr-defined]
    return bound


_FOUND: dict[Any, Callable[..., Any]] = {}
"""Compiled functions of packed arguments, by what `layout_of` says of these."""


def _found(
    function: Any,  # noqa: ANN401 - a dispatcher of Numba, which is not annotated
    parameters: Mapping[str, Any],
    first: Sequence[object],
) -> Callable[..., Any]:
    """The compiled function for first arguments of these types.

    For another household of the same kind it is found without asking Numba, which takes
    as long for all types of a household as hundreds of steps.
    """
    layout = function, layout_of(first)
    if layout in _FOUND:
        return _FOUND[layout]
    others = list(parameters.values())[len(first) :]
    kinds = Packed(tuple(map(typeof, first))), *map(kind_of, others)
    found = compile_for(_entry(function, tuple(parameters), len(first)), kinds)
    if not isinstance(found, Later):
        _FOUND[layout] = found
    return found


def compile_for(
    function: Any,  # noqa: ANN401 - a dispatcher of Numba, which is not annotated
    kinds: tuple[Any, ...],
    *,
    wait: bool = False,
) -> Callable[..., Any]:
    """A compiled function for arguments of these kinds, from disk if it is there.

    Whoever waits for the compiler is told so. If another process compiles it just now,
    it is waited for at the first call, unless it is to be at once.
    """
    if kinds in function.overloads:
        return cast("Callable[..., Any]", function.compile(kinds))
    with turn_at(_turn_of(function), wait=wait) as mine:
        if not mine:
            return Later(partial(compile_for, function, kinds, wait=True))
        begin, before = time.perf_counter(), _n_compiled(function)
        found = function.compile(kinds)
        if _n_compiled(function) > before:
            PATIENCE.add(time.perf_counter() - begin)
        return cast("Callable[..., Any]", found)


def _turn_of(function: Any) -> Path | None:  # noqa: ANN401
    """What stands for compiling a function; nothing where it cannot be kept."""
    folder = function.stats.cache_path
    if folder is None:
        return None
    return Path(folder) / f"{function.__module__}.{function.__name__}.lock"


def _n_compiled(function: Any) -> int:  # noqa: ANN401
    """How many versions of a function were compiled here and not read from disk."""
    return len(function.overloads) - sum(function.stats.cache_hits.values())


@lru_cache
def _entry(function: Any, parameters: tuple[str, ...], n_first: int) -> Any:  # noqa: ANN401
    """A compiled function of packed arguments, and others, that calls another one."""
    plain = function.py_func
    first, others = ", ".join(parameters[:n_first]), ", ".join(parameters[n_first:])
    name = f"{plain.__name__}_from_{n_first}"
    source = (
        f"def {name}(packed, {others}):\n"
        f"    {first}, = unpack(packed)\n"
        f"    return function({first}, {others})\n"
    )
    # As if it stood in the same file, so that Numba keeps it on disk beside the other.
    place = {"unpack": unpack, "function": function, "__name__": plain.__module__}
    exec(compile(source, inspect.getfile(plain), "exec"), place)
    return compiled(place[name])


def _checked(
    bound: Callable[..., R],
    function: str,
    parameters: Mapping[str, Any],
    first: Sequence[object],
) -> Callable[..., R]:
    """A bound function that looks at what it is handed over."""
    known: Sizes = {}
    checks = []
    for k, (name, annotation) in enumerate(parameters.items()):
        label = f"{function}(), argument {name}"
        if k >= len(first):
            checks.append(check_of(label, annotation))
        elif says_enough(annotation):
            check_of(label, annotation)(first[k], known)

    def call(*arguments: object) -> R:
        sizes = known.copy()
        for check, argument in zip(checks, arguments, strict=True):
            check(argument, sizes)
        return bound(*arguments)

    return call
