"""Wishes: whom people are out to touch, and who has it at hand."""

from collections.abc import Iterable, Sequence
from typing import Annotated

import numpy as np

from household.compiled.arrays import NOBODY, Floats, Indices, Mask
from household.compiled.jit import bind, compiled
from household.motion.progress import within_reach
from household.people.mind import Wish
from household.perception.obstruction import between
from household.state import Stateful

REACH = 0.8
"""From the middle of a person to the middle of a robot that it touches [m]."""


class Wishes(Stateful):
    """The touches that people are out to give.

    Args:
        n: How many people there are.

    Attributes:
        target: Index of the body that each is out to touch, or `NOBODY`, shape
            (n_people,).
        touched: Whose wish was fulfilled since the last decision, shape (n_people,).
    """

    STATE = ("target", "touched", "_wishes")

    def __init__(self, n: int) -> None:
        self._wishes: dict[int, Wish] = {}
        self._near = np.zeros(n, np.bool_)
        self._can_touch = bind(_can_touch)
        self.target = np.full(n, NOBODY, np.intp)
        self.touched = np.zeros(n, np.bool_)

    def forget(self) -> None:
        """Begins a new episode: nobody wants anything."""
        self._wishes.clear()
        self.target[:] = NOBODY
        self.touched[:] = False

    def take_up(self, wishes: Sequence[Wish | None], changed: Iterable[int]) -> None:
        """Whoever has another wish than before pursues that one from now on.

        Args:
            wishes: The wish of each, if any.
            changed: Whose wish is another.
        """
        for i in changed:
            wish = wishes[i]
            if wish is None:
                self._drop(i)
            else:
                self._wishes[i] = wish
                self.target[i] = len(self.target) + wish.robot

    def at_hand(self, position: Floats, walls: Floats) -> dict[int, Wish]:
        """The wishes that people can fulfill from where they stand, by person.

        Args:
            position: Of people and robots, shape (n, 2) [m].
            walls: As in `between`, shape (4, n_walls) [m].
        """
        if self._wishes and self._can_touch(position, self.target, walls, self._near):
            return {i: self._wishes[i] for i in self._near.nonzero()[0].tolist()}
        return {}

    def fulfill(self, i: int) -> None:
        """A person has touched; its mind learns of it when it next decides."""
        self.touched[i] = True
        self._drop(i)

    def _drop(self, i: int) -> None:
        self._wishes.pop(i, None)
        self.target[i] = NOBODY


@compiled
def _can_touch(
    position: Annotated[Floats, "n", 2],
    target: Annotated[Indices, "n_people"],
    walls: Annotated[Floats, 4, "n_walls"],
    near: Annotated[Mask, "n_people"],
) -> bool:
    """Finds out who can touch its target: within reach, with no wall in between.

    Args:
        position: Shape (n, 2) [m].
        target: Index of the body that each person is out to touch, or `NOBODY`, shape
            (n_people,).
        walls: As in `between`, shape (4, n_walls) [m].
        near: Set to who can, shape (n_people,).

    Returns:
        Whether anybody can.
    """
    if not within_reach(position, target, REACH, near):
        return False
    for i in range(len(target)):
        near[i] = near[i] and between(position, i, target[i], walls) == 0
    return bool(near.any())
