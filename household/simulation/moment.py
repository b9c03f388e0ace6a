"""The moment: what is recorded of a household, declared once.

`Moment` names every recorded quantity with its type, unit and shape. The memory that
the simulation works in, snapshots, the columns of a replay file and their reader are
derived from it: a quantity that is added here is recorded and read back.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple, get_args, get_type_hints

import numpy as np
from numpy.typing import DTypeLike, NDArray

from household.compiled.arrays import Floats, Integers, Mask, Singles, scalar_of
from household.scenario.scenario import Scenario

PEOPLE, ROBOTS, EVERYBODY = "people", "robots", "everybody"
"""Axes whose length depends on the household; with everybody, people come first."""

Axes = tuple[str | int, ...]
"""A shape whose lengths may depend on the household."""

Record = NDArray[np.void]
"""One moment, shape (), or several, of the type that `record_type` makes."""

DECISION = "decision"
"""The field of a record that says which moment it is."""


@dataclass(frozen=True, slots=True)
class Recorded:
    """How a quantity is recorded.

    Attributes:
        unit: Its unit; "1" if it is a number without one.
        axes: Its shape at one moment.
        held_as: The type that the simulation computes it in, if that is another.
        held_for: The axes for which the simulation holds it, if these are longer; what
            is recorded comes first.
    """

    unit: str
    axes: Axes
    held_as: type[np.generic] | None = None
    held_for: Axes | None = None


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Moment:
    """What is recorded of a moment, apart from when it is and the touches felt.

    Where there are several moments, the first axis of every array is the moment.
    """

    position: Annotated[Floats, Recorded("m", (EVERYBODY, 2))]
    """Where everybody is."""

    heading: Annotated[Floats, Recorded("rad", (EVERYBODY,))]
    """Where bodies face."""

    gaze: Annotated[Floats, Recorded("rad", (EVERYBODY,))]
    """Where heads point."""

    half_view: Annotated[Floats, Recorded("rad", (PEOPLE,), held_for=(EVERYBODY,))]
    """Half of each person's field of view; negative with the eyes closed."""

    activity: Annotated[Integers, Recorded("1", (PEOPLE,), held_as=np.intp)]
    """Each person's role, as `Activity` values."""

    attends: Annotated[Mask, Recorded("1", (EVERYBODY, EVERYBODY))]
    """Who attends to whom; rows are observers."""

    attention: Annotated[
        Singles, Recorded("1", (EVERYBODY, EVERYBODY), held_as=np.float64)
    ]
    """How much; in single precision, as it fills most of a recording."""

    mood: Annotated[Floats, Recorded("1", (PEOPLE,))]
    """Each person's private mood, in [-1, 1]."""

    behavior: Annotated[Integers, Recorded("1", (ROBOTS,), held_as=np.intp)]
    """Index of what each robot does; -1 before its first choice."""

    begun: Annotated[Integers, Recorded("1", (ROBOTS,), held_as=np.intp)]
    """The decision at which each robot began it; -1 before its first choice."""

    reward: Annotated[Floats, Recorded("1", (ROBOTS,))]
    """Each robot's reward for the step that led here."""

    def at(self, index: int) -> dict[str, NDArray[Any]]:
        """The arrays of one of several moments, by name."""
        return {name: getattr(self, name)[index] for name in FIELDS}


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Moments(Moment):
    """Several moments, one after another."""

    decision: Integers
    """Steps since the episode began; 0 is the moment after the reset."""

    time: Floats
    """The same in seconds."""

    def __len__(self) -> int:
        return len(self.decision)


class Field(NamedTuple):
    """A quantity as `Moment` declares it.

    Attributes:
        dtype: In which it is recorded.
        how: Its unit and shape, and how the simulation holds it.
    """

    dtype: type[np.generic]
    how: Recorded


def _fields() -> Mapping[str, Field]:
    """What the annotations of `Moment` say."""
    fields = {}
    for name, hint in get_type_hints(Moment, include_extras=True).items():
        array, how = get_args(hint)
        fields[name] = Field(scalar_of(array), how)
    return MappingProxyType(fields)


FIELDS = _fields()
"""All quantities in the order in which they are declared, by name."""


def record_type(scenario: Scenario) -> np.dtype[np.void]:
    """The type of a record of one moment, as the simulation holds it."""
    held = [
        (name, how.held_as or dtype, _shape(how.held_for or how.axes, scenario))
        for name, (dtype, how) in FIELDS.items()
    ]
    # Aligned, as its fields are what compiled loops work on.
    return np.dtype([(DECISION, np.int64, ()), *held], align=True)


def recorded_types(scenario: Scenario) -> dict[str, np.dtype[Any]]:
    """Type and shape of each quantity as it is recorded, by name."""
    return {
        name: np.dtype((dtype, _shape(how.axes, scenario)))
        for name, (dtype, how) in FIELDS.items()
    }


def recorded(record: Record, scenario: Scenario) -> dict[str, NDArray[Any]]:
    """Copies what is recorded out of records.

    Args:
        record: Of one moment or of several.
        scenario: The household.

    Returns:
        Arrays by name; the first axes are those of ``record``.
    """
    arrays = {}
    for name, kind in recorded_types(scenario).items():
        first: tuple[Any, ...] = tuple(map(slice, kind.shape))
        arrays[name] = record[name][(..., *first)].astype(kind.base)
    return arrays


def field_of(
    record: Record, name: str, shape: tuple[int, ...], dtype: DTypeLike = np.float64, /
) -> NDArray[Any]:
    """The part of a moment's record that whoever fills it in works on.

    Args:
        record: Of one moment, shape ().
        name: Of the quantity.
        shape: Which it is expected to have.
        dtype: Likewise.

    Returns:
        A view: what is written to it is in the record.

    Raises:
        ValueError: If the quantity is declared otherwise.
    """
    field: NDArray[Any] = record[name]
    if (field.shape, field.dtype) != (shape, np.dtype(dtype)):
        raise ValueError(
            f"{name}: a record holds {field.dtype} of shape {field.shape}, "
            f"not {np.dtype(dtype)} of shape {shape}"
        )
    return field


def _shape(axes: Axes, scenario: Scenario) -> tuple[int, ...]:
    n_people, n_robots = len(scenario.people), len(scenario.robots)
    lengths = {PEOPLE: n_people, ROBOTS: n_robots, EVERYBODY: n_people + n_robots}
    return tuple(axis if isinstance(axis, int) else lengths[axis] for axis in axes)
