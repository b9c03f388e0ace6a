"""State: all that changes from moment to moment, taken and put back.

An object that changes is `Stateful`: it names its attributes that do. Whatever else it
holds is made once and stays. State is put back in place, since compiled loops hold on
to the arrays that they work on.
"""

from typing import Any, ClassVar

import numpy as np


class Stateful:
    """Something that changes.

    Attributes:
        STATE: Names of the attributes that do. They may hold arrays, random generators,
            other stateful things, and lists, tuples and records of those; whatever else
            they hold is replaced as a whole, so that nobody else may hold on to it.
    """

    STATE: ClassVar[tuple[str, ...]]


def state_of(thing: Stateful) -> dict[str, Any]:
    """The state of something, by name; to be pickled before anything goes on.

    Args:
        thing: What changes.
    """
    return {name: _taken(getattr(thing, name)) for name in thing.STATE}


def put_back(thing: Stateful, state: dict[str, Any]) -> None:
    """Puts a state back.

    Args:
        thing: Made as that was whose state it is.
        state: From `state_of`; not to be used otherwise afterwards.
    """
    for name, value in state.items():
        if not _filled(getattr(thing, name), value):
            setattr(thing, name, value)


def _taken(value: Any) -> Any:  # noqa: ANN401 - anything may be state
    """What to keep of a value."""
    if isinstance(value, Stateful):
        return state_of(value)
    if isinstance(value, np.random.Generator):
        return value.bit_generator.state
    if _has_parts(value):
        parts = [_taken(part) for part in value]
        return value._make(parts) if hasattr(value, "_make") else parts
    return value


def _filled(now: Any, value: Any) -> bool:  # noqa: ANN401 - anything may be state
    """Puts a value back in place, if there is a place for it."""
    if isinstance(now, np.ndarray) and now.shape == value.shape:
        now[...] = value
    elif isinstance(now, Stateful):
        put_back(now, value)
    elif isinstance(now, np.random.Generator):
        now.bit_generator.state = value
    elif _has_parts(now):
        # A record of arrays that have grown since is replaced as a whole.
        return all(_filled(part, kept) for part, kept in zip(now, value, strict=True))
    else:
        return False
    return True


def _has_parts(value: Any) -> bool:  # noqa: ANN401 - anything may be state
    """Whether a list or tuple holds only what is put back in place."""
    return (
        isinstance(value, list | tuple)
        and len(value) > 0
        and all(
            isinstance(v, Stateful | np.random.Generator | np.ndarray) for v in value
        )
    )
